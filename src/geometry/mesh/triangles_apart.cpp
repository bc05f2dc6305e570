#include "geometry/mesh/triangles_apart.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>

namespace blossom {
namespace {

/// More than the rounding of a scalar or triple product of differences of places, and of what underflows in it. Errors are
/// products of the same factors in the same order, so that they overflow where heights do, and compare as false.
constexpr double roundingOfProducts = 1e-14, underflowOfProducts = 1e-290;
/// Of the lengths of two sides: parts of smaller normals may have underflowed.
constexpr double smallestProduct = 1e-250;

/// Above a plane with some normal.
struct Heights {
  double low = 0, high = 0;

  template <std::size_t count>
  Heights(const Vec3& normal, const std::array<Vec3, count>& places) {
    low = high = normal.dot(places[0]);
    for (std::size_t k = 1; k < count; ++k) {
      const double height = normal.dot(places[k]);
      low = std::min(low, height);
      high = std::max(high, height);
    }
  }
};

double largest(const Vec3& p) { return p.lpNorm<Eigen::Infinity>(); }

/// @param reach no coordinate is larger
bool isBetween(const Vec3& normal, const Triangle3& a, const Triangle3& b, double reach) {
  const double error = roundingOfProducts * (normal.lpNorm<1>() * reach) + underflowOfProducts;
  const Heights ofA(normal, a), ofB(normal, b);
  return ofA.low - ofB.high > error || ofB.low - ofA.high > error;
}

using Sides = std::array<Vec3, 2>;  // from a corner

Sides sidesFrom(const Triangle3& t, std::size_t corner) {
  return {t[(corner + 1) % 3] - t[corner], t[(corner + 2) % 3] - t[corner]};
}

/// Whether all of b lies on one side of a plane through the common corner, and nothing of a does.
bool isBetween(const Vec3& normal, const Sides& a, const Sides& b, double reach) {
  const double error = roundingOfProducts * (normal.lpNorm<1>() * reach) + underflowOfProducts;
  const Heights ofA(normal, a), ofB(normal, b);
  return (ofA.low > error && ofB.high < -error) || (ofB.low > error && ofA.high < -error);
}

/// Whether `b` lies on one side of the plane of `a`, farther off than `a` itself may be of the plane with the rounded
/// normal.
bool isAside(const Sides& a, const Sides& b, double reach) {
  const Vec3 normal = a[0].cross(a[1]);
  const double size = largest(a[0]) * largest(a[1]);
  if (size < smallestProduct) return false;
  const double error = roundingOfProducts * ((normal.lpNorm<1>() + 3 * size) * reach) + underflowOfProducts;
  const Heights heights(normal, b);
  return heights.low > error || heights.high < -error;
}

}  // namespace

bool areApart(const Triangle3& a, const Triangle3& b) {
  Triangle3 fromA, fromB;  // from a corner, so that errors are those of differences
  double reach = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    fromA[k] = a[k] - a[0];
    fromB[k] = b[k] - a[0];
    reach = std::max({reach, largest(fromA[k]), largest(fromB[k])});
  }
  for (const Triangle3* t : {&fromA, &fromB}) {
    const Vec3 normal = ((*t)[1] - (*t)[0]).cross((*t)[2] - (*t)[0]);
    if (isBetween(normal, fromA, fromB, reach)) return true;
    for (std::size_t k = 0; k < 3; ++k)
      if (isBetween(normal.cross((*t)[(k + 1) % 3] - (*t)[k]), fromA, fromB, reach)) return true;
  }
  return false;
}

bool areApartBeyondCorner(const Triangle3& a, const Triangle3& b, std::size_t cornerOfA, std::size_t cornerOfB) {
  const Sides ofA = sidesFrom(a, cornerOfA), ofB = sidesFrom(b, cornerOfB);
  const double reach = std::max({largest(ofA[0]), largest(ofA[1]), largest(ofB[0]), largest(ofB[1])});
  const Vec3 normal = ofA[0].cross(ofA[1]);
  if (isAside(ofA, ofB, reach) || isAside(ofB, ofA, reach)) return true;
  for (const Vec3& u : ofA)
    for (const Vec3& v : ofB)
      if (isBetween(normal.cross(u.normalized() + v.normalized()), ofA, ofB, reach)) return true;
  return false;
}

bool lieAcross(const Vec3& p, const Vec3& q, const Vec3& x, const Vec3& y) {
  const Vec3 along = q - p, u = x - p, v = y - p;
  const double ofX = largest(along) * largest(u), ofY = largest(along) * largest(v), size = ofX * ofY;
  if (std::min(ofX, ofY) < smallestProduct) return false;
  return along.cross(u).dot(along.cross(v)) < -100 * roundingOfProducts * size - underflowOfProducts;
}

}  // namespace blossom
