#include <ctime>

#include "geometry/planar/sums/flattening.h"
#include "geometry/planar/sums/polygon_sum.h"
#include "geometry/planar/sums/region_sum.h"
#include "geometry/planar/winding/winding_faces.h"
#include "support/regions.h"
#include "support/support.h"

using namespace blossom;
using namespace blossom::test;
using namespace blossom::planar;
using std::numbers::pi;

namespace {

std::size_t holesOf(const Region& region) {
  std::size_t holes = 0;
  for (const Path& loop : region.loops) holes += signedArea(loop) < 0 ? 1 : 0;
  return holes;
}

Region sumOf(const Region& a, const Region& b) { return minkowskiSum(std::vector{a, b}).region; }
Region differenceOf(const Region& a, const Region& b) { return minkowskiDifference(std::vector{a, b}).region; }

std::vector<Vec2> convexPoints(std::mt19937_64& random, int corners) {
  std::uniform_real_distribution<double> place(0, 1), axis(1, 9);
  std::vector<double> angles;
  for (int k = 0; k < corners; ++k) angles.push_back(2 * pi * (k + 0.9 * place(random)) / corners);
  const double a = axis(random), b = axis(random);
  std::vector<Vec2> points;
  for (const double angle : angles) points.emplace_back(a * std::cos(angle) + 3, b * std::sin(angle) - 5);
  return points;
}

/// 2 V(P, Q): the edges of P times the support of Q in their normals' directions, without any sum.
double twiceMixedArea(const std::vector<Vec2>& p, const std::vector<Vec2>& q) {
  double sum = 0;
  for (std::size_t i = 0; i < p.size(); ++i) {
    const Vec2 edge = p[(i + 1) % p.size()] - p[i], normal(edge.y(), -edge.x());
    double support = -1e300;
    for (const Vec2& point : q) support = std::max(support, normal.dot(point));
    sum += support;
  }
  return sum;
}

double areaOf(const std::vector<Vec2>& points) { return area(polygonRegion(points)); }

Region frame(double outer, double inner) {
  return {{rectanglePath({-outer, -outer}, {outer, outer}), reversed(rectanglePath({-inner, -inner}, {inner, inner}))}};
}

template <class F>
std::string messageOf(F f) {
  try {
    f();
  } catch (const Error& error) {
    return error.message();
  }
  return "";
}

}  // namespace

/// Sums and differences of planar regions with closed forms.
class MinkowskiSumTest : public QObject {
  Q_OBJECT

 private slots:
  void boxesAddTheirSides() {
    const Region sum = sumOf(rectangleRegion({0, 0}, {2, 3}), rectangleRegion({10, -1}, {14, 4}));
    COMPARE_NEAR(area(sum), 6 * 8, 1e-9);
    QCOMPARE(sum.loops.size(), std::size_t{1});
    QCOMPARE(sum.loops.front().segments.size(), std::size_t{4});
    COMPARE_NEAR(area(minkowskiSum(std::vector(3, rectangleRegion({0.1, 0.2}, {0.4, 0.3}))).region), 0.9 * 0.3, 1e-9);
  }

  void convexAreasFollowTheMixedArea() {
    std::mt19937_64 random = seededRandom();
    for (int pair = 0; pair < 300; ++pair) {
      const auto p = convexPoints(random, 3 + pair % 12), q = convexPoints(random, 3 + pair % 7);
      const double expected = areaOf(p) + twiceMixedArea(p, q) + areaOf(q);
      const Region sum = sumOf(polygonRegion(p), polygonRegion(q));
      COMPARE_NEAR(area(sum), expected, 1e-9 * expected);
      QVERIFY(sum.loops.front().segments.size() <= p.size() + q.size());
    }
  }

  void aSquareAndADiscHaveTheSteinerArea() {
    const double s = 3, r = 0.7;
    const Region sum =
        minkowskiSum(std::vector{rectangleRegion({0, 0}, {s, s}), circleRegion(r)}, {.tolerance = 1e-4}).region;
    const double exact = s * s + 4 * s * r + pi * r * r;
    COMPARE_NEAR(area(sum), exact, 1e-12 * exact);
  }

