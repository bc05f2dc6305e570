#include <boost/multiprecision/cpp_int.hpp>
#include <optional>

#include "geometry/mesh/mesh_crossing.h"
#include "geometry/mesh/triangle_distance.h"
#include "support/polyhedra.h"
#include "support/solids.h"
#include "support/support.h"

using namespace blossom;
using namespace blossom::test;

namespace {

using Rational = boost::multiprecision::cpp_rational;

/// A point in rational numbers.
struct Exact {
  Rational x, y, z;
  friend bool operator==(const Exact&, const Exact&) = default;
  friend Exact operator-(const Exact& a, const Exact& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
};
Exact toExact(const Vec3& p) { return {Rational(p.x()), Rational(p.y()), Rational(p.z())}; }
Rational dot(const Exact& a, const Exact& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
Exact cross(const Exact& a, const Exact& b) { return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x}; }
bool isZero(const Exact& v) { return v == Exact{0, 0, 0}; }

/// The part of a convex polygon where normal . (p - origin) >= 0.
std::vector<Exact> clipped(const std::vector<Exact>& polygon, const Exact& normal, const Exact& origin) {
  std::vector<Exact> kept;
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const Exact &p = polygon[k], &q = polygon[(k + 1) % polygon.size()];
    const Rational here = dot(normal, p - origin), next = dot(normal, q - origin);
    if (here >= 0) kept.push_back(p);
    if ((here > 0 && next < 0) || (here < 0 && next > 0)) {
      const Rational s = here / (here - next);
      kept.push_back({p.x + s * (q.x - p.x), p.y + s * (q.y - p.y), p.z + s * (q.z - p.z)});
    }
  }
  return kept;
}

using ExactTriangle = std::array<Exact, 3>;

/// Corners of what two triangles have in common.
std::vector<Exact> common(const ExactTriangle& a, const ExactTriangle& b) {
  const Exact normal = cross(b[1] - b[0], b[2] - b[0]);
  std::vector<Exact> left = clipped({a.begin(), a.end()}, normal, b[0]);
  left = clipped(left, {-normal.x, -normal.y, -normal.z}, b[0]);
  for (std::size_t k = 0; k < 3; ++k) left = clipped(left, cross(normal, b[(k + 1) % 3] - b[k]), b[k]);
  return left;
}

/// Whether p lies in the hull of up to two points.
bool inShared(const Exact& p, const std::vector<Exact>& shared) {
  if (shared.empty()) return false;
  if (shared.size() == 1) return p == shared[0];
  const Exact along = shared[1] - shared[0], here = p - shared[0];
  const Rational s = dot(along, here);
  return isZero(cross(along, here)) && s >= 0 && s <= dot(along, along);
}

bool crossByRationals(const ExactTriangle& a, const ExactTriangle& b) {
  std::vector<Exact> shared;
  for (const Exact& p : a)
    if (std::find(b.begin(), b.end(), p) != b.end()) shared.push_back(p);
  if (shared.size() == 3) return true;
  const std::vector<Exact> meeting = common(a, b);
  return !std::all_of(meeting.begin(), meeting.end(), [&](const Exact& p) { return inShared(p, shared); });
}

using Pair = std::pair<std::size_t, std::size_t>;

/// Every pair against every other.
std::optional<Pair> firstByRationals(const Mesh& triangles) {
  std::vector<ExactTriangle> exact;
  std::vector<std::size_t> faces;
  for (std::size_t f = 0; f < triangles.faceCount(); ++f) {
    const auto at = facePoints(triangles, f);
    const ExactTriangle t{toExact(at[0]), toExact(at[1]), toExact(at[2])};
    if (isZero(cross(t[1] - t[0], t[2] - t[0]))) continue;
    exact.push_back(t);
    faces.push_back(f);
  }
  for (std::size_t i = 0; i < exact.size(); ++i)
    for (std::size_t j = i + 1; j < exact.size(); ++j)
      if (crossByRationals(exact[i], exact[j])) return Pair{faces[i], faces[j]};
  return std::nullopt;
}

double distanceToFace(const Mesh& triangles, std::size_t face, const Vec3& p) {
  const auto at = facePoints(triangles, face);
  return (closestOnTriangle(p, {at[0], at[1], at[2]}) - p).norm();
}

void compareWithRationals(const Mesh& triangles) {
  const auto expected = firstByRationals(triangles);
  const auto found = firstCrossing(triangles);
  QCOMPARE(found.has_value(), expected.has_value());
  if (!found) return;
  QCOMPARE(found->first, expected->first);
  QCOMPARE(found->second, expected->second);
  QVERIFY(distanceToFace(triangles, found->first, found->place) < 1e-9);
  QVERIFY(distanceToFace(triangles, found->second, found->place) < 1e-9);
}

/// Triangles over few points of a coarse lattice: corners on faces, edges on edges and faces in one plane are common.
Mesh latticeSoup(std::mt19937_64& random, int lattice, int points, int faces) {
  std::uniform_int_distribution<int> place(0, lattice), vertex(0, points - 1);
  Mesh mesh;
  for (int k = 0; k < points; ++k) mesh.points.emplace_back(place(random), place(random), place(random));
  for (int k = 0; k < faces; ++k) mesh.addFace(std::array{vertex(random), vertex(random), vertex(random)});
  return mesh;
}

/// A grid of heights, nowhere crossing itself, with a few corners moved sideways and down afterwards.
Mesh crumpledGrid(std::mt19937_64& random, int side, int moves) {
  std::uniform_real_distribution<double> height(0, 0.5), aside(-1.2, 1.2);
  std::uniform_int_distribution<int> any(0, (side + 1) * (side + 1) - 1);
  Mesh mesh;
  for (int i = 0; i <= side; ++i)
    for (int j = 0; j <= side; ++j) mesh.points.emplace_back(i, j, height(random));
  const auto at = [&](int i, int j) { return i * (side + 1) + j; };
  for (int i = 0; i < side; ++i)
    for (int j = 0; j < side; ++j) {
      mesh.addFace(std::array{at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      mesh.addFace(std::array{at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  for (int k = 0; k < moves; ++k)
    mesh.points[static_cast<std::size_t>(any(random))] += Vec3(aside(random), aside(random), aside(random));
  return mesh;
}

double ofAnySize(std::mt19937_64& random) {
  std::uniform_real_distribution<double> unit(-1, 1);
  return unit(random) * std::pow(10, 8 * unit(random));
}

/// Two triangles with no corner, one or two in common: flat ones, needles, one in the plane of the other but for the last
/// bits of its corners, near the origin and far away.
Mesh trianglesNearEachOther(std::mt19937_64& random) {
  std::uniform_real_distribution<double> unit(-1, 1);
  const auto place = [&] { return Vec3(unit(random), unit(random), unit(random)); };
  const Vec3 origin = 10 * place(), x = place(), y = place(), thin = y * std::abs(ofAnySize(random)) * 1e-8;
  const Vec3 far = unit(random) > 0 ? Vec3::Zero() : Vec3(place() * 1e6);
  const int shared = static_cast<int>(3 * std::abs(unit(random)));
  Mesh mesh;
  for (int k = 0; k < 6 - shared; ++k)
    mesh.points.push_back(origin + far + unit(random) * x + unit(random) * (unit(random) > 0 ? y : thin));
  if (unit(random) > 0) mesh.points.back() += 1e-15 * ofAnySize(random) * place();
  mesh.addFace(std::array{0, 1, 2});
  mesh.addFace(shared == 0 ? std::array{3, 4, 5} : shared == 1 ? std::array{2, 3, 4} : std::array{2, 1, 3});
  return mesh;
}

/// Every face has points of its own.
Mesh withOwnPoints(const Mesh& mesh) {
  Mesh result;
  for (std::size_t f = 0; f < mesh.faceCount(); ++f) {
    std::vector<int> face;
    for (const Vec3& p : facePoints(mesh, f)) {
      face.push_back(static_cast<int>(result.points.size()));
      result.points.push_back(p);
    }
    result.addFace(face);
  }
  return result;
}

}  // namespace

/// Crossings of a mesh with itself, against every pair in rational numbers.
class GeometryMeshCrossingTest : public QObject {
  Q_OBJECT

 private slots:
  void latticesAgreeWithRationals() {
    std::mt19937_64 random = seededRandom();
    int crossing = 0;
    for (int k = 0; k < 300; ++k) {
      const Mesh mesh = latticeSoup(random, 2 + k % 3, 10, 2 + k % 7);
      compareWithRationals(mesh);
      crossing += firstCrossing(mesh).has_value() ? 1 : 0;
    }
    QVERIFY(crossing > 30 && crossing < 270);  // both answers occur
  }

  void crumpledSurfacesAgreeWithRationals() {
    std::mt19937_64 random = seededRandom();
    int crossing = 0;
    for (int k = 0; k < 40; ++k) {
      const Mesh mesh = crumpledGrid(random, 4, 3 * (k % 4));
      compareWithRationals(mesh);
      crossing += firstCrossing(mesh).has_value() ? 1 : 0;
    }
    QVERIFY(crossing > 0 && crossing < 40);
  }

  /// Where doubles seem to tell them apart, and where they do not.
  void pairsAgreeWithRationals() {
    std::mt19937_64 random = seededRandom();
    int crossing = 0;
    constexpr int pairs = 4000;
    for (int k = 0; k < pairs; ++k) {
      const Mesh mesh = trianglesNearEachOther(random);
      const bool expected = firstByRationals(mesh).has_value();
      QCOMPARE(firstCrossing(mesh).has_value(), expected);
      crossing += expected ? 1 : 0;
    }
    QVERIFY(crossing > pairs / 20 && crossing < pairs - pairs / 20);
  }

  /// Sizes at which heights overflow before errors would, or underflow.
  void sizesNearTheEndsOfNumbers() {
    std::mt19937_64 random = seededRandom();
    std::uniform_int_distribution<int> place(-4, 4), shared(0, 2);
    int crossing = 0;
    for (const int exponent : {-150, -100, -80, 75, 76, 77, 100, 101, 102, 103})
      for (int k = 0; k < 150; ++k) {
        Mesh mesh;
        const int common = shared(random);
        for (int i = 0; i < 6 - common; ++i)
          mesh.points.push_back(Vec3(place(random), place(random), place(random)) * 2 * std::pow(10, exponent));
        mesh.addFace(std::array{0, 1, 2});
        mesh.addFace(common == 0 ? std::array{3, 4, 5} : common == 1 ? std::array{2, 3, 4} : std::array{2, 1, 3});
        const bool expected = firstByRationals(mesh).has_value();
        QCOMPARE(firstCrossing(mesh).has_value(), expected);
        crossing += expected ? 1 : 0;
      }
    QVERIFY(crossing > 50 && crossing < 1400);
  }

  void nearMissesAreTold() {
    // The corner of one triangle over the middle of another, off by the last bit of its height.
    for (const double height : {-1e-300, 0.0, 1e-300}) {
      Mesh mesh;
      mesh.points = {{0, 0, 0}, {3, 0, 0}, {0, 3, 0}, {1, 1, height}, {1, 1.5, 2}, {1.5, 1, 2}};
      mesh.addFace(std::array{0, 1, 2});
      mesh.addFace(std::array{3, 4, 5});
      QCOMPARE(firstCrossing(mesh).has_value(), height <= 0);
      compareWithRationals(mesh);
    }
  }

  void solidsThatCrossNowhere() {
    std::mt19937_64 random = seededRandom();
    for (int k = 0; k < 20; ++k) {
      const Eigen::Matrix3d turn = randomTurn(random);
      QVERIFY(!firstCrossing(triangulated(turnedBy(spikyCube(random, 2), turn)).first));
    }
    QVERIFY(!firstCrossing(torusMesh(3, 1, 24, 12)));
    QVERIFY(!firstCrossing(lBlock()));
    QVERIFY(!firstCrossing(withOwnPoints(lBlock())));  // one place is one vertex
    QVERIFY(!firstCrossing(together(cuboid({0, 0, 0}, {1, 1, 1}), cuboid({1, 1, 0}, {2, 2, 1}))));  // along a whole edge
  }

  void bodiesThatMeetElsewhere() {
    const Mesh cube = cuboid({0, 0, 0}, {1, 1, 1});
    QVERIFY(firstCrossing(together(cube, movedBy(cube, {0.5, 0.5, 0.5}))));
    QVERIFY(firstCrossing(together(cube, cube)));                        // face on face
    QVERIFY(firstCrossing(together(cube, movedBy(cube, {1, 0, 0.5}))));  // faces of one plane overlap
    QVERIFY(firstCrossing(together(cube, movedBy(cube, {1, 1, 0.5}))));  // along a part of an edge
    QVERIFY(!firstCrossing(together(cube, movedBy(cube, {1.5, 0, 0}))));
  }

  void aPolygonMayCrossItself() {
    Mesh bowTie;
    bowTie.points = {{0, 0, 0}, {2, 2, 0}, {2, 0, 0}, {0, 2, 0}};
    bowTie.addFace(std::array{0, 1, 2, 3});
    const auto found = firstCrossing(bowTie);
    QVERIFY(found.has_value());
    QCOMPARE(found->first, std::size_t{0});
    QCOMPARE(found->second, std::size_t{0});
  }

  void openMeshesAndEmptyOnes() {
    QVERIFY(!firstCrossing(Mesh()));
    Mesh alone;
    alone.points = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}};
    alone.addFace(std::array{0, 1, 2});  // without area
    QVERIFY(!firstCrossing(alone));
  }

  void rubbishIsRefused() {
    Mesh mesh = cornerTetrahedron();
    mesh.points[1].x() = std::nan("");
    VERIFY_ERROR(firstCrossing(mesh), ErrorCode::InvalidInput);
    mesh = cornerTetrahedron();
    mesh.faceVertices[0] = 9;
    VERIFY_ERROR(firstCrossing(mesh), ErrorCode::InvalidInput);
  }

  void cancels() {
    const CancelToken token;
    token.cancel();
    VERIFY_ERROR(firstCrossing(torusMesh(3, 1, 24, 12), Progress(token)), ErrorCode::Cancelled);
  }
};

BLOSSOM_TEST(GeometryMeshCrossingTest)
#include "geometry_mesh_crossing_test.moc"
