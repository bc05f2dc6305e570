/// Corners of sums of convex polyhedra, against the hull of all pairs of corners; which surfaces are convex, against CGAL's
/// hull of their corners.
#include "core/stopwatch.h"
#include "morphology/kernel/convex/convex_sum.h"
#include "morphology/kernel/convex/convex_surface.h"
#include "morphology/kernel/convex/hull.h"
#include "support/morphology.h"
#include "support/support.h"

using namespace blossom;
using namespace blossom::test;
using namespace blossom::morphology;

namespace {

std::vector<Vec3> allSums(const Mesh& a, const Mesh& b) {
  std::vector<Vec3> sums;
  for (const Vec3& p : a.points)
    for (const Vec3& q : b.points) sums.push_back(p + q);
  return sums;
}

std::vector<Vec3> sumsAt(const Mesh& a, const Mesh& b, const std::vector<std::array<int, 2>>& pairs) {
  std::vector<Vec3> sums;
  for (const auto& [i, j] : pairs)
    sums.push_back(a.points[static_cast<std::size_t>(i)] + b.points[static_cast<std::size_t>(j)]);
  return sums;
}

/// Corners anywhere, on a sphere, of a box that is turned, of a box along the axes, of a pyramid, of a needle.
Mesh convexOfKind(std::mt19937_64& random, int kind) {
  std::normal_distribution<double> any(0, 1);
  const auto place = [&] { return Vec3(any(random), any(random), any(random)); };
  std::vector<Vec3> points;
  const int count = std::uniform_int_distribution<int>(5, 60)(random);
  for (int k = 0; k < count; ++k) {
    Vec3 p = place();
    if (kind % 3 == 1) p.normalize();
    if (kind % 6 == 5) p.x() *= 1e-3;
    points.push_back(p);
  }
  if (kind % 6 == 2) points = cuboid({-1, -2, -0.5}, {1, 0.5, 3}).points;
  if (kind % 6 == 3) points = turnedBy(cuboid({-1, -2, -0.5}, {1, 0.5, 3}), randomTurn(random)).points;
  if (kind % 6 == 4) points = prism({{0, 0}, {2, 0}, {3, 1}, {1, 3}}, 0, 1 + std::abs(any(random))).points;
  return hullTriangles(points);
}

using PlacedTriangle = std::array<std::array<double, 3>, 3>;

/// By the places of their corners, each from its lowest on.
std::vector<PlacedTriangle> sortedTriangles(const Mesh& mesh) {
  std::vector<PlacedTriangle> triangles;
  for (std::size_t f = 0; f < mesh.faceCount(); ++f) {
    PlacedTriangle t;
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3& p = mesh.points[static_cast<std::size_t>(mesh.face(f)[k])];
      t[k] = {p.x(), p.y(), p.z()};
    }
    std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
    triangles.push_back(t);
  }
  std::sort(triangles.begin(), triangles.end());
  return triangles;
}

/// A point moved, an edge turned to the other diagonal, a face turned round, moved to other corners, lost or doubled; or
/// nothing.
void spoil(Mesh& mesh, std::mt19937_64& random) {
  const auto below = [&](std::size_t n) { return std::uniform_int_distribution<std::size_t>(0, n - 1)(random); };
  const std::size_t f = below(mesh.faceCount());
  int* const face = mesh.faceVertices.data() + 3 * f;
  switch (below(7)) {
    case 0:
      mesh.points[below(mesh.points.size())] *= std::uniform_real_distribution<double>(0.9, 1.1)(random);
      break;
    case 1:
      for (std::size_t g = 0; g < mesh.faceCount(); ++g) {
        int* const other = mesh.faceVertices.data() + 3 * g;
        for (std::size_t k = 0; k < 3; ++k) {
          if (other[k] != face[1] || other[(k + 1) % 3] != face[0]) continue;
          const int beyond = other[(k + 2) % 3];
          other[(k + 1) % 3] = face[2];
          face[1] = beyond;
          return;
        }
      }
      break;
    case 2:
      std::swap(face[0], face[1]);
      break;
    case 3:
      face[0] = static_cast<int>(below(mesh.points.size()));
      break;
    case 4:
      mesh.faceVertices.resize(mesh.faceVertices.size() - 3);
      mesh.faceStarts.pop_back();
      break;
    case 5:
      mesh.addFace(std::vector<int>(face, face + 3));
      break;
    default:
      break;
  }
}

