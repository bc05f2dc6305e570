#include "minkowski/kernel/morph/morph.h"
#include "support/regions.h"
#include "support/support.h"

using namespace blossom;
using namespace blossom::test;
using namespace blossom::minkowski;
using std::numbers::pi;

namespace {

Region regular(int sides, double radius, const Vec2& center = Vec2::Zero()) {
  std::vector<Vec2> points;
  for (int k = 0; k < sides; ++k)
    points.push_back(center + radius * Vec2(std::cos(2 * pi * k / sides), std::sin(2 * pi * k / sides)));
  return polygonRegion(points);
}

Region starRegion(int points, double outer, double inner) {
  std::vector<Vec2> corners;
  for (int k = 0; k < 2 * points; ++k) {
    const double r = k % 2 == 0 ? outer : inner;
    corners.push_back(r * Vec2(std::cos(pi * k / points), std::sin(pi * k / points)));
  }
  return polygonRegion(corners);
}

/// Control shapes none of which is convex.
std::vector<Region> hollows(int count) {
  std::vector<Region> shapes;
  for (int k = 0; k < count; ++k) shapes.push_back(starRegion(3 + k, 10 + k, 4 + 0.5 * k));
  return shapes;
}

std::vector<std::vector<double>> inBetweens(std::size_t degree, int count) {
  std::vector<std::vector<double>> arguments;
  for (int k = 1; k <= count; ++k) arguments.push_back(diagonal(degree, k / (count + 1.0)));
  return arguments;
}

Region one(const std::vector<Region>& shapes, const std::vector<double>& t, const MorphOptions& options = {}) {
  return morph(shapes, std::vector<std::vector<double>>{t}, options).regions.front();
}

constexpr EvaluationOrder everyWay[] = {EvaluationOrder::Recursive, EvaluationOrder::BottomUp, EvaluationOrder::Explicit};

}  // namespace

/// Bézier morphs and their blossoms.
class MinkowskiMorphTest : public QObject {
  Q_OBJECT

 private slots:
  void theEndsAreTheControlShapes() {
    const std::vector<Region> shapes{circleRegion(5), starRegion(5, 8, 3), regular(4, 6)};
    for (const EvaluationOrder evaluation : everyWay) {
      QVERIFY(one(shapes, {0, 0}, {.evaluation = evaluation}) == shapes.front());
      QVERIFY(one(shapes, {1, 1}, {.evaluation = evaluation}) == shapes.back());
    }
  }

  /// On the way there, the other shapes become smaller than any rounding.
  void theEndsAreApproached() {
    const std::vector<Region> shapes{regular(7, 15), starRegion(4, 9, 5), starRegion(5, 24, 9)};
    for (double t = 1e-3; t > 1e-17; t /= 10)
      for (const EvaluationOrder evaluation : everyWay) {
        const MorphOptions options{.evaluation = evaluation};
        COMPARE_NEAR(area(one(shapes, {t, t}, options)), area(shapes.front()), 1e4 * t + 1e-7);
        COMPARE_NEAR(area(one(shapes, {1 - t, 1 - t}, options)), area(shapes.back()), 1e4 * t + 1e-7);
      }
  }

  void aSquareBecomesABoxLinearly() {
    const std::vector<Region> shapes{rectangleRegion({0, 0}, {2, 2}), rectangleRegion({10, 0}, {16, 4})};
    for (const double t : {0.25, 0.5, 0.9}) COMPARE_NEAR(area(one(shapes, {t})), (2 + 4 * t) * (2 + 2 * t), 1e-9);
  }

  void allEvaluationsGiveOneShape() {
    const std::vector<Region> shapes = hollows(4);
    for (const double t : {0.2, 0.5, 0.85}) {
      const double wanted = area(one(shapes, diagonal(3, t), {.evaluation = EvaluationOrder::Recursive}));
      for (const EvaluationOrder evaluation : everyWay)
        COMPARE_NEAR(area(one(shapes, diagonal(3, t), {.evaluation = evaluation})), wanted, 1e-8 * wanted);
    }
  }

