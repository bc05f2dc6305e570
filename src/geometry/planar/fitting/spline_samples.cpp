#include "geometry/planar/fitting/spline_samples.h"

#include <algorithm>
#include <cmath>

#include "geometry/planar/angles.h"
#include "geometry/planar/planar_bezier.h"

namespace blossom::planar {
namespace {

double sizeOf(const BezierPiece& piece) {
  double size = 0;
  for (const Vec3& pole : piece) size = std::max(size, (euclidean(pole) - euclidean(piece.front())).norm());
  return size;
}

/// Positive where a piece of positive weights turns left: de Casteljau's last three points turn as the curve does.
double bendAt(const BezierPiece& piece, double t) {
  if (piece.size() < 3) return 0;
  BezierPiece work = piece;
  for (std::size_t level = piece.size() - 1; level > 2; --level)
    for (std::size_t i = 0; i < level; ++i) work[i] += t * (work[i + 1] - work[i]);
  return work[0].dot(work[1].cross(work[2]));
}

/// Parameters inside of a piece at which it begins to turn the other way.
std::vector<double> inflectionsOf(const BezierPiece& piece) {
  constexpr int places = 32, halvings = 40;
  std::vector<double> found;
  double before = 0, beforeAt = 0;
  for (int k = 0; k <= places; ++k) {
    const double at = static_cast<double>(k) / places, bend = bendAt(piece, at);
    if (bend == 0) continue;
    if (before * bend < 0) {
      double from = beforeAt, to = at;
      for (int i = 0; i < halvings; ++i) {
        const double middle = (from + to) / 2;
        (bendAt(piece, middle) * before > 0 ? from : to) = middle;
      }
      found.push_back((from + to) / 2);
    }
    before = bend, beforeAt = at;
  }
  return found;
}

/// One rational Bézier piece and where its points lie.
class PieceSampler {
 public:
  PieceSampler(const BezierPiece& piece, double tolerance, const std::vector<double>& normals)
      : piece_(piece), size_(sizeOf(piece)), tolerance_(tolerance), normals_(normals) {}

  [[nodiscard]] bool hasExtent() const { return size_ > 0; }

  /// Adds the samples after the start. An inflection is one, for along a chord across it the normal turns there and back.
  void run(std::vector<CurveSample>& out) const {
    constexpr int deepest = 20;
    std::vector<double> ends = inflectionsOf(piece_);
    ends.push_back(1);
    double from = 0;
    for (const double to : ends) {
      halve(from, to, sampleAt(from), sampleAt(to), deepest, out);
      from = to;
    }
  }

  [[nodiscard]] CurveSample sampleAt(double t) const {
    const auto [point, derivative] = evaluate(piece_, t);
    Vec2 along = derivative;
    if (along.norm() <= 1e-9 * size_) {  // at the end of a piece whose poles coincide
      constexpr double step = 1e-4;
      along = t < 0.5 ? Vec2(evaluate(piece_, t + step).point - point) : Vec2(point - evaluate(piece_, t - step).point);
    }
    return {point, std::atan2(-along.x(), along.y())};
  }

 private:
  void halve(double from, double to, const CurveSample& first, const CurveSample& last, int depth,
             std::vector<CurveSample>& out) const {
    if (depth == 0 || isFlat(from, to, first, last)) {
      addBetween(from, to, first, last, out);
      out.push_back(last);
      return;
    }
    const double middle = (from + to) / 2;
    const CurveSample between = sampleAt(middle);
    halve(from, middle, first, between, depth - 1, out);
    halve(middle, to, between, last, depth - 1, out);
  }

  /// Within the tolerance beside the chord and, as what is made of it takes it for one, beside an arc that turns as much.
  [[nodiscard]] bool isFlat(double from, double to, const CurveSample& first, const CurveSample& last) const {
    constexpr double littleTurn = 0.4;  // radians
    const double turn = turnFrom(first.normal, last.normal);
    if (std::abs(turn) > littleTurn) return false;
    const Vec2 chord = last.at - first.at;
    const double reach = chord.norm();
    for (const double share : {0.25, 0.5, 0.75}) {
      const CurveSample between = sampleAt(from + share * (to - from));
      if (std::abs(turnFrom(first.normal, between.normal)) > littleTurn) return false;
      const Vec2 offset = between.at - first.at;
      if (!(reach > 0)) {
        if (offset.norm() > tolerance_) return false;
        continue;
      }
      const double outwards = -cross(chord, offset) / reach, along = chord.dot(offset) / (reach * reach);
      const double ofArc = reach * turn / 2 * along * (1 - along);
      if (std::abs(outwards) > tolerance_ || std::abs(outwards - ofArc) > tolerance_) return false;
    }
    return true;
  }