  void theSumOfAnLWithASquare() {
    const Region l = polygonRegion({{0, 0}, {4, 0}, {4, 1}, {1, 1}, {1, 4}, {0, 4}});
    // An L with arms one wider: 5 x 5 without the corner of 3 x 3 less one each way.
    COMPARE_NEAR(area(sumOf(l, rectangleRegion({0, 0}, {1, 1}))), 25 - 9, 1e-9);
    COMPARE_NEAR(area(sumOf(l, rectangleRegion({-2, -2}, {2, 2}))), 64 - 9, 1e-9);
  }

  void holesShrinkAndVanish() {
    const Region wall = frame(10, 5);
    const Region narrowed = sumOf(wall, rectangleRegion({-1, -1}, {1, 1}));
    QCOMPARE(holesOf(narrowed), std::size_t{1});
    COMPARE_NEAR(area(narrowed), 22 * 22 - 8 * 8, 1e-9);
    QCOMPARE(holesOf(sumOf(wall, rectangleRegion({-6, -1}, {6, 1}))), std::size_t{0});
    // As wide as the hole, but lower: what remains of the hole has no area.
    QCOMPARE(holesOf(sumOf(wall, rectangleRegion({-5, -1}, {5, 1}))), std::size_t{0});
    // A frame in a frame: the ring between them has room for none.
    COMPARE_NEAR(area(sumOf(wall, frame(1, 0.5))), 22 * 22 - 8 * 8, 1e-9);
  }

  void partsStayApartOrUnite() {
    const Region two{{rectanglePath({0, 0}, {1, 1}), rectanglePath({5, 0}, {6, 1})}};
    COMPARE_NEAR(area(sumOf(two, rectangleRegion({0, 0}, {1, 1}))), 2 * 4, 1e-9);
    COMPARE_NEAR(area(sumOf(two, rectangleRegion({0, 0}, {4.5, 1}))), 10.5 * 2, 1e-9);
    COMPARE_NEAR(area(sumOf(two, two)), 3 * 4, 1e-9);
    // They grow until they touch along a side: one part.
    QCOMPARE(sumOf(two, rectangleRegion({0, 0}, {4, 1})).loops.size(), std::size_t{1});
  }

  /// On a lattice the answer is counted: holes exactly as large as what fills them, parts that touch in corners or grow
  /// until they do, every edge parallel to others.
  void sumsAndDifferencesOfSquaresOfALattice() {
    std::mt19937_64 random = seededRandom();
    const Cells unit{{0, 0}, {1, 0}, {0, 1}, {1, 1}};  // a sum of squares is larger by one square both ways
    for (int pair = 0; pair < 150; ++pair) {
      const Cells a = randomCells(random, 3 + pair % 5, 3 + pair % 4, 0.3 + 0.05 * (pair % 10));
      const Cells b = randomCells(random, 1 + pair % 3, 1 + pair % 4, 0.6);
      Cells sum, difference;
      for (const auto& p : a)
        for (const auto& q : b)
          for (const auto& u : unit) sum.insert({p.first + q.first + u.first, p.second + q.second + u.second});
      for (int x = -4; x < 9; ++x)
        for (int y = -4; y < 9; ++y) {
          const auto fits = [&](const auto& q) {
            return std::all_of(unit.begin(), unit.end(), [&](const auto& u) {
              return a.contains({x + q.first + u.first, y + q.second + u.second});
            });
          };
          if (std::all_of(b.begin(), b.end(), fits)) difference.insert({x, y});
        }
      COMPARE_NEAR(area(sumOf(cellRegion(a), cellRegion(b))), static_cast<double>(sum.size()), 1e-8);
      if (difference.empty())
        QVERIFY(differenceOf(cellRegion(a), cellRegion(b)).loops.empty());
      else
        COMPARE_NEAR(area(differenceOf(cellRegion(a), cellRegion(b))), static_cast<double>(difference.size()), 1e-8);
    }
  }

