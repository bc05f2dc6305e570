#include "geometry/planar/polygons/polygons.h"
#include "geometry/planar/polygons/snapped_operands.h"
#include "geometry/planar/winding/certain_inside.h"
#include "geometry/planar/winding/edges_of_sum.h"
#include "geometry/planar/winding/snap_rounding.h"
#include "geometry/planar/winding/winding_faces.h"
#include "minkowski/kernel/morph/morph.h"
#include "minkowski/kernel/morph/thinning.h"
#include "minkowski/kernel/shallow_dents.h"
#include "support/regions.h"
#include "support/support.h"

using namespace blossom;
using namespace blossom::test;
using namespace blossom::minkowski;

namespace {

/// Of a shape however small, with cells as fine as they may be.
constexpr CertainInsideOptions everything{.fewestPairs = 0, .wordsOfPair = 1e4};

Loop circleLoop(double radius, int corners, const Vec2& centre = Vec2::Zero()) {
  Loop loop;
  for (int i = 0; i < corners; ++i) {
    const double angle = 2 * std::numbers::pi * i / corners;
    loop.emplace_back(centre + radius * Vec2(std::cos(angle), std::sin(angle)));
  }
  return loop;
}

Loop turnedBack(const Loop& loop) { return {loop.rbegin(), loop.rend()}; }

/// A disc of spikes, with round holes that the other shape may or may not enter.
Polygons plate(std::mt19937_64& random, int corners, int holes, double hole) {
  Polygon result{spikyPoints(random, {3, -2}, 40, corners), {}};
  if (signedArea(result.outer) < 0) result.outer = turnedBack(result.outer);
  for (int k = 0; k < holes; ++k) {
    const double angle = 2 * std::numbers::pi * k / holes;
    const Vec2 place = holes == 1 ? Vec2(0, 0) : Vec2(6 * std::cos(angle), 6 * std::sin(angle));
    result.holes.push_back(turnedBack(circleLoop(hole, 9, Vec2(3, -2) + place)));
  }
  return {result};
}

/// A band that winds inwards.
Polygons spiral(double turns, int steps) {
  Loop outside, inside;
  for (int i = 0; i <= steps; ++i) {
    const double angle = 2 * std::numbers::pi * turns * i / steps, radius = 4 + angle;
    outside.emplace_back(radius * Vec2(std::cos(angle), std::sin(angle)));
    inside.emplace_back((radius - 1.5) * Vec2(std::cos(angle), std::sin(angle)));
  }
  outside.insert(outside.end(), inside.rbegin(), inside.rend());
  return {{outside, {}}};
}

struct Counts {
  std::size_t parts = 0, holes = 0, corners = 0;
  friend bool operator==(const Counts&, const Counts&) = default;
};

Counts countsOf(const Polygons& polygons) {
  Counts counts{polygons.size(), 0, edgeCount(polygons)};
  for (const Polygon& polygon : polygons) counts.holes += polygon.holes.size();
  return counts;
}

bool isWithin(const Polygons& polygons, const Vec2& p) {
  int winding = 0;
  for (const Polygon& polygon : polygons) {
    winding += windingNumber(polygonPath(polygon.outer), p);
    for (const Loop& hole : polygon.holes) winding += windingNumber(polygonPath(hole), p);
  }
  return winding > 0;
}

Loop spikes(int count, double outer, double inner) {
  Loop corners = circleLoop(outer, 2 * count);
  for (std::size_t i = 1; i < corners.size(); i += 2) corners[i] *= inner / outer;
  return corners;
}

Region spikedDisc(int count, double outer, double inner) { return polygonRegion(spikes(count, outer, inner)); }

struct Operands {
  std::vector<GridPolygon> a, b;
};

Operands onGrid(const Polygons& a, const Polygons& b) {
  const SnappedOperands snapped = snappedTogether(a, b);
  return {untangled(snapped.a), untangled(snapped.b)};
}

double coveredBy(const CertainInside& inside) {
  double area = 0;
  for (const CertainInside::Run& run : inside.runs()) {
    const GridPoint low = inside.corner(run.first, run.row), high = inside.corner(run.last, run.row + 1);
    area += static_cast<double>(high.x - low.x) * static_cast<double>(high.y - low.y);
  }
  return area;
}

}  // namespace