  /// The points with one of the normals, in their order.
  void addBetween(double from, double to, const CurveSample& first, const CurveSample& last,
                  std::vector<CurveSample>& out) const {
    const double turn = turnFrom(first.normal, last.normal);
    std::vector<double> turns;
    const double low = std::min(0.0, turn), high = std::max(0.0, turn), start = inOneTurn(first.normal);
    for (const double whole : {-fullTurn, 0.0, fullTurn}) {
      const auto begin = std::upper_bound(normals_.begin(), normals_.end(), start + low + sameAngle + whole);
      for (auto it = begin; it != normals_.end() && *it < start + high - sameAngle + whole; ++it)
        turns.push_back(*it - whole - start);
    }
    std::sort(turns.begin(), turns.end(), [turn](double a, double b) { return turn > 0 ? a < b : a > b; });
    for (const double each : turns) out.push_back(sampleWithTurn(from, to, first.normal, each, turn > 0));
  }

  /// By halving: the normal turns from that of `first` by less than a right angle.
  [[nodiscard]] CurveSample sampleWithTurn(double from, double to, double first, double turn, bool left) const {
    constexpr int halvings = 50;
    for (int i = 0; i < halvings; ++i) {
      const double middle = (from + to) / 2;
      const bool before = (turnFrom(first, sampleAt(middle).normal) < turn) == left;
      (before ? from : to) = middle;
    }
    CurveSample sample = sampleAt((from + to) / 2);
    sample.normal = first + turn;
    return sample;
  }

  const BezierPiece& piece_;
  double size_, tolerance_;
  const std::vector<double>& normals_;
};

/// Whether a curve bends between two parts that meet, so that one smooth curve would leave them by more than the tolerance:
/// files with few digits bend smooth curves by less.
bool bends(const std::vector<CurveSample>& part, const std::vector<CurveSample>& next, double tolerance) {
  constexpr double much = 0.1;  // radians
  const double turn = std::abs(turnFrom(part.back().normal, next.front().normal));
  const double longest = std::max((part.back().at - part.end()[-2].at).norm(), (next[1].at - next.front().at).norm());
  return turn > much || turn * longest > tolerance;
}

/// A closed curve with a kink where it begins would go on there, were it one.
void cutAtSeam(std::vector<std::vector<CurveSample>>& parts, double tolerance) {
  if (parts.size() != 1) return;
  std::vector<CurveSample>& whole = parts.front();
  if (whole.size() < 3) return;  // a short curve, not a closed one
  if ((whole.back().at - whole.front().at).norm() > tolerance || !bends(whole, whole, tolerance)) return;
  const auto middle = whole.begin() + static_cast<std::ptrdiff_t>(whole.size() / 2);
  std::vector<CurveSample> rest(middle, whole.end());
  whole.erase(middle + 1, whole.end());
  parts.push_back(std::move(rest));
}

}  // namespace

std::vector<std::vector<CurveSample>> samplesOf(const Spline2& spline, double tolerance,
                                                const std::vector<double>& normals) {
  std::vector<std::vector<CurveSample>> parts;
  for (const BezierPiece& piece : bezierPieces(spline)) {
    const PieceSampler sampler(piece, tolerance, normals);
    if (!sampler.hasExtent()) continue;
    std::vector<CurveSample> next{sampler.sampleAt(0)};
    sampler.run(next);
    if (parts.empty() || bends(parts.back(), next, tolerance))
      parts.push_back(std::move(next));
    else
      parts.back().insert(parts.back().end(), next.begin() + 1, next.end());
  }
  cutAtSeam(parts, tolerance);
  return parts;
}

}  // namespace blossom::planar
