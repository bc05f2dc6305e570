#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "core/parallel.h"
#include "geometry/planar/winding/snap_rounding.h"
#include "geometry/planar/winding/winding_cells.h"
#include "geometry/planar/winding/winding_faces.h"
#include "support/boundary_distance.h"
#include "support/random.h"
#include "support/support.h"

using namespace blossom;
using namespace blossom::test;
using namespace blossom::planar;

namespace {

/// A point with doubled coordinates, both odd, so that it is no corner.
struct Probe {
  std::int64_t x, y;
};

/// By the edges that a ray to the right crosses; nothing when the point lies on one.
std::optional<int> windingAt(const Probe& p, std::span<const CountedEdge> edges) {
  int winding = 0;
  for (const CountedEdge& edge : edges) {
    const bool up = 2 * edge.to.y > p.y;
    const Wide side = cross(edge.to - edge.from, GridPoint{p.x - 2 * edge.from.x, p.y - 2 * edge.from.y});
    if (up == (2 * edge.from.y > p.y)) continue;
    if (side == 0) return std::nullopt;
    if (up == (side > 0)) winding += up ? edge.count : -edge.count;
  }
  return winding;
}

/// How often a loop winds around a point, by the same rule in doubles.
int windingIn(const Loop& loop, const Vec2& p) {
  int winding = 0;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const Vec2 a = loop[i], b = loop[(i + 1) % loop.size()];
    const bool up = b.y() > p.y();
    if (up == (a.y() > p.y())) continue;
    if (up == (cross(Vec2(b - a), Vec2(p - a)) > 0)) winding += up ? 1 : -1;
  }
  return winding;
}

/// 1 inside, 0 outside; anything else is a flaw of the polygons.
int coverOf(const Polygons& polygons, const Vec2& p) {
  int cover = 0;
  for (const Polygon& part : polygons) {
    cover += windingIn(part.outer, p);
    for (const Loop& hole : part.holes) cover += windingIn(hole, p);
  }
  return cover;
}

/// Closed walks from point to point, which cross, touch and run over one another as they come.
std::vector<CountedEdge> randomWalks(Random& random, int walks, int corners, std::int64_t reach, std::int64_t step,
                                     int flat = 1) {
  std::vector<CountedEdge> edges;
  const auto place = [&] {
    const auto any = [&] { return std::uniform_int_distribution<std::int64_t>(-reach, reach)(random) * step; };
    const std::int64_t x = any();
    return GridPoint{x / flat, any()};
  };
  for (int k = 0; k < walks; ++k) {
    GridLoop loop;
    for (int i = uniformInt(random, 3, corners); i > 0; --i) loop.push_back(place());
    loop.erase(std::unique(loop.begin(), loop.end()), loop.end());
    while (loop.size() > 1 && loop.front() == loop.back()) loop.pop_back();
    if (loop.size() < 2) continue;
    for (std::size_t i = 0; i < loop.size(); ++i) edges.push_back({loop[i], loop[(i + 1) % loop.size()]});
  }
  joinEqual(edges);
  return edges;
}

std::vector<CountedEdge> edgesAround(const std::vector<GridLoop>& loops) {
  std::vector<GridPolygon> polygons;
  for (const GridLoop& loop : loops) polygons.push_back({loop, {}});
  return edgesOf(polygons);
}

bool isInside(int winding, Inside rule) {
  if (rule == Inside::Positive) return winding > 0;
  if (rule == Inside::NonZero) return winding != 0;
  return winding <= 0;
}

}  // namespace

/// The boundary of what edges wind around, against winding numbers counted at points.
class MinkowskiBoundaryTest : public QObject {
  Q_OBJECT

  static void verifyAt(const Probe& probe, std::span<const CountedEdge> edges, const Polygons& faces, Inside rule,
                       int& tried) {
    const Vec2 p(static_cast<double>(probe.x) / 2, static_cast<double>(probe.y) / 2);
    const std::optional<int> winding = windingAt(probe, edges);
    if (!winding || distanceFrom(sidesOf(faces), p) < 0.1) return;
    if (rule == Inside::Hollow && *winding <= 0) return;  // inside only where something encloses it
    ++tried;
    QVERIFY2(
        coverOf(faces, p) == (isInside(*winding, rule) ? 1 : 0),
        qPrintable(QString("winding %1, cover %2 at (%3, %4)").arg(*winding).arg(coverOf(faces, p)).arg(p.x()).arg(p.y())));
  }