/// What is left out of sums because it lies in their inside, and dents that are filled.
class MinkowskiInsideTest : public QObject {
  Q_OBJECT

 private slots:
  void edgesThatAreLeftOutChangeNothing() {
    std::mt19937_64 random = seededRandom();
    std::uniform_int_distribution<int> corners(5, 90);
    std::uniform_real_distribution<double> size(0.5, 12);
    std::size_t leftOut = 0;
    for (int round = 0; round < 60; ++round) {
      Polygons a = round % 3 == 0 ? spiral(1 + round % 2, 30) : plate(random, corners(random), round % 4, size(random) / 4);
      if (round % 5 == 0)
        for (const Polygon& part : translated(plate(random, corners(random), 1, 3), {55, 20})) a.push_back(part);
      Polygons b{{spikyPoints(random, {-1, 5}, size(random), corners(random)), {}}};
      if (signedArea(b.front().outer) < 0) b.front().outer = turnedBack(b.front().outer);
      if (round % 7 == 6) a = {{spikes(40 + round, 20, 8), {}}};  // thinner than cells
      if (round % 2 == 1) std::swap(a, b);
      const Operands on = onGrid(a, b);
      const std::vector<CountedEdge> all = convolution(on.a, on.b);
      const auto inside = certainInside(on.a, on.b, Progress::none(), Effort(), everything);
      QVERIFY(inside.has_value());
      const std::vector<CountedEdge> some = convolution(on.a, on.b, Progress::none(), Effort(), nullptr, &*inside);
      const auto bounding = [](const std::vector<CountedEdge>& edges) {
        return std::count_if(edges.begin(), edges.end(), [](const CountedEdge& edge) { return edge.mayBound != 0; });
      };
      leftOut += static_cast<std::size_t>(bounding(all) - bounding(some));
      const Polygons wanted = windingFaces(all), found = windingFaces(some);
      QVERIFY2(countsOf(found) == countsOf(wanted), qPrintable(QString::number(round)));
      const double area = planar::area(wanted);
      QVERIFY(std::abs(planar::area(found) - area) <= 1e-12 * area);
    }
    QVERIFY(leftOut > 10'000);
  }

  /// Points of the cells lie in the sum; the cells have no hole, and leave little more than a seam of it.
  void cellsLieInside() {
    std::mt19937_64 random = seededRandom();
    for (int round = 0; round < 12; ++round) {
      const Operands on = onGrid(plate(random, 30, round % 3, 4), Polygons{{circleLoop(1 + round % 5, 11), {}}});
      const Polygons sum = windingFaces(convolution(on.a, on.b));
      const auto inside = certainInside(on.a, on.b, Progress::none(), Effort(), everything);
      QVERIFY(inside.has_value());
      const double covered = coveredBy(*inside);
      for (const CertainInside::Run& run : inside->runs()) {
        const GridPoint low = inside->corner(run.first, run.row), high = inside->corner(run.last, run.row + 1);
        for (const GridPoint& p : {low, high, GridPoint{low.x, high.y}, GridPoint{high.x, low.y}})
          QVERIFY(isWithin(sum, {static_cast<double>(p.x), static_cast<double>(p.y)}));
        if (run.parent < 0) continue;
        const CertainInside::Run& parent = inside->runs()[static_cast<std::size_t>(run.parent)];
        QCOMPARE(std::abs(parent.row - run.row), 1);
        QVERIFY(run.door >= std::max(run.first, parent.first) && run.door < std::min(run.last, parent.last));
      }
      const double area = planar::area(sum);
      QVERIFY2(covered > 0.9 * area && covered < area, qPrintable(QString::number(covered / area)));
    }
  }

  /// Spikes thinner than a cell have no full ones: those of the disc, moved along them, reach to the seam.
  void cellsOfThinPartsComeFromTheOther() {
    const Operands on = onGrid(Polygons{{spikes(500, 20, 8), {}}}, Polygons{{circleLoop(1, 64), {}}});
    const auto inside = certainInside(on.a, on.b, Progress::none());
    QVERIFY(inside.has_value());
    const double covered = coveredBy(*inside);
    const std::vector<CountedEdge> all = convolution(on.a, on.b);
    const double area = planar::area(windingFaces(all));
    QVERIFY2(covered > 0.93 * area && covered < area, qPrintable(QString::number(covered / area)));
    Effort unlimited;
    QVERIFY(2 * edgesOfSum(on.a, on.b, Inside::Positive, Progress::none(), unlimited).size() < all.size());
  }

  /// Where little of a sum is certain, the whole convolution is made, and its sides name what they come from once.
  void whatDoesNotPayIsLeft() {
    const Operands on = onGrid(Polygons{{spikes(100, 10, 1), {}}}, Polygons{{spikes(100, 8, 1), {}}});
    const auto inside = certainInside(on.a, on.b, Progress::none());
    QVERIFY(inside.has_value());
    Effort unlimited;
    const auto numbersOf = [](const std::vector<GridPolygon>& set) {
      CornerNumbers numbers;
      const GridLoop& loop = set.front().outer;
      for (std::size_t i = 0; i < loop.size(); ++i) numbers.add(loop[i], loop[(i + 1) % loop.size()]);
      return numbers;
    };
    PairSources once{numbersOf(on.a), numbersOf(on.b)}, plain = once;
    const std::vector<CountedEdge> chosen = edgesOfSum(on.a, on.b, Inside::Positive, Progress::none(), unlimited, &once),
                                   all = convolution(on.a, on.b, Progress::none(), unlimited, &plain);
    QCOMPARE(chosen.size(), all.size());
    QCOMPARE(once.all.size(), plain.all.size());
  }

  /// A brush: each of its needles leaves an end of the same sign in one row of cells, and what flows along adds up.
  void manyEndsOfOneSignInARow() {
    constexpr int needles = 500;
    Loop brush{{0, -60}, {40, -60}};
    for (int i = 0; i < needles; ++i) {
      brush.emplace_back(40, 0.5 * i / needles);
      brush.emplace_back(140, 0.5 * (i + 0.5) / needles);
    }
    for (const Vec2& p : {Vec2(40, 0.5), Vec2(40, 60), Vec2(0, 60)}) brush.push_back(p);
    const Operands on = onGrid(Polygons{{brush, {}}}, Polygons{{circleLoop(15, 30), {}}});
    const auto inside = certainInside(on.a, on.b, Progress::none(), Effort(), {.fewestPairs = 0, .wordsOfPair = 1000});
    QVERIFY(inside.has_value());
    const std::vector<CountedEdge> all = convolution(on.a, on.b),
                                   some = convolution(on.a, on.b, Progress::none(), Effort(), nullptr, &*inside);
    QVERIFY(some.size() < all.size());
    const Polygons wanted = windingFaces(all), found = windingFaces(some);
    QVERIFY(countsOf(found) == countsOf(wanted));
    const double area = planar::area(wanted);
    QVERIFY(std::abs(planar::area(found) - area) <= 1e-12 * area);
  }

  /// A shape lies in the one with its dents filled, and that one in the shape grown by their depth.
  void filledDentsAddLittle() {
    std::mt19937_64 random = seededRandom();
    std::uniform_real_distribution<double> unit(0, 1);
    for (const double depth : {0.01, 0.1, 1.0}) {
      Polygon rough{{}, {}};
      constexpr int corners = 900;
      for (int i = 0; i < corners; ++i) {
        const double angle = 2 * std::numbers::pi * i / corners, radius = 20 + (i % 3 == 0 ? 1.5 : 0.3) * unit(random);
        rough.outer.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
      }
      rough.holes.push_back(turnedBack(circleLoop(5, 200)));
      const FilledDents filled = withoutShallowDents({rough}, depth);
      QVERIFY(filled.depth > 0 && filled.depth <= depth);
      QVERIFY(edgeCount(filled.shape) < edgeCount({rough}));
      QVERIFY(planar::area(filled.shape) >= planar::area({rough}));
      const auto distanceTo = [&](const Vec2& p) {
        double nearest = HUGE_VAL;
        for (const Loop* loop : {&rough.outer, &rough.holes.front()})
          for (std::size_t i = 0; i < loop->size(); ++i) {
            const Vec2 from = (*loop)[i], along = (*loop)[(i + 1) % loop->size()] - from;
            const double t = std::clamp((p - from).dot(along) / along.squaredNorm(), 0.0, 1.0);
            nearest = std::min(nearest, (p - from - t * along).norm());
          }
        return nearest;
      };
      for (int k = 0; k < 4000; ++k) {
        const Vec2 p = 22 * Vec2(2 * unit(random) - 1, 2 * unit(random) - 1);
        const bool before = isWithin({rough}, p), after = isWithin(filled.shape, p);
        if (distanceTo(p) < 1e-9) continue;
        QVERIFY(!before || after);
        QVERIFY(before || !after || distanceTo(p) <= filled.depth + 1e-9);
      }
    }
  }

  /// A dent in which another part lies: both become one.
  void aDentAroundAnotherPart() {
    const Polygons shape{{{{0, 0}, {10, 0}, {10, 5}, {6, 5}, {5, 4.2}, {4, 5}, {0, 5}}, {}},
                         {{{4.9, 4.8}, {5.1, 4.8}, {5, 4.95}}, {}}};
    const FilledDents filled = withoutShallowDents(shape, 1);
    QCOMPARE(filled.shape.size(), std::size_t{1});
    COMPARE_NEAR(planar::area(filled.shape), 50.0, 1e-9);
    COMPARE_NEAR(filled.depth, 0.8, 1e-12);
    QCOMPARE(withoutShallowDents(shape, 0.5).shape.size(), std::size_t{2});
  }

  /// High degree: shallow dents go, and what is left differs by less than the tolerance.
  void aHighDegreeKeepsToTheTolerance_data() {
    QTest::addColumn<int>("count");
    QTest::addColumn<int>("spikesOfEach");
    QTest::addColumn<double>("exact");
    QTest::addColumn<double>("tolerance");
    QTest::addColumn<EvaluationOrder>("way");
    QTest::addRow("explicit") << 6 << 4 << 1e-6 << 0.02 << EvaluationOrder::Explicit;
    QTest::addRow("smallest first") << 6 << 5 << 1e-4 << 0.02 << EvaluationOrder::Explicit;
    QTest::addRow("coarse") << 6 << 5 << 1e-4 << 0.5 << EvaluationOrder::Explicit;
  }
  void aHighDegreeKeepsToTheTolerance() {
    QFETCH(const int, count);
    QFETCH(const int, spikesOfEach);
    QFETCH(const double, exact);
    QFETCH(const double, tolerance);
    QFETCH(const EvaluationOrder, way);
    std::vector<Region> shapes;
    for (int k = 0; k < count; ++k) shapes.push_back(spikedDisc(spikesOfEach, 20 - k % 3, 8 + 0.3 * k));
    const std::vector<std::vector<double>> t{diagonal(shapes.size() - 1, 0.35)};
    const MorphResult fine = morph(shapes, t, {.evaluation = EvaluationOrder::Explicit, .tolerance = exact});
    const double around = length(fine.regions.front().loops.front());
    const MorphResult coarse = morph(shapes, t, {.evaluation = way, .tolerance = tolerance});
    QVERIFY2(coarse.deviation > 0 && coarse.deviation <= tolerance + 1e-12, qPrintable(QString::number(coarse.deviation)));
    const double more = area(coarse.regions.front()) - area(fine.regions.front());
    QVERIFY2(more >= -1e-6 - fine.deviation * around && more <= coarse.deviation * around,
             qPrintable(QString::number(more)));
  }

  /// Shapes of many corners that are to be added again are thinned, others and curves are not.
  void onlyShapesOfManyCornersAreThinned() {
    std::mt19937_64 random = seededRandom();
    std::uniform_real_distribution<double> unit(20, 20.1);
    Loop rough = circleLoop(1, 5000);
    for (Vec2& p : rough) p *= unit(random);
    Thinning thin(0.05);
    const SoundRegion many{toRegion({{rough, {}}})}, few{toRegion({{circleLoop(20, 500), {}}})};
    const SoundRegion less = thin(many, Progress::none());
    QVERIFY(edgeCount(toPolygons(less)) < 2500);
    QVERIFY(thin.deepest() > 0 && thin.deepest() <= 0.05);
    QVERIFY(area(less.region) > area(many.region));
    QVERIFY(thin(few, Progress::none()).region.loops.front().segments.size() == 500);
  }
};

BLOSSOM_TEST(MinkowskiInsideTest)
#include "minkowski_inside_test.moc"
