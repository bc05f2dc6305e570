#include <algorithm>

#include "core/error.h"
#include "geometry/bspline/bspline.h"
#include "geometry/tessellate/tessellate_parts.h"

namespace blossom {
namespace {

using Piece = std::vector<Vec4>;

Vec3 euclidean(const Vec4& pole) { return pole.head<3>() / pole.w(); }

/// By the convex hull property.
bool isFlat(const Piece& piece, double chord) {
  const Vec3 from = euclidean(piece.front());
  const Vec3 along = euclidean(piece.back()) - from;
  const double squared = along.squaredNorm();
  return std::all_of(piece.begin(), piece.end(), [&](const Vec4& pole) {
    if (pole.w() <= 0) return false;
    const Vec3 offset = euclidean(pole) - from;
    const double t = squared > 0 ? std::clamp(offset.dot(along) / squared, 0.0, 1.0) : 0;
    return (offset - t * along).squaredNorm() <= chord * chord;
  });
}

void halve(Piece piece, double chord, int depth, std::vector<Vec3>& points) {
  if (depth == 0 || isFlat(piece, chord)) {
    const Vec3 end = euclidean(piece.back());
    if (!end.allFinite())
      throw Error(ErrorCode::Degenerate, "The curve runs through infinity.", "Look for poles with the weight 0.");
    points.push_back(end);
    return;
  }
  Piece left(piece.size());
  for (std::size_t level = 0; level < piece.size(); ++level) {
    left[level] = piece[0];
    for (std::size_t i = 0; i + 1 < piece.size() - level; ++i) piece[i] = 0.5 * (piece[i] + piece[i + 1]);
  }
  halve(std::move(left), chord, depth - 1, points);
  halve(std::move(piece), chord, depth - 1, points);
}

}  // namespace

std::vector<Vec3> polyline(const Curve& curve, double chord) {
  constexpr int deepest = 16;
  const BezierCurve bezier = toBezier(curve);
  const auto order = static_cast<std::ptrdiff_t>(bezier.degree) + 1;
  std::vector<Vec3> points{euclidean(bezier.poles.front())};
  for (auto pole = bezier.poles.begin(); pole != bezier.poles.end(); pole += order)
    halve(Piece(pole, pole + order), chord, deepest, points);
  return points;
}

}  // namespace blossom
