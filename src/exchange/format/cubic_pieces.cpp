#include "exchange/format/cubic_pieces.h"

#include <algorithm>

namespace blossom {
namespace {

using Cubic = std::array<Vec2, 4>;

/// What is not near its cubic after so many halvings never will be.
constexpr int maximumHalvings = 16;

/// Derivative of the point at either end of a piece, over its parameter.
Vec2 endDerivative(const BezierPiece& p, bool atStart) {
  const double degree = static_cast<double>(p.size() - 1);
  const Vec3 &here = atStart ? p.front() : p.back(), &next = atStart ? p[1] : p[p.size() - 2];
  return degree * next.z() / here.z() * (atStart ? 1 : -1) * (euclidean(next) - euclidean(here));
}

bool isNear(const BezierPiece& p, const Cubic& cubic, double tolerance) {
  constexpr int samples = 8;
  for (int i = 1; i < samples; ++i) {
    const double t = static_cast<double>(i) / samples, s = 1 - t;
    const Vec2 point = s * s * s * cubic[0] + 3 * s * s * t * cubic[1] + 3 * s * t * t * cubic[2] + t * t * t * cubic[3];
    if ((point - evaluate(p, t).point).norm() > 0.8 * tolerance) return false;
  }
  return true;
}

void addCubics(const BezierPiece& p, double tolerance, int halvings, std::vector<Cubic>& out) {
  const bool exact = p.size() <= 4 && isPolynomial(p);
  if (exact && p.size() == 4) {
    out.push_back({euclidean(p[0]), euclidean(p[1]), euclidean(p[2]), euclidean(p[3])});
    return;
  }
  const Vec2 a = euclidean(p.front()), d = euclidean(p.back());
  const Cubic cubic{a, a + endDerivative(p, true) / 3, d - endDerivative(p, false) / 3, d};
  if (exact || halvings >= maximumHalvings || isNear(p, cubic, tolerance)) {
    out.push_back(cubic);
    return;
  }
  const auto [left, right] = halves(p);
  addCubics(left, tolerance, halvings + 1, out);
  addCubics(right, tolerance, halvings + 1, out);
}

}  // namespace

bool isPolynomial(const BezierPiece& piece) {
  return std::all_of(piece.begin(), piece.end(), [&](const Vec3& pole) { return pole.z() == piece.front().z(); });
}

std::vector<std::array<Vec2, 4>> cubicsOf(const BezierPiece& piece, double tolerance) {
  std::vector<Cubic> cubics;
  addCubics(piece, tolerance, 0, cubics);
  return cubics;
}

}  // namespace blossom