 private slots:
  void windingNumbersDecide_data() {
    QTest::addColumn<int>("walks");
    QTest::addColumn<int>("corners");
    QTest::addColumn<qint64>("reach");
    QTest::addColumn<qint64>("step");
    QTest::addColumn<int>("flat");  // divides x, so that nearly all is upright
    QTest::newRow("a small lattice, where most edges touch") << 4 << 6 << qint64(4) << qint64(1 << 20) << 1;
    QTest::newRow("units of the grid") << 3 << 8 << qint64(30) << qint64(1) << 1;
    QTest::newRow("the whole grid") << 3 << 12 << (qint64(1) << 46) << qint64(1) << 1;
    QTest::newRow("many cells") << 8 << 60 << qint64(1000) << qint64(1 << 16) << 1;
    QTest::newRow("upright, some units wide") << 5 << 9 << qint64(6000) << qint64(1) << 1000;
    QTest::newRow("many cells of a lattice") << 20 << 40 << qint64(6) << qint64(1 << 24) << 1;
  }
  void windingNumbersDecide() {
    QFETCH(int, walks);
    QFETCH(int, corners);
    QFETCH(qint64, reach);
    QFETCH(qint64, step);
    QFETCH(int, flat);
    Random random = seededRandom();
    int tried = 0;
    for (int k = 0; k < (corners > 20 ? 6 : 150); ++k) {
      const std::vector<CountedEdge> edges = randomWalks(random, walks, corners, reach, step, flat);
      for (const Inside rule : {Inside::Positive, Inside::NonZero, Inside::Hollow}) {
        const Polygons faces = windingFaces(edges, Progress::none(), rule);
        for (int i = 0; i < 40; ++i) {
          const auto any = [&] {
            return std::uniform_int_distribution<std::int64_t>(-reach * step, reach * step)(random) * 2 + 1;
          };
          verifyAt({(any() / flat) | 1, any()}, edges, faces, rule, tried);
          if (QTest::currentTestFailed()) return;
        }
      }
    }
    QVERIFY2(tried > 300, qPrintable(QString::number(tried)));
  }

  /// The parts of a disjoint cover have the area of its faces: by the integral of the winding number.
  void areasAreThoseOfTheLoops() {
    Random random = seededRandom();
    for (int k = 0; k < 50; ++k) {
      // Squares in squares, each turning the other way: the faces are their rings.
      std::vector<CountedEdge> edges;
      double expected = 0;
      const int depth = uniformInt(random, 1, 6);
      for (int i = 0; i < depth; ++i) {
        const std::int64_t r = 1000 * (10 - i) + uniformInt(random, 0, 400);
        const GridLoop square{{-r, -r}, {r, -r}, {r, r}, {-r, r}};
        for (std::size_t c = 0; c < 4; ++c) edges.push_back({square[c], square[(c + 1) % 4], i % 2 == 0 ? 1 : -1});
        expected += (i % 2 == 0 ? 4.0 : -4.0) * static_cast<double>(r) * static_cast<double>(r);
      }
      joinEqual(edges);
      const Polygons faces = windingFaces(edges);
      QCOMPARE(faces.size(), static_cast<std::size_t>((depth + 1) / 2));
      COMPARE_NEAR(planar::area(faces), expected, 1e-9 * expected);
    }
  }

  /// Two hooks that hold each other: each has a piece of the other next below it somewhere.
  void interlockedHolesBelongToThePartAroundThem() {
    const GridLoop square{{-1000, -1000}, {3000, -1000}, {3000, 3000}, {-1000, 3000}},
        hook{{0, 0}, {0, 1000}, {1400, 1000}, {1400, 400}, {1200, 400}, {1200, 800}, {200, 800}, {200, 0}};
    GridLoop other;
    for (const GridPoint& p : hook) other.push_back({2000 - p.x, 1150 - p.y});
    const std::vector<CountedEdge> edges = edgesAround({square, hook, other});  // the hooks run clockwise
    const Polygons faces = windingFaces(edges);
    QCOMPARE(faces.size(), std::size_t{1});
    QCOMPARE(faces.front().holes.size(), std::size_t{2});
    QCOMPARE(planar::area(faces), 16e6 - 2 * 520e3);
  }

