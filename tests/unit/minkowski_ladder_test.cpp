#include "minkowski/kernel/morph/ladder.h"

#include <cmath>
#include <numbers>

#include "minkowski/kernel/morph/morph.h"
#include "support/regions.h"
#include "support/support.h"

using namespace blossom;
using namespace blossom::test;
using namespace blossom::minkowski;

namespace {

std::vector<Region> spikyShapes(std::mt19937_64& random, int count) {
  std::vector<Region> shapes;
  for (int k = 0; k < count; ++k) shapes.push_back(polygonRegion(spikyPoints(random, Vec2(30 * k, 0), 10, 4 + k)));
  return shapes;
}

std::vector<double> someNumbers(std::mt19937_64& random, std::size_t count) {
  std::uniform_real_distribution<double> inside(0.05, 0.95);
  std::vector<double> t;
  while (t.size() < count) t.push_back(inside(random));
  return t;
}

}  // namespace

/// The intermediate shapes of de Casteljau's algorithm.
class MinkowskiLadderTest : public QObject {
  Q_OBJECT

 private slots:
  /// The sides of boxes blend as numbers do, on every level.
  void boxesBlendAsTheirSides() {
    auto random = seededRandom();
    std::uniform_real_distribution<double> side(1, 20), place(-50, 50);
    for (int round = 0; round < 30; ++round) {
      std::vector<Vec2> lows, highs;
      std::vector<Region> boxes;
      for (int k = 0; k < 4; ++k) {
        lows.emplace_back(place(random), place(random));
        highs.push_back(lows.back() + Vec2(side(random), side(random)));
        boxes.push_back(rectangleRegion(lows.back(), highs.back()));
      }
      const std::vector<double> t = someNumbers(random, 3);
      const LadderResult result = ladder(boxes, t);
      QVERIFY(result.complete);
      QCOMPARE(result.levels.size(), std::size_t{4});
      for (std::size_t r = 0; r < result.levels.size(); ++r) {
        QCOMPARE(result.levels[r].size(), 4 - r);
        for (std::size_t i = 0; i + r < 4; ++i) {
          const Vec2 size = highs[i] - lows[i];
          COMPARE_NEAR(area(result.levels[r][i]), size.x() * size.y(), 1e-7 * size.x() * size.y());
        }
        for (std::size_t i = 0; r < t.size() && i + r + 1 < 4; ++i) {
          lows[i] = (1 - t[r]) * lows[i] + t[r] * lows[i + 1];
          highs[i] = (1 - t[r]) * highs[i] + t[r] * highs[i + 1];
        }
      }
    }
  }

  /// The top is the morph, computed another way, and the sums are those of table 1 of the paper for one frame.
  void theTopIsTheMorph() {
    auto random = seededRandom();
    for (std::size_t degree = 1; degree <= 4; ++degree) {
      const std::vector<Region> shapes = spikyShapes(random, static_cast<int>(degree) + 1);
      const std::vector<double> t = someNumbers(random, degree);
      const LadderResult result = ladder(shapes, t);
      QCOMPARE(result.sums, degree * (degree + 1) / 2);
      QVERIFY(result.levels.front() == shapes);
      const double wanted =
          area(morph(shapes, std::vector<std::vector<double>>{t}, {.evaluation = EvaluationOrder::Recursive}).regions.at(0));
      COMPARE_NEAR(area(result.levels.back().at(0)), wanted, 1e-7 * wanted);
      // Each leg is a morph of two shapes of the level before.
      for (std::size_t r = 1; r < result.levels.size(); ++r)
        for (std::size_t i = 0; i < result.levels[r].size(); ++i) {
          const std::vector<Region> leg{result.levels[r - 1][i], result.levels[r - 1][i + 1]};
          const double between = area(morph(leg, std::vector<std::vector<double>>{{t[r - 1]}}).regions.at(0));
          COMPARE_NEAR(area(result.levels[r][i]), between, 1e-6 * between);
        }
    }
  }

  void numbersAtTheEndsTakeOneShapeWithoutASum() {
    auto random = seededRandom();
    const std::vector<Region> shapes = spikyShapes(random, 3);
    const LadderResult result = ladder(shapes, std::vector<double>{0, 1});
    QCOMPARE(result.sums, std::size_t{0});
    COMPARE_NEAR(area(result.levels[1][1]), area(shapes[1]), 1e-9 * area(shapes[1]));
    COMPARE_NEAR(area(result.levels[2][0]), area(shapes[1]), 1e-9 * area(shapes[1]));
  }

  void whatTakesTooLongIsMissing() {
    std::vector<Vec2> star;  // sums of convex shapes would take no effort
    for (int k = 0; k < 10; ++k)
      star.push_back((k % 2 == 0 ? 10 : 4) * Vec2(std::cos(std::numbers::pi * k / 5), std::sin(std::numbers::pi * k / 5)));
    const std::vector<Region> shapes(4, polygonRegion(star));
    const LadderResult result = ladder(shapes, std::vector<double>{0.5, 0.5, 0.5}, {.maximumWork = 1});
    QVERIFY(!result.complete);
    QVERIFY(!result.levels.empty() && result.levels.size() < 4);
    QVERIFY(result.levels.front() == shapes);
  }

  void itCanBeCancelledAndRefusesRubbish() {
    auto random = seededRandom();
    const std::vector<Region> shapes = spikyShapes(random, 3);
    const CancelToken token;
    token.cancel();
    VERIFY_ERROR(ladder(shapes, std::vector<double>{0.5, 0.5}, {}, Progress(token)), ErrorCode::Cancelled);
    VERIFY_ERROR(ladder(shapes, std::vector<double>{0.5}), ErrorCode::InvalidParameter);
    VERIFY_ERROR(ladder(shapes, std::vector<double>{0.5, 1.5}), ErrorCode::InvalidParameter);
    VERIFY_ERROR(ladder(std::span(shapes).first(1), std::vector<double>{}), ErrorCode::InvalidParameter);
    VERIFY_ERROR(ladder(std::vector<Region>{shapes[0], Region()}, std::vector<double>{0.5}), ErrorCode::InvalidInput);
  }
};

BLOSSOM_TEST(MinkowskiLadderTest)
#include "minkowski_ladder_test.moc"