  void convexShapesNeedNoRepetition() {
    const std::vector<Region> shapes{starRegion(5, 9, 3), regular(5, 7), circleRegion(6), starRegion(4, 9, 2)};
    const auto t = diagonal(3, 0.4);
    const double wanted = area(one(shapes, t, {.evaluation = EvaluationOrder::Recursive}));
    for (const EvaluationOrder evaluation : {EvaluationOrder::Explicit, EvaluationOrder::Convex}) {
      COMPARE_NEAR(area(one(shapes, t, {.evaluation = evaluation})), wanted, 1e-7 * wanted);
      QCOMPARE(morph(shapes, std::vector<std::vector<double>>{t}, {.evaluation = evaluation}).sums, std::size_t{3});
    }
    VERIFY_ERROR(one(hollows(3), diagonal(2, 0.5), {.evaluation = EvaluationOrder::Convex}), ErrorCode::InvalidInput);
  }

  /// Table 1 of the paper: sums for N in-betweens.
  void theCountersOfTableOne() {
    constexpr int frames = 3;
    for (std::size_t n = 1; n <= 3; ++n) {
      const auto arguments = inBetweens(n, frames);
      std::vector<Region> convex;
      for (std::size_t i = 0; i <= n; ++i) convex.push_back(regular(3 + static_cast<int>(i), 10));
      QCOMPARE(morph(convex, arguments, {.evaluation = EvaluationOrder::Convex}).sums, n * frames);
      QCOMPARE(morph(convex, arguments, {.evaluation = EvaluationOrder::Explicit}).sums, n * frames);
      const auto shapes = hollows(static_cast<int>(n) + 1);
      const auto sums = [&](EvaluationOrder evaluation) {
        return morph(shapes, arguments, {.evaluation = evaluation}).sums;
      };
      QCOMPARE(sums(EvaluationOrder::Recursive), ((std::size_t{1} << n) - 1) * frames);
      QCOMPARE(sums(EvaluationOrder::BottomUp), n * (n + 1) / 2 * frames);
      QCOMPARE(sums(EvaluationOrder::Explicit), n * frames + (std::size_t{1} << n) - n - 1);
    }
  }

  /// Where the table adds one at a time, doubling needs floor(log2 k) + popcount(k) - 1 sums for [k]A.
  void doublingBeatsTheTable() {
    const std::vector<Region> shapes(5, starRegion(3, 2, 0.5));
    const std::size_t table = 4 + 16 - 4 - 1;
    const std::size_t sums = morph(shapes, inBetweens(4, 1), {.evaluation = EvaluationOrder::Explicit}).sums;
    QCOMPARE(sums, std::size_t{4 + 2 + 3 + 2});  // [4], [6], [4]
    QVERIFY(sums < table);
  }

