#include "geometry/tessellate/iso_curves.h"

#include <Eigen/Geometry>
#include <algorithm>

#include "core/error.h"
#include "geometry/bspline/bspline.h"
#include "geometry/shape/bounds.h"
#include "geometry/tessellate/iso_curve_parts.h"
#include "geometry/tessellate/tessellate_parts.h"

namespace blossom {
namespace {

double distanceToChord(const Vec3& p, const Vec3& a, const Vec3& b) {
  const Vec3 along = b - a;
  const double square = along.squaredNorm();
  const double t = square > 0 ? std::clamp((p - a).dot(along) / square, 0.0, 1.0) : 0;
  return (p - a - t * along).norm();
}

struct ChordPiece {
  double a, b;
  Vec3 at, to;
};

/// Whether a side of a patch and the one across from it are the same curve.
bool sameCurve(const Curve& first, const Curve& last, double tolerance) {
  const auto [from, to] = first.domain();
  for (const double share : {0.0, 0.23, 0.5, 0.71, 1.0}) {
    const double t = from + share * (to - from);
    if ((point(first, t) - point(last, t)).norm() > tolerance) return false;
  }
  return true;
}

std::vector<IsoCurve> isoCurvesOfPatch(const Surface& surface, const IsoCurveOptions& options, const Progress& progress) {
  const auto [u0, u1] = surface.domainU();
  const auto [v0, v1] = surface.domainV();
  const bool closedU = sameCurve(isoU(surface, u0), isoU(surface, u1), options.chord);
  const bool closedV = sameCurve(isoV(surface, v0), isoV(surface, v1), options.chord);
  std::vector<IsoCurve> curves;
  for (const double u : isoParameters(u0, u1, options.count, closedU)) {
    progress.check();
    curves.push_back({polyline(isoU(surface, u), options.chord), 0, true, u});
  }
  for (const double v : isoParameters(v0, v1, options.count, closedV)) {
    progress.check();
    curves.push_back({polyline(isoV(surface, v), options.chord), 0, false, v});
  }
  return curves;
}

}  // namespace

std::vector<double> isoParameters(double from, double to, int count, bool closed) {
  std::vector<double> parameters;
  parameters.reserve(static_cast<std::size_t>(std::max(count, 0)));
  for (int k = 0; k < count; ++k)
    parameters.push_back(from + (to - from) * (closed ? (k + 0.5) / count : (k + 1.0) / (count + 1)));
  return parameters;
}

std::vector<Vec3> chordPolyline(const std::function<Vec3(double)>& curve, double a, double b, double chord) {
  constexpr int begun = 4, mostHalvings = 12;  // from few pieces on: a bend that begins and ends between quarters is seen
  std::vector<Vec3> points{curve(a)};
  for (int k = 0; k < begun; ++k) {
    const double from = a + (b - a) * k / begun, to = k + 1 == begun ? b : a + (b - a) * (k + 1) / begun;
    std::vector<ChordPiece> waiting{{from, to, points.back(), curve(to)}};
    const double shortest = (b - a) / begun / (1 << mostHalvings);
    while (!waiting.empty()) {
      const ChordPiece piece = waiting.back();
      waiting.pop_back();
      const double middle = (piece.a + piece.b) / 2;
      const Vec3 at = curve(middle);
      const double off = std::max({distanceToChord(at, piece.at, piece.to),
                                   distanceToChord(curve((piece.a + middle) / 2), piece.at, piece.to),
                                   distanceToChord(curve((middle + piece.b) / 2), piece.at, piece.to)});
      if (off <= chord || piece.b - piece.a <= shortest) {
        points.push_back(piece.to);
        continue;
      }
      waiting.push_back({middle, piece.b, at, piece.to});
      waiting.push_back({piece.a, middle, piece.at, at});
    }
  }
  return points;
}

std::vector<IsoCurve> isoCurves(const Shape& shape, const IsoCurveOptions& given, const Progress& progress) {
  if (given.count < 0 || !(given.chord >= 0))
    throw Error(ErrorCode::InvalidParameter, "The number of iso-curves and their chord must not be negative.");
  if (const auto* sequence = shape.get<Sequence>())
    return sequence->frames.empty() ? std::vector<IsoCurve>() : isoCurves(sequence->frames.back(), given, progress);
  IsoCurveOptions options = given;
  const double size = bounds(shape).diagonal();
  if (options.chord == 0) options.chord = size / 4000;
  options.chord = std::max({options.chord, 1e-9 * size, 1e-9});
  if (const auto* surface = shape.get<Surface>()) return isoCurvesOfPatch(*surface, options, progress);
  if (const auto* brep = shape.get<Brep>()) return isoCurvesOfFaces(*brep, options, progress);
  return {};
}

}  // namespace blossom