  /// Slits and spikes whose sides cross when they are rounded: a crossing of that size must not turn the sum around it.
  /// Slits fill up. A spike below the rounding may count or not, or in part, as it does when it is a little wider.
  void partsThinnerThanTheRoundingDoNoHarm() {
    std::mt19937_64 random = seededRandom();
    std::uniform_real_distribution<double> place(0, 1);
    const auto uneven = [&] { return 0.1 + 0.9 * place(random); };
    const Vec2 top(7.3, 10);
    for (const double width : {1e-12, 1e-11, 2e-11, 4e-11, 8e-11, 2e-10, 1e-8})
      for (int k = 0; k < 40; ++k) {
        const bool spike = k % 2 == 0;
        const Vec2 tip = spike ? Vec2(5.1, 17.3) : Vec2(2.9, 3.7);
        const auto with = [&](double wide) {
          const Vec2 across = wide * Vec2(1, spike ? 0 : -0.7);
          std::vector<double> right, left;
          for (int i = 0; i < 6; ++i) right.push_back(place(random)), left.push_back(place(random));
          std::sort(right.begin(), right.end());
          std::sort(left.rbegin(), left.rend());
          std::vector<Vec2> points{{0, 0}, {10, 0}, {10, 10}, top + across};
          for (const double t : right) points.push_back(top + t * (tip - top) + uneven() * across);
          points.push_back(tip + 0.1 * across);
          points.push_back(tip - 0.1 * across);
          for (const double t : left) points.push_back(top + t * (tip - top) - uneven() * across);
          points.push_back(top - across);
          points.emplace_back(0, 10);
          return polygonRegion(points);
        };
        const Region star = polygonRegion(spikyPoints(random, {0, 0}, 3, 9));
        const double without = area(sumOf(rectangleRegion({0, 0}, {10, 10}), star));
        const double thin = area(sumOf(with(width), star)), thicker = spike ? area(sumOf(with(1e-7), star)) : without;
        const double rounding = 1e-5 * without;
        QVERIFY2(
            thin >= without - rounding && thin <= thicker + rounding,
            qPrintable(
                QString("%1 is not within %2 and %3, at a width of %4").arg(thin).arg(without).arg(thicker).arg(width)));
        if (width >= 1e-8) COMPARE_NEAR(thin, thicker, rounding);
      }
  }

  void farFromTheOriginNothingIsLost() {
    const Region sum =
        sumOf(rectangleRegion({1e6, 1e6}, {1e6 + 1, 1e6 + 1}), polygonRegion({{-3e5, 0}, {-3e5 + 2, 0}, {-3e5 + 1, 1}}));
    COMPARE_NEAR(area(sum), 1 + 1 + 2 + 1, 1e-8);
  }

  void differencesShrink() {
    COMPARE_NEAR(area(differenceOf(rectangleRegion({0, 0}, {10, 8}), rectangleRegion({0, 0}, {3, 2}))), 42, 1e-9);
    const Region placed = differenceOf(rectangleRegion({0, 0}, {10, 8}), rectangleRegion({5, 5}, {8, 7}));
    COMPARE_NEAR(startPoint(placed.loops.front()).cwiseMax(endPoint(placed.loops.front().segments.front())).x(), 2, 1e-9);
    // A hole grows by what must not touch it.
    const Region wall = frame(10, 2);
    const Region room = differenceOf(wall, rectangleRegion({-1, -1}, {1, 1}));
    COMPARE_NEAR(area(room), 18 * 18 - 6 * 6, 1e-9);
    QCOMPARE(holesOf(room), std::size_t{1});
    // A bone falls apart where it is too narrow.
    const Region bone{{polygonPath(
        {{0, 0}, {4, 0}, {4, 1.5}, {8, 1.5}, {8, 0}, {12, 0}, {12, 4}, {8, 4}, {8, 2.5}, {4, 2.5}, {4, 4}, {0, 4}})}};
    const Region ends = differenceOf(bone, rectangleRegion({-1, -1}, {1, 1}));
    QCOMPARE(ends.loops.size(), std::size_t{2});
    COMPARE_NEAR(area(ends), 2 * 4, 1e-9);
  }