  /// And for more than four hollow shapes the explicit form, though it has a few more.
  void theAutomaticWayTakesTheFewestSums() {
    // Every choice of levels has a weight of its own: explicitly 2^15 terms.
    std::vector<double> different;
    for (int k = 1; k <= 15; ++k) different.push_back(k / 16.0 + 1e-4 * k * k);
    const std::vector<std::vector<double>> one{different};
    const std::vector<bool> hollow(16, false);
    QCOMPARE(sumsNeeded(EvaluationOrder::Explicit, one, hollow), std::size_t{32'767});
    QCOMPARE(sumsNeeded(EvaluationOrder::BottomUp, one, hollow), std::size_t{120});
    QVERIFY(quickestWay(one, hollow) == EvaluationOrder::BottomUp);
    QVERIFY(quickestWay(one, std::vector<bool>(16, true)) == EvaluationOrder::Convex);
    QVERIFY(quickestWay(std::vector<std::vector<double>>{diagonal(5, 0.1)}, std::vector<bool>(6, false)) ==
            EvaluationOrder::Explicit);
    std::vector<Region> shapes;
    for (int k = 0; k < 16; ++k) shapes.push_back(regular(3, 5.0 + k));
    shapes[7] = polygonRegion({{0, 0}, {9, 4}, {0, 8}, {4, 4}});
    const std::size_t sums = morph(shapes, one).sums;
    QCOMPARE(sums, std::size_t{120});
    qInfo("figure sums_of_15_numbers %zu", sums);
    // What is foreseen is what is counted.
    std::mt19937_64 random = seededRandom();
    for (int round = 0; round < 8; ++round) {
      shapes = hollows(3 + round % 2);
      if (round % 3 == 0) shapes[1] = regular(5, 7);
      std::vector<bool> convex(shapes.size(), false);
      convex[1] = round % 3 == 0;
      std::vector<std::vector<double>> arguments;
      for (int k = 0; k < 1 + round % 4; ++k) {
        std::vector<double>& t = arguments.emplace_back();
        while (t.size() + 1 < shapes.size()) t.push_back(std::uniform_int_distribution<int>(0, 4)(random) / 4.0);
      }
      std::size_t fewest = 1'000'000;
      for (const EvaluationOrder way : everyWay) {
        const std::size_t needed = sumsNeeded(way, arguments, convex);
        QCOMPARE(morph(shapes, arguments, {.evaluation = way}).sums, needed);
        fewest = std::min(fewest, needed);
      }
      if (!(convex[1] && shapes.size() == 3)) QCOMPARE(morph(shapes, arguments).sums, fewest);
    }
  }

  /// 32 shapes: hulls stand for the many small copies. Support functions tell what the hull of the in-between is; the shape
  /// itself is near it, for no single shape has a share that matters.
  void aMorphOfThirtyTwoShapes() {
    std::vector<Region> shapes;
    for (int k = 0; k < 32; ++k) shapes.push_back(starRegion(3 + k % 5, 10 + k % 7, 4 + 0.1 * k));
    const MorphResult result = morph(shapes, std::vector<std::vector<double>>{diagonal(31, 0.5)});
    QVERIFY(result.deviation > 0 && result.deviation < 0.01);
    QCOMPARE(result.regions.front().loops.size(), std::size_t{1});
    const std::vector<double> shares = sharesOf(diagonal(31, 0.5));
    for (const double angle : {0.1, 1.3, 2.9, 4.4}) {
      const Vec2 u(std::cos(angle), std::sin(angle));
      const auto reachOf = [&](const Region& region) {
        double reach = -HUGE_VAL;
        for (const Vec2& p : flatten(region.loops.front(), 1e-6)) reach = std::max(reach, p.dot(u));
        return reach;
      };
      double wanted = 0;
      for (std::size_t i = 0; i < shapes.size(); ++i) wanted += shares[i] * reachOf(shapes[i]);
      COMPARE_NEAR(reachOf(result.regions.front()), wanted, 1e-9);
    }
    shapes.push_back(regular(3, 5));
    VERIFY_ERROR(one(shapes, diagonal(32, 0.5)), ErrorCode::LimitExceeded);
  }

  /// Taking hulls within a tolerance changes no more than that.
  void hullsKeepToTheTolerance() {
    const std::vector<Region> shapes = hollows(4);
    const auto t = diagonal(3, 0.02);
    const MorphResult coarse =
        morph(shapes, std::vector<std::vector<double>>{t}, {.evaluation = EvaluationOrder::Explicit, .tolerance = 0.01});
    const Region fine = one(shapes, t, {.evaluation = EvaluationOrder::BottomUp});
    QVERIFY(coarse.deviation > 0 && coarse.deviation <= 0.01);
    double around = 0;
    for (const Path& loop : fine.loops) around += length(loop);
    const double more = area(coarse.regions.front()) - area(fine);
    QVERIFY2(more > -1e-9 && more <= coarse.deviation * around, qPrintable(QString::number(more)));
  }

  void theBlossomIsSymmetric() {
    const std::vector<Region> shapes = hollows(3);
    const double wanted = area(one(shapes, {0.2, 0.7}, {.evaluation = EvaluationOrder::Recursive}));
    for (const EvaluationOrder evaluation : everyWay) {
      COMPARE_NEAR(area(one(shapes, {0.2, 0.7}, {.evaluation = evaluation})), wanted, 1e-8 * wanted);
      COMPARE_NEAR(area(one(shapes, {0.7, 0.2}, {.evaluation = evaluation})), wanted, 1e-8 * wanted);
    }
    // A control shape in the middle is the blossom at 0, 1: with no sum, and with its own corners.
    COMPARE_NEAR(area(one(shapes, {0, 1})), area(shapes[1]), 1e-9);
    QCOMPARE(morph(shapes, std::vector<std::vector<double>>{{0, 1}}).sums, std::size_t{0});
  }

  void areasBlendWhenAsked() {
    const std::vector<Region> shapes{rectangleRegion({0, 0}, {2, 2}), starRegion(5, 30, 10), regular(6, 4, {50, 0})};
    const double t = 0.3;
    const double wanted = (1 - t) * (1 - t) * area(shapes[0]) + 2 * t * (1 - t) * area(shapes[1]) + t * t * area(shapes[2]);
    COMPARE_NEAR(area(one(shapes, diagonal(2, t), {.areaPreserving = true})), wanted, 1e-8 * wanted);
  }

  void elevationKeepsConvexMorphsAndWarnsOfOthers() {
    const std::vector<Region> convex{regular(3, 10), rectangleRegion({0, 0}, {5, 2}), regular(7, 4)};
    const auto t = diagonal(2, 0.35);
    const MorphResult elevated = morph(convex, std::vector<std::vector<double>>{t}, {.degreeElevate = true});
    COMPARE_NEAR(area(elevated.regions.front()), area(one(convex, t)), 1e-8 * area(one(convex, t)));
    QVERIFY(elevated.warnings.empty());
    QCOMPARE(morph(hollows(3), std::vector<std::vector<double>>{t}, {.degreeElevate = true}).warnings.size(),
             std::size_t{1});
    VERIFY_ERROR(one(convex, {0.1, 0.2}, {.degreeElevate = true}), ErrorCode::InvalidParameter);
  }

  /// Elevation makes hollow shapes between hollow ends, whose repetitions are not multiples of them.
  void elevatedShapesMustBeConvexToo() {
    const std::vector<std::vector<double>> t{{0.5}};
    VERIFY_ERROR(morph(hollows(2), t, {.evaluation = EvaluationOrder::Convex, .degreeElevate = true}),
                 ErrorCode::InvalidInput);
    const std::vector<Region> ends{regular(3, 10), regular(5, 4)};
    const auto areaBy = [&](EvaluationOrder order) {
      return area(morph(ends, t, {.evaluation = order, .degreeElevate = true}).regions.front());
    };
    COMPARE_NEAR(areaBy(EvaluationOrder::Convex), areaBy(EvaluationOrder::BottomUp),
                 1e-8 * areaBy(EvaluationOrder::BottomUp));
  }

  /// However coarse the tolerance is, lines are added as they are.
  void twoPolygonsAreAddedAsTheyAre() {
    const std::vector<std::vector<double>> t{{0.5}};
    const std::vector<Region> ends{hollows(1).front(), regular(4, 7)};
    const double whole = area(morph(ends, t, {.evaluation = EvaluationOrder::BottomUp}).regions.front());
    for (const EvaluationOrder order : {EvaluationOrder::Explicit, EvaluationOrder::Automatic})
      COMPARE_NEAR(area(morph(ends, t, {.evaluation = order, .tolerance = 20}).regions.front()), whole, 1e-12 * whole);
  }

  void wrongArgumentsAreRefused() {
    VERIFY_ERROR(one(hollows(3), {0.5}), ErrorCode::InvalidParameter);
    VERIFY_ERROR(one(hollows(2), {1.5}), ErrorCode::InvalidParameter);
    VERIFY_ERROR(one(hollows(1), {}), ErrorCode::InvalidParameter);
    VERIFY_ERROR(one({regular(3, 1), polygonRegion({{0, 0}, {4, 4}, {4, 0}, {0, 4}})}, {0.5}), ErrorCode::InvalidInput);
  }

  void workCanBeCancelledBetweenFrames() {
    const CancelToken token;
    std::size_t reports = 0;
    const Progress progress(token, [&](double fraction, const std::string&) {
      ++reports;
      if (fraction > 0.3) token.cancel();
    });
    VERIFY_ERROR(morph(hollows(3), inBetweens(2, 40), {}, progress), ErrorCode::Cancelled);
    QVERIFY(reports < 20);
  }
};

BLOSSOM_TEST(MinkowskiMorphTest)
#include "minkowski_morph_test.moc"
