#include "exchange/format/bezier_pieces.h"

#include <algorithm>
#include <utility>

#include "geometry/bspline/bspline.h"

namespace blossom {
namespace {

using Cubic = std::array<Vec2, 4>;

/// What is not near its cubic after so many halvings never will be.
constexpr int mostHalvings = 16;

std::pair<BezierPiece, BezierPiece> halved(BezierPiece poles) {
  const std::size_t n = poles.size();
  BezierPiece left, right(n);
  for (std::size_t level = 0; level < n; ++level) {
    left.push_back(poles.front());
    right[n - 1 - level] = poles[n - 1 - level];
    for (std::size_t i = 0; i + 1 + level < n; ++i) poles[i] = 0.5 * (poles[i] + poles[i + 1]);
  }
  return {left, right};
}

Vec2 pointOf(BezierPiece poles, double t) {
  for (std::size_t n = poles.size() - 1; n > 0; --n)
    for (std::size_t i = 0; i < n; ++i) poles[i] = (1 - t) * poles[i] + t * poles[i + 1];
  return toPlane(poles[0]);
}

/// Derivative of the point at either end of a piece, over its parameter.
Vec2 endDerivative(const BezierPiece& p, bool atStart) {
  const double degree = static_cast<double>(p.size() - 1);
  const Vec3 &here = atStart ? p.front() : p.back(), &next = atStart ? p[1] : p[p.size() - 2];
  return degree * next.z() / here.z() * (atStart ? 1 : -1) * (toPlane(next) - toPlane(here));
}

bool isNear(const BezierPiece& p, const Cubic& cubic, double tolerance) {
  constexpr int samples = 8;
  for (int i = 1; i < samples; ++i) {
    const double t = static_cast<double>(i) / samples, s = 1 - t;
    const Vec2 point = s * s * s * cubic[0] + 3 * s * s * t * cubic[1] + 3 * s * t * t * cubic[2] + t * t * t * cubic[3];
    if ((point - pointOf(p, t)).norm() > 0.8 * tolerance) return false;
  }
  return true;
}

void addCubics(const BezierPiece& p, double tolerance, int halvings, std::vector<Cubic>& out) {
  const bool exact = p.size() <= 4 && isPolynomial(p);
  if (exact && p.size() == 4) {
    out.push_back({toPlane(p[0]), toPlane(p[1]), toPlane(p[2]), toPlane(p[3])});
    return;
  }
  const Vec2 a = toPlane(p.front()), d = toPlane(p.back());
  const Cubic cubic{a, a + endDerivative(p, true) / 3, d - endDerivative(p, false) / 3, d};
  if (exact || halvings >= mostHalvings || isNear(p, cubic, tolerance)) {
    out.push_back(cubic);
    return;
  }
  const auto [left, right] = halved(p);
  addCubics(left, tolerance, halvings + 1, out);
  addCubics(right, tolerance, halvings + 1, out);
}

}  // namespace

std::vector<BezierPiece> bezierPieces(const Spline2& spline) {
  const BezierCurve bezier = toBezier(toCurve(spline));
  const std::size_t size = static_cast<std::size_t>(bezier.degree) + 1;
  std::vector<BezierPiece> pieces;
  for (std::size_t first = 0; first + size <= bezier.poles.size(); first += size) {
    BezierPiece& piece = pieces.emplace_back();
    for (std::size_t i = 0; i < size; ++i) {
      const Vec4& pole = bezier.poles[first + i];
      piece.emplace_back(pole.x(), pole.y(), pole.w());
    }
  }
  return pieces;
}

bool isPolynomial(const BezierPiece& piece) {
  return std::all_of(piece.begin(), piece.end(), [&](const Vec3& pole) { return pole.z() == piece.front().z(); });
}

std::vector<std::array<Vec2, 4>> cubicsOf(const BezierPiece& piece, double tolerance) {
  std::vector<Cubic> cubics;
  addCubics(piece, tolerance, 0, cubics);
  return cubics;
}

}  // namespace blossom