  void everyHoleBelongsToThePartAroundIt_data() {
    QTest::addColumn<std::vector<GridLoop>>("loops");
    QTest::addColumn<int>("holes");
    QTest::addColumn<double>("area");
    const GridLoop square{{-1000, -1000}, {1000, -1000}, {1000, 1000}, {-1000, 1000}},
        diamond{{0, 0}, {-200, 200}, {0, 400}, {200, 200}};
    QTest::newRow("above a slot of a unit")
        << std::vector{square, GridLoop{{-2, -500}, {-2, -100}, {-1, -100}, {-1, -500}}, diamond} << 2 << 4e6 - 400 - 80e3;
    // Its lowest corner is the crossing (.6, 0) of a steep side, which is far below it half a unit to the left.
    const GridLoop box{{-10000, -50}, {10000, -50}, {10000, 20000}, {-10000, 20000}},
        below{{-1000, -50}, {1000, -50}, {1000, -2000}, {-1000, -2000}},
        steep{{0, -600}, {10, 9400}, {6213, 501}, {-49, -4}};
    QTest::newRow("with a steep side") << std::vector{box, below, steep} << 1 << -1.0;
    // The lowest corner of the part is the crossing (-1.5, -300.5) of its own sides.
    const GridLoop eared{{-302, -601}, {1000, 701}, {1000, 2000}, {-1000, 2000}, {-1000, 698}, {298, -600}, {298, -601}};
    QTest::newRow("above a crossing on a half") << std::vector{eared, diamond} << 1 << -1.0;
  }
  void everyHoleBelongsToThePartAroundIt() {
    QFETCH(std::vector<GridLoop>, loops);
    QFETCH(int, holes);
    QFETCH(double, area);
    const Polygons faces = windingFaces(edgesAround(loops));
    std::size_t found = 0;
    for (const Polygon& part : faces) found += part.holes.size();
    QCOMPARE(found, static_cast<std::size_t>(holes));
    if (area > 0) COMPARE_NEAR(planar::area(faces), area, 1e-9 * area);
  }

  /// A thousandth of the size, in one corner.
  void detailHasCellsOfItsOwn() {
    const std::int64_t side = std::int64_t(1) << 40;
    GridLoop star;
    double starArea = 0;
    for (int k = 3000; k > 0; --k) {  // clockwise
      const double radius = k % 2 == 0 ? 5e8 : 4.9e8, angle = 2 * std::numbers::pi * k / 3000;
      star.push_back(
          {side / 1000 + std::llround(radius * std::cos(angle)), side / 1000 + std::llround(radius * std::sin(angle))});
    }
    for (std::size_t k = 0; k < star.size(); ++k)
      starArea -= static_cast<double>(cross(star[k] - star[0], star[(k + 1) % star.size()] - star[0])) / 2;
    const std::vector<CountedEdge> edges = edgesAround({{{0, 0}, {side, 0}, {side, side}, {0, side}}, star});
    const WindingRule rule{std::numeric_limits<int>::min(), 0};
    const double alone = WindingCells(edgesAround({star}), rule, Progress::none()).pairs(),
                 framed = WindingCells(edges, rule, Progress::none()).pairs();
    QVERIFY2(framed < 2 * alone, qPrintable(QString("%1, %2 alone").arg(framed).arg(alone)));
    const Polygons faces = windingFaces(edges);
    QCOMPARE(faces.size(), std::size_t{1});
    QCOMPARE(faces.front().holes.size(), std::size_t{1});
    const double whole = static_cast<double>(side) * static_cast<double>(side);
    COMPARE_NEAR(planar::area(faces), whole - starArea, 1e-9 * whole);
  }

  void oneThreadGivesTheSame() {
    Random random = seededRandom();
    const std::vector<CountedEdge> edges = randomWalks(random, 10, 80, 1000, 1 << 16);
    setThreadLimit(1);
    const Polygons one = windingFaces(edges);
    setThreadLimit(0);
    const Polygons all = windingFaces(edges);
    QCOMPARE(one.size(), all.size());
    for (std::size_t i = 0; i < one.size(); ++i) QVERIFY(one[i].outer == all[i].outer && one[i].holes == all[i].holes);
  }

  void openChainsAreRefused() {
    std::vector<CountedEdge> edges{{{0, 0}, {1000, 0}}, {{1000, 0}, {500, 800}}};
    joinEqual(edges);
    VERIFY_ERROR(windingFaces(edges), ErrorCode::Internal);
  }
};

BLOSSOM_TEST(MinkowskiBoundaryTest)
#include "minkowski_boundary_test.moc"
