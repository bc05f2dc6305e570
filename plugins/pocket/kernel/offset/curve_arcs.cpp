#include "kernel/offset/curve_arcs.h"

#include <algorithm>

namespace blossom::pocket {

namespace {

/// The parameters at which the pieces of each free-form curve begin, and the last one ends; in order.
std::vector<std::vector<double>> breaksOf(const Boundary& boundary) {
  std::vector<std::vector<double>> breaks(boundary.curves().size());
  for (const Piece& piece : boundary.pieces()) {
    const TrueCurve& curve = boundary.curves()[piece.curve];
    if (curve.line() || curve.arc()) continue;
    breaks[piece.curve].push_back(piece.t0);
    breaks[piece.curve].push_back(piece.t1);
  }
  for (auto& each : breaks) {
    std::sort(each.begin(), each.end());
    each.erase(std::unique(each.begin(), each.end()), each.end());
  }
  return breaks;
}

/// The joints of arcs through a curve. @param breaks parameters between which it leaves its chord by little
std::vector<ArcJoint> arcsThrough(const TrueCurve& curve, const std::vector<double>& breaks, double tolerance) {
  std::vector<double> parameters;
  for (std::size_t k = 0; k + 1 < breaks.size(); ++k)
    for (const double share : {0.0, 0.5}) parameters.push_back(breaks[k] + share * (breaks[k + 1] - breaks[k]));
  parameters.push_back(breaks.back());
  std::vector<TangentPoint> samples;
  for (const double t : parameters) {
    const TrueCurve::Place place = curve.placeAt(t);
    samples.push_back({place.point, place.tangent});
  }
  std::vector<ArcJoint> joints;
  for (const FitJoint& joint : fittedJoints(samples, tolerance)) {
    double t = parameters[joint.sample];
    if (!joint.isSample) {
      const double next = parameters[std::min(joint.sample + 1, parameters.size() - 1)];
      t = std::clamp(curve.foot(joint.place.at, (t + next) / 2, 0), t, next);
    }
    joints.push_back({t, joint.place});
  }
  return joints;
}

}  // namespace

CurveArcs::CurveArcs(const Boundary& boundary, double tolerance, const Progress& progress) {
  const auto breaks = breaksOf(boundary);
  starts_.push_back(0);
  for (std::size_t c = 0; c < breaks.size(); ++c) {
    progress.check();
    if (breaks[c].size() > 1) {
      const auto joints = arcsThrough(boundary.curves()[c], breaks[c], tolerance);
      joints_.insert(joints_.end(), joints.begin(), joints.end());
    }
    starts_.push_back(joints_.size());
  }
}

}  // namespace blossom::pocket