  void anIslandInAHoleStaysInTheDifference() {
    Region nested = frame(20, 10);
    nested.loops.push_back(rectanglePath({-6, -6}, {6, 6}));
    const Region room = differenceOf(nested, rectangleRegion({-1, -1}, {1, 1}));
    COMPARE_NEAR(area(room), 38 * 38 - 22 * 22 + 10 * 10, 1e-8);
    QCOMPARE(room.loops.size(), std::size_t{3});
    QCOMPARE(components(room).size(), std::size_t{2});
  }

  /// The room's outline and the grown hole touch in four corners: which loop is in which is no matter of majorities.
  void loopsThatTouchLieInOneAnotherAsTheyDo() {
    const auto diamond = [](double r) { return std::vector<Vec2>{{r, 0}, {0, r}, {-r, 0}, {0, -r}}; };
    const Region part{{rectanglePath({-6, -6}, {6, 6}), reversed(polygonPath(diamond(4)))}};
    for (const double cutter : {0.5, 0.999, 1.0, 1.001, 1.5}) {
      const double side = 12 - 2 * cutter, hole = 2 * (4 + cutter) * (4 + cutter);
      const double beyond = std::max(0.0, 4 + cutter - side / 2);  // the hole's corners outside of the room
      COMPARE_NEAR(area(differenceOf(part, polygonRegion(diamond(cutter)))), side * side - hole + 4 * beyond * beyond, 1e-9);
    }
    // The same the other way round: an island that grows until it touches its hole.
    const Region island{
        {rectanglePath({-20, -20}, {20, 20}), reversed(rectanglePath({-6, -6}, {6, 6})), polygonPath(diamond(4))}};
    COMPARE_NEAR(area(sumOf(island, polygonRegion(diamond(1)))), 42 * 42 - 2 - 100 + 50, 1e-9);
    COMPARE_NEAR(area(differenceOf(island, polygonRegion(diamond(1)))), 38 * 38 - 14 * 14 + 2 + 2 * 9, 1e-9);
  }

  /// A ring lies around the hole and the island in it, but must not stick out of the part.
  void aRingFitsAroundAHoleWithAnIsland() {
    Region part = frame(50, 5);
    part.loops.push_back(rectanglePath({-2, -2}, {2, 2}));
    COMPARE_NEAR(area(differenceOf(part, frame(48, 20))), 4 * 4, 1e-9);
  }

  /// Whatever the size and wherever the place: a share of the shape, not so many millimetres.
  void smallShapesAreDrawnAsFinelyAsLargeOnes() {
    for (double r = 1e-5; r < 20; r *= 10)
      for (const Vec2& at : {Vec2(0, 0), Vec2(3e3, -7e3)}) {
        if (r < 1e-8 * at.norm()) continue;  // the numbers themselves are coarser
        const double exact = 4 * pi * r * r, made = area(sumOf(circleRegion(r, at), circleRegion(r)));
        QVERIFY2(made <= exact * (1 + 1e-6) && made >= exact * (1 - 3e-4),
                 qPrintable(QString::number(made / exact, 'g', 12)));
      }
    const Vec2 far(1e6, 1e6);
    const double s = 1e-3;
    COMPARE_NEAR(area(sumOf(rectangleRegion(far, far + Vec2(s, s)), circleRegion(s))), (5 + pi) * s * s, 6e-4 * s * s);
    // Beside a large shape a small one is still what it is.
    COMPARE_NEAR(area(sumOf(circleRegion(1e-3), polygonRegion({{0, 0}, {100, 0}, {100, 1e-3}, {0, 1e-3}}))),
                 0.1 + 2e-3 * 100 + 2e-6 + pi * 1e-6, 2e-5);  // the tolerance along 200 mm
  }

