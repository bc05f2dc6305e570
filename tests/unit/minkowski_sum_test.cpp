#include "minkowski/kernel/polygon_sum.h"
#include "minkowski/kernel/region_sum.h"
#include "minkowski/kernel/snap_rounding.h"
#include "minkowski/kernel/winding_faces.h"
#include "support/regions.h"
#include "support/support.h"

using namespace blossom;
using namespace blossom::test;
using namespace blossom::minkowski;
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
    QVERIFY(area(sum) < exact);
    COMPARE_NEAR(area(sum), exact, 1e-4 * (4 * s + 2 * pi * r));
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
        VERIFY_ERROR(differenceOf(cellRegion(a), cellRegion(b)), ErrorCode::Degenerate);
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

  /// A spike that rounding turned inside out for half of its length: there the loop counts -1, and no sum must see that.
  void tangledLoopsAreUntangled() {
    constexpr std::int64_t k = 1 << 20;
    const std::vector<GridPolygon> tangled{{{{0, 0},
                                             {k, 0},
                                             {k, k},
                                             {k / 2 + 4, k},
                                             {k / 2 - 2, 5 * k / 4},
                                             {k / 2 - 2, 7 * k / 4},
                                             {k / 2 + 1, 2 * k},
                                             {k / 2 - 1, 2 * k},
                                             {k / 2 + 2, 7 * k / 4},
                                             {k / 2 + 2, 5 * k / 4},
                                             {k / 2 - 4, k},
                                             {0, k}},
                                            {}}};
    const std::vector<GridPolygon> small{{{{0, 0}, {k / 4, 0}, {k / 4, k / 4}, {0, k / 4}}, {}}};
    const auto areaWith = [&](const std::vector<GridPolygon>& loops) {
      return minkowski::area(windingFaces(convolution(loops, small))) / (double(k) * double(k));
    };
    QVERIFY(!isClear(tangled));
    const std::vector<GridPolygon> plain = untangled(tangled);
    QVERIFY(!misplacedFace(edgesOf(plain), 0));
    const double spike = 1.25 * 1.25 + 0.25;  // the square, and the spike without width, both as wide as the small one
    COMPARE_NEAR(areaWith(plain), spike, 1e-4);
  }

  void farFromTheOriginNothingIsLost() {
    const Region sum =
        sumOf(rectangleRegion({1e6, 1e6}, {1e6 + 1, 1e6 + 1}), polygonRegion({{-3e5, 0}, {-3e5 + 2, 0}, {-3e5 + 1, 1}}));
    COMPARE_NEAR(area(sum), 1 + 1 + 2 + 1, 1e-8);
  }

  /// However small a part is, its sum with the other set is as large as that.
  void specksCountAsPoints() {
    const Region l = polygonRegion({{0, 0}, {4, 0}, {4, 1}, {1, 1}, {1, 4}, {0, 4}});
    for (double size = 1e-3; size > 1e-18; size /= 10) {
      const Region speck = polygonRegion({{50, 0}, {50 + size, 0}, {50 + size / 3, size / 3}, {50, size}});
      const double rounding = 20 * size + 1e-7;
      if (size >= 1e-5) COMPARE_NEAR(area(sumOf(l, speck)), 7, rounding);
      Polygons star;
      for (int k = 0; k < 10; ++k)
        star.resize(1), star[0].outer.push_back((k % 2 == 0 ? size : size / 3) *
                                                Vec2(std::cos(2 * pi * k / 10), std::sin(2 * pi * k / 10)));
      const Polygons large{{{{0, 0}, {4, 0}, {4, 1}, {1, 1}, {1, 4}, {0, 4}}, {}}};
      COMPARE_NEAR(minkowski::area(sum(large, star)), 7, rounding);
      Polygons both = star;
      both.push_back({{{50, 0}, {60, 0}, {60, 10}, {50, 10}}, {}});
      COMPARE_NEAR(minkowski::area(sum(large, both)), 7 + 14 * 14 - 3 * 3, 10 * rounding);
    }
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
    VERIFY_ERROR(differenceOf(square, rectangleRegion({0, 0}, {2, 2})), ErrorCode::Degenerate);
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

QTEST_APPLESS_MAIN(MinkowskiSumTest)
#include "minkowski_sum_test.moc"