/// Over a star polygon that goes round twice: each edge of it is convex.
Mesh twiceAround(int corners, int turns) {
  Mesh mesh;
  for (int k = 0; k < corners; ++k) {
    const double angle = 2 * std::numbers::pi * turns * k / corners;
    mesh.points.emplace_back(std::cos(angle), std::sin(angle), 0);
  }
  mesh.points.emplace_back(0, 0, 1);
  mesh.points.emplace_back(0, 0, -1);
  for (int k = 0; k < corners; ++k) {
    const int next = (k + 1) % corners;
    mesh.addFace(std::vector<int>{k, next, corners});
    mesh.addFace(std::vector<int>{next, k, corners + 1});
  }
  return mesh;
}

}  // namespace

class MorphologyConvexTest : public QObject {
  Q_OBJECT

 private slots:
  void theirHullIsThatOfAllSums() {
    std::mt19937_64 random = seededRandom();
    for (int round = 0; round < 200; ++round) {
      const Mesh a = convexOfKind(random, round), b = convexOfKind(random, round / 6);
      const auto pairs = cornersOfSum(a, b);
      const std::vector<Vec3> corners = sumsAt(a, b, pairs);
      const Mesh whole = hullTriangles(allSums(a, b)), found = hullTriangles(corners);
      COMPARE_NEAR(volumeOf(found), volumeOf(whole), 1e-10 * volumeOf(whole));
      COMPARE_NEAR(area(found), area(whole), 1e-10 * area(whole));
      QVERIFY(pairs.size() <= a.points.size() * b.points.size());
    }
  }

  /// In general position each corner is a pair, and each pair a corner.
  void noPairIsTooMany() {
    std::mt19937_64 random = seededRandom();
    for (int round = 0; round < 60; ++round) {
      const Mesh a = convexOfKind(random, 1), b = convexOfKind(random, 6 * round);
      QCOMPARE(cornersOfSum(a, b).size(), hullTriangles(allSums(a, b)).points.size());
    }
  }

  /// All faces are parallel to faces of the other one.
  void ballsOfTheSameDirectionsAreABall() {
    for (const int fine : {1, 2, 3}) {
      const Mesh a = ballOf(5, fine), b = ballOf(2, fine);
      QCOMPARE(cornersOfSum(a, b).size(), a.points.size());
      const Mesh sum = solidSumOf(a, b);
      COMPARE_NEAR(volumeOf(sum), std::pow(7.0 / 5, 3) * volumeOf(a), 1e-11 * volumeOf(sum));
      QCOMPARE(sum.points.size(), a.points.size());
    }
  }

  /// In general position a surface is convex exactly if it is the hull of its corners.
  void surfacesAreConvexAsTheirHulls() {
    std::mt19937_64 random = seededRandom();
    int convex = 0, others = 0;
    for (int round = 0; round < 1500; ++round) {
      Mesh mesh = convexOfKind(random, round % 2);
      spoil(mesh, random);
      const bool isHull = sortedTriangles(mesh) == sortedTriangles(hullTriangles(mesh.points));
      QCOMPARE(isConvexSurface(mesh), isHull);
      ++(isHull ? convex : others);
    }
    QVERIFY(convex > 200 && others > 600);
  }