  void aToleranceTooCoarseForTheShapesIsRefused() {
    const Region speck = circleRegion(1e-3, {5, 7});
    const auto sumWithin = [&](double tolerance) {
      return minkowskiSum(std::vector{rectangleRegion({0, 0}, {1, 1}), speck}, {.tolerance = tolerance});
    };
    VERIFY_ERROR(sumWithin(0.01), ErrorCode::InvalidParameter);
    QCOMPARE(QString::fromStdString(messageOf([&] { (void)sumWithin(0.01); })),
             QString("Shape 2 at (5, 7) is 0.002 mm large; a tolerance of 0.01 mm is too coarse for its curves."));
    try {
      (void)sumWithin(0.01);
    } catch (const Error& error) {
      QCOMPARE(QString::fromStdString(error.hint()), QString("Give a tolerance of at most 0.00019 mm, or none."));
    }
    COMPARE_NEAR(area(sumWithin(0.00019).region), 1 + 4e-3 + pi * 1e-6, 4e-4);
    // Straight edges are drawn as they are.
    COMPARE_NEAR(area(minkowskiSum(std::vector(2, rectangleRegion({0, 0}, {1e-3, 1e-3})), {.tolerance = 1}).region), 4e-6,
                 1e-12);
  }

  /// No room is told where there is none, and hardly any is lost.
  void roomIsNeverOverstated() {
    QVERIFY(differenceOf(rectangleRegion({-5, -5}, {5, 5}), circleRegion(5)).loops.empty());
    QVERIFY(differenceOf(rectangleRegion({1, 1}, {11, 11}), circleRegion(5, {3, 2})).loops.empty());
    QVERIFY(differenceOf(rectangleRegion({-5, -4}, {5, 4}), ellipseRegion(5, 4)).loops.empty());
    QVERIFY(differenceOf(circleRegion(5), circleRegion(5)).loops.empty());
    const auto isWithin = [](const Region& room, double exact, double perimeter, double tolerance) {
      const double made = area(room);
      return made <= exact * (1 + 1e-12) && made >= exact - perimeter * tolerance;
    };
    for (const double tolerance : {1e-1, 1e-2, 1e-3, 1e-5}) {
      const auto room = [&](const Region& a, const Region& b) {
        return minkowskiDifference(std::vector{a, b}, {.tolerance = tolerance}).region;
      };
      const Region plate = rectangleRegion({-10, -8}, {10, 8});
      QVERIFY(isWithin(room(plate, circleRegion(3)), 14 * 10, 48, tolerance));
      QVERIFY(isWithin(room(plate, ellipseRegion(4, 2.5)), 12 * 11, 46, tolerance));
      // A round hole, too, is not drawn smaller than it is.
      Region pierced = plate;
      pierced.loops.push_back(reversed(circleRegion(2).loops.front()));
      QVERIFY(isWithin(room(pierced, rectangleRegion({-1, -1}, {1, 1})), 18 * 14 - (4 + 16 + 4 * pi), 64 + 8 + 4 * pi,
                       tolerance));
      QVERIFY(isWithin(room(circleRegion(9), circleRegion(2.5)), pi * 6.5 * 6.5, 13 * pi, tolerance));
    }
  }

  void squaresOfALatticeAreAddedToThemselves() {
    for (const double step : {1.0, 2.0, 3.0}) {
      Region squares;
      for (int x = 0; x < 26; ++x)
        for (int y = 0; y < 26; ++y)
          squares.loops.push_back(rectanglePath(step * Vec2(x, y), step * Vec2(x, y) + Vec2(1, 1)));
      const double wanted = step <= 2 ? (50 * step + 2) * (50 * step + 2) : 51 * 51 * 4;
      COMPARE_NEAR(area(sumOf(squares, squares)), wanted, 1e-9 * wanted);
      if (step == 1) COMPARE_NEAR(area(differenceOf(squares, rectangleRegion({0, 0}, {3, 2}))), 23.0 * 24, 1e-8);
    }
  }

