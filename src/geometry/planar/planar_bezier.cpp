#include "geometry/planar/planar_bezier.h"

#include "geometry/bspline/bspline.h"
#include "geometry/planar/planar.h"

namespace blossom {

std::vector<BezierPiece> bezierPieces(const Spline2& spline) {
  const BezierCurve bezier = toBezier(toCurve(spline));
  const auto order = static_cast<std::size_t>(bezier.degree) + 1;
  std::vector<BezierPiece> pieces(bezier.poles.size() / order, BezierPiece(order));
  for (std::size_t i = 0; i < bezier.poles.size(); ++i) {
    const Vec4& pole = bezier.poles[i];
    pieces[i / order][i % order] = {pole.x(), pole.y(), pole.w()};
  }
  return pieces;
}

PointAndTangent evaluate(const BezierPiece& piece, double t) {
  BezierPiece work = piece;
  const std::size_t degree = piece.size() - 1;
  if (degree == 0) return {euclidean(work[0]), Vec2::Zero()};
  for (std::size_t level = degree; level > 1; --level)
    for (std::size_t i = 0; i < level; ++i) work[i] += t * (work[i + 1] - work[i]);
  const Vec3 derivative = static_cast<double>(degree) * (work[1] - work[0]);
  const Vec3 value = work[0] + t * (work[1] - work[0]);
  const Vec2 point = euclidean(value);
  return {point, (derivative.head<2>() - derivative.z() * point) / value.z()};
}

std::pair<BezierPiece, BezierPiece> halves(const BezierPiece& piece) {
  BezierPiece left(piece.size());
  BezierPiece right = piece;
  for (std::size_t level = 0; level < piece.size(); ++level) {
    left[level] = right[0];
    for (std::size_t i = 0; i + 1 < piece.size() - level; ++i) right[i] = 0.5 * (right[i] + right[i + 1]);
  }
  return {std::move(left), std::move(right)};
}

}  // namespace blossom