  void facesInOnePlaneMayBeCutInAnyWay() {
    const Mesh box = hullTriangles(cuboid({-1, -2, -0.5}, {1, 0.5, 3}).points);
    QVERIFY(isConvexSurface(box));
    for (std::size_t f = 0; f < box.faceCount(); ++f) {
      const std::vector<Vec3> at = facePoints(box, f);
      const Vec3 middle = (2 * at[0] + at[1] + at[2]) / 4;  // exact, in the plane, off the diagonals
      Mesh pyramid = box;                                   // its corner lies in the face, where it is none, then below it
      const auto corner = static_cast<int>(pyramid.points.size());
      pyramid.points.push_back(middle);
      int* const face = pyramid.faceVertices.data() + 3 * f;
      const std::array<int, 3> old{face[0], face[1], face[2]};
      face[2] = corner;
      pyramid.addFace(std::vector<int>{old[1], old[2], corner});
      pyramid.addFace(std::vector<int>{old[2], old[0], corner});
      QVERIFY(!isConvexSurface(pyramid));
      pyramid.points.back() = middle - 1e-9 * vectorArea(at);
      QVERIFY(!isConvexSurface(pyramid));
      pyramid.points.back() = middle + 1e-9 * vectorArea(at);  // its face has another half, in the old plane
      QVERIFY(!isConvexSurface(pyramid));
    }
    for (const int corners : {6, 64, 500}) {
      std::vector<Vec3> rim;
      for (int k = 0; k < corners; ++k)
        for (const double z : {0.0, 1.0})
          rim.emplace_back(std::cos(2 * std::numbers::pi * k / corners), std::sin(2 * std::numbers::pi * k / corners), z);
      QVERIFY(isConvexSurface(hullTriangles(rim)));
    }
  }

  /// Whichever face comes first, slivers whose middle lies beside them in doubles, too.
  void surfacesAreConvexWithAnyFaceFirst() {
    std::mt19937_64 random = seededRandom();
    std::uniform_real_distribution<double> any(-3e4, 3e4);
    for (int round = 0; round < 40; ++round) {
      const Vec3 a(any(random), any(random), any(random)), b(any(random), any(random), any(random));
      std::vector<Vec3> points{a, b, a + 0.25 * (b - a), a + 0.5 * (b - a)};  // in a line, but for rounding
      for (int k = 0; k < 9; ++k) points.emplace_back(any(random), any(random), any(random));
      const Mesh hull = hullTriangles(points);
      for (std::size_t first = 0; first < hull.faceCount(); ++first) {
        Mesh turned;
        turned.points = hull.points;
        for (std::size_t f = 0; f < hull.faceCount(); ++f) turned.addFace(hull.face((first + f) % hull.faceCount()));
        QVERIFY(isConvexSurface(turned));
      }
    }
  }

  void whatGoesRoundTwiceIsNotConvex() {
    QVERIFY(isConvexSurface(twiceAround(5, 1)));
    for (const int corners : {5, 7, 9, 101}) QVERIFY(!isConvexSurface(twiceAround(corners, 2)));
    QVERIFY(!isConvexSurface(twiceAround(7, 3)));
    Mesh two = ballOf(1, 1);  // one in the other
    const Mesh other = ballOf(2, 1);
    const auto first = static_cast<int>(two.points.size());
    two.points.insert(two.points.end(), other.points.begin(), other.points.end());
    for (std::size_t f = 0; f < other.faceCount(); ++f)
      two.addFace(std::vector<int>{first + other.face(f)[0], first + other.face(f)[1], first + other.face(f)[2]});
    QVERIFY(!isConvexSurface(two));
    QVERIFY(!isConvexSurface(Mesh()));
  }

  void fineBallsAreAdded() {
    const Mesh a = ballOf(5, 4), b = ballOf(2, 4);
    Stopwatch watch;
    const Mesh sum = solidSumOf(a, b);
    qInfo("figure balls_ms %.3g", watch.lapMs());
    COMPARE_NEAR(volumeOf(sum), std::pow(7.0 / 5, 3) * volumeOf(a), 1e-11 * volumeOf(sum));
    const Mesh finest = solidSumOf(
        ballOf(5, 6), turnedBy(ballOf(2, 3), Eigen::AngleAxisd(0.3, Vec3(1, 2, 3).normalized()).toRotationMatrix()));
    QVERIFY(volumeOf(finest) > 0.99 * 4.0 / 3 * std::numbers::pi * 343);
    QVERIFY(volumeOf(finest) < 4.0 / 3 * std::numbers::pi * 343);
    qInfo("figure fine_balls_ms %.3g", watch.lapMs());
  }
};

BLOSSOM_TEST(MorphologyConvexTest)
#include "morphology_convex_test.moc"