  /// The bar of a single sum goes from left to right.
  void aLongSumTellsHowFarItIs() {
    std::mt19937_64 random = seededRandom();
    const std::vector<Region> stars{polygonRegion(spikyPoints(random, {0, 0}, 50, 60)),
                                    polygonRegion(spikyPoints(random, {0, 0}, 40, 60))};
    std::vector<double> told;
    const Progress progress({}, [&](double fraction, const std::string&) { told.push_back(fraction); });
    (void)minkowskiSum(stars, {}, progress);
    QVERIFY(std::is_sorted(told.begin(), told.end()));
    QVERIFY2(told.size() > 20, qPrintable(QString::number(told.size())));
    double last = 0;
    for (const double fraction : told) {
      QVERIFY2(fraction - last < 0.2, qPrintable(QString("from %1 to %2").arg(last).arg(fraction)));
      last = fraction;
    }
    QVERIFY(last > 0.8);
  }

  /// The limit counts work, so that it is met at the same place on every machine, and before the work is done.
  void workIsForeseen() {
    std::mt19937_64 random = seededRandom();
    const std::vector<Region> large{polygonRegion(spikyPoints(random, {0, 0}, 50, 300)),
                                    polygonRegion(spikyPoints(random, {0, 0}, 40, 300))};
    int sums = 0;
    const Progress progress({}, [&](double, const std::string& stage) { sums += stage == "Finding the boundary" ? 1 : 0; });
    QVERIFY_THROWS_EXCEPTION(TooMuchWork, (void)minkowskiSum(large, {.maximumWork = 1'000'000}, progress));
    QCOMPARE(sums, 0);
    const std::vector<Region> small{polygonRegion(spikyPoints(random, {0, 0}, 50, 12)),
                                    polygonRegion(spikyPoints(random, {0, 0}, 40, 12))};
    QVERIFY(minkowskiSum(small, {.maximumWork = 1'000'000}).region == minkowskiSum(small).region);
    QVERIFY_THROWS_EXCEPTION(TooMuchWork, (void)minkowskiSum(small, {.maximumWork = 10}));
    // Convex shapes are merged, however many corners they have.
    QVERIFY(!minkowskiSum(std::vector{circleRegion(500), circleRegion(300)}, {.tolerance = 1e-6, .maximumWork = 0})
                 .region.loops.empty());
  }

  /// What the acceptance reads: how long (of computing time) work goes on after it is cancelled, at the worst of many
  /// places.
  void cancellingEndsWorkSoon() {
    std::mt19937_64 random = seededRandom();
    const std::vector<Region> shapes{polygonRegion(spikyPoints(random, {0, 0}, 50, 60)),
                                     polygonRegion(spikyPoints(random, {0, 0}, 40, 60))};
    double worst = 0;
    for (int stop = 1; stop < 80; stop += 15) {
      const CancelToken token;
      std::clock_t cancelled = 0;
      int reports = 0;
      const Progress progress(token, [&](double, const std::string&) {
        if (++reports != stop) return;
        token.cancel();
        cancelled = std::clock();
      });
      try {
        (void)minkowskiSum(shapes, {}, progress);
      } catch (const Error& error) {
        QCOMPARE(error.code(), ErrorCode::Cancelled);
        worst = std::max(worst, static_cast<double>(std::clock() - cancelled) / CLOCKS_PER_SEC);
      }
    }
    QVERIFY(worst > 0);
    qInfo("figure cancel_s %.3f", worst);
  }

  void differenceAndSumOpenConvexShapesWithoutLoss() {
    std::mt19937_64 random = seededRandom();
    for (int pair = 0; pair < 40; ++pair) {
      const Region a = polygonRegion(convexPoints(random, 6)), b = polygonRegion(convexPoints(random, 5));
      COMPARE_NEAR(area(differenceOf(sumOf(a, b), b)), area(a), 1e-8 * area(a));
    }
  }

  void rubbishIsRefusedWithThePlace() {
    const Region square = rectangleRegion({0, 0}, {1, 1});
    const auto message = [&](const Region& bad) { return messageOf([&] { (void)sumOf(square, bad); }); };
    VERIFY_ERROR(sumOf(square, Region{}), ErrorCode::InvalidInput);
    QCOMPARE(QString::fromStdString(message({})), QString("Shape 2 is empty: it has no outline."));
    QCOMPARE(QString::fromStdString(message(polygonRegion({{0, 0}, {4, 4}, {4, 0}, {0, 4}}))),
             QString("Shape 2 crosses itself at (2, 2)."));
    Region open = square;
    open.loops.front().segments.pop_back();
    QVERIFY2(message(open).starts_with("Shape 2 is open: a gap of 1 mm at (0, 1)"), message(open).c_str());
    QVERIFY(message(polygonRegion({{0, 0}, {std::nan(""), 4}, {4, 0}})).find("not numbers, in segment 1 of loop 1") !=
            std::string::npos);
    // Once either way round, both would cancel out.
    const Path once = rectanglePath({-5, -5}, {5, 5});
    QVERIFY(message(Region{{once, reversed(once)}}).find("drawn twice") != std::string::npos);
    // Through a corner, along an edge, drawn twice: nothing crosses inside of two edges.
    for (const Region& bad : {polygonRegion({{0, 0}, {1, 1}, {2, 2}, {2, 0}, {1, 1}, {0, 2}}),
                              Region{{rectanglePath({0, 0}, {2, 2}), rectanglePath({0, 0}, {2, 2})}},
                              Region{{rectanglePath({0, 0}, {2, 2}), rectanglePath({0, 1}, {2, 3})}}})
      QVERIFY2(message(bad).starts_with("Shape 2 crosses itself or overlaps itself at ("), message(bad).c_str());
    QVERIFY(
        message(polygonRegion({{0, 0}, {1, 0}, {2, 0}})).starts_with("Shape 2 has a loop at (0, 0) that encloses nothing"));
    VERIFY_ERROR(sumOf(square, rectangleRegion({0, 0}, {1e12, 1})), ErrorCode::LimitExceeded);
    VERIFY_ERROR(sumOf(square, Region{{rectanglePath({0, 0}, {2, 2}), rectanglePath({1, 1}, {3, 3})}}),
                 ErrorCode::InvalidInput);
    VERIFY_ERROR(minkowskiSum(std::vector{square}), ErrorCode::InvalidParameter);
    VERIFY_ERROR(minkowskiSum(std::vector{square, circleRegion(1e6)}, {.tolerance = 1e-9}), ErrorCode::LimitExceeded);
    QVERIFY(differenceOf(square, rectangleRegion({0, 0}, {2, 2})).loops.empty());
  }

  void workCanBeCancelledInTheMiddle() {
    std::mt19937_64 random = seededRandom();
    const Region a = polygonRegion(spikyPoints(random, {0, 0}, 50, 300)),
                 b = polygonRegion(spikyPoints(random, {0, 0}, 40, 300));
    const CancelToken token;
    int reports = 0;
    const Progress progress(token, [&](double, const std::string&) { ++reports, token.cancel(); });
    VERIFY_ERROR(minkowskiSum(std::vector{a, b}, {}, progress), ErrorCode::Cancelled);
    QCOMPARE(reports, 1);
    COMPARE_NEAR(area(sumOf(rectangleRegion({0, 0}, {2, 3}), rectangleRegion({0, 0}, {1, 1}))), 12, 1e-9);
  }
};

BLOSSOM_TEST(MinkowskiSumTest)
#include "minkowski_sum_test.moc"
