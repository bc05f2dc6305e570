/// The core of a sum beside the sum itself, whose pairs are too few for a core of its own.
#include "geometry/shape/bounds.h"
#include "morphology/kernel/arrangement/arranged_sum.h"
#include "morphology/kernel/arrangement/sum_core.h"
#include "support/morphology.h"
#include "support/random.h"
#include "support/support.h"

using namespace blossom;
using namespace blossom::test;
using namespace blossom::morphology;
using namespace blossom::morphology::arrangement;

namespace {

const double step = std::ldexp(1, -44);

Mesh solidOfSize(Random& random, double size) {
  const Eigen::Matrix3d turn =
      uniformInt(random, 0, 1) == 0 ? Eigen::Matrix3d(Eigen::Matrix3d::Identity()) : randomTurn(random);
  const auto made = [&]() -> Mesh {
    switch (uniformInt(random, 0, 5)) {
      case 0:
        return spikyCube(random, 1.5);
      case 1:
        return spikyRing(random, 1, 0.5, 9);
      case 2:
        return scaledBy(lBlock(), 0.4);
      case 3:
        return scaledBy(frameBlock(1, 0.6, -0.2, 0.2), uniform(random, 0.5, 2));
      case 4:
        return together(cuboid({-1, -1, -1}, {1, 1, 1}), insideOut(cuboid({-0.7, -0.7, -0.7}, {0.7, 0.7, 0.7})));
      default:
        return cuboid({-1, -0.5, 0}, {1, 0.5, uniform(random, 0.01, 1)});
    }
  }();
  return scaledBy(turnedBy(triangulated(made).first, turn), size);
}

/// Triangles and parallelograms of all sizes about a place.
std::vector<Vec3> polygonAnywhere(Random& random, const Bounds& box) {
  const Vec3 from = randomPoint(random, box), size = std::pow(10, uniform(random, -3, -0.5)) * (box.high - box.low);
  const auto away = [&] { return Vec3(size.cwiseProduct(randomPoint(random, {Vec3(-1, -1, -1), Vec3(1, 1, 1)}))); };
  const Vec3 u = away(), v = away();
  if (uniformInt(random, 0, 1) == 0) return {from, from + u, from + v};
  return {from, from + u, from + u + v, from + v};
}

Vec3 placeIn(Random& random, const std::vector<Vec3>& polygon) {
  double weights = 0;
  Vec3 sum = Vec3::Zero();
  for (const Vec3& p : polygon) {
    const double weight = uniform(random, 0, 1);
    sum += weight * p;
    weights += weight;
  }
  return sum / weights;
}

std::vector<Grid3> inSteps(const std::vector<Vec3>& polygon) {
  std::vector<Grid3> corners;
  for (const Vec3& p : polygon) {
    Grid3& corner = corners.emplace_back();
    for (std::size_t k = 0; k < 3; ++k) corner[k] = std::llround(p[static_cast<Eigen::Index>(k)] / step);
  }
  return corners;
}

struct Compared {
  int held = 0;
  std::optional<Vec3> wrong;  ///< a place of a polygon that is held and lies elsewhere
};

/// @param isIn whether a place lies in the sum
Compared compared(Random& random, const SumCore& core, const Bounds& box, const std::function<bool(const Vec3&)>& isIn) {
  Compared result;
  for (int k = 0; k < 4000; ++k) {
    const std::vector<Vec3> polygon = polygonAnywhere(random, box);
    if (!core.holds(inSteps(polygon))) continue;
    ++result.held;
    for (const Vec3& corner : polygon)
      if (!isIn(corner)) result.wrong = corner;
    for (int i = 0; i < 4; ++i)
      if (const Vec3 place = placeIn(random, polygon); !isIn(place)) result.wrong = place;
  }
  return result;
}

}  // namespace

class MorphologyCoreTest : public QObject {
  Q_OBJECT

 private slots:
  void whatTheCoreHoldsLiesInTheSum() {
    Random random = seededRandom();
    int held = 0;
    for (int run = 0; run < 40; ++run) {
      const Mesh a = solidOfSize(random, std::pow(10, uniform(random, -1, 1))), b = solidOfSize(random, 1);
      const SumCore core(*featuresOf(a, 1, step), *featuresOf(b, 1, step), false, Progress::none());
      const Mesh sum = triangulated(solidSumOf(a, b)).first;
      const Compared result = compared(random, core, bounds(sum), [&](const Vec3& p) { return contains(sum, p); });
      QVERIFY2(!result.wrong, "outside of the sum");
      held += result.held;
    }
    QVERIFY(held > 40 * 100);
  }

  /// The complement of a difference is the sum of the complement and the element reflected.
  void whatTheCoreHoldsLiesOffTheDifference() {
    Random random = seededRandom();
    int held = 0;
    for (int run = 0; run < 40; ++run) {
      const Mesh a = solidOfSize(random, 1), b = solidOfSize(random, 0.02);
      const SumCore core(*featuresOf(a, 1, step, true), *featuresOf(b, -1, step), true, Progress::none());
      const Mesh left = arrangedDifference({a, {}}, {b, {}}, step, Progress::none())->triangles;
      const Bounds inside = bounds(a);
      const Bounds box{inside.low - 0.2 * (inside.high - inside.low), inside.high + 0.2 * (inside.high - inside.low)};
      const Compared result = compared(random, core, box, [&](const Vec3& p) { return !contains(left, p); });
      QVERIFY2(!result.wrong, "in the difference");
      held += result.held;
    }
    QVERIFY(held > 40 * 100);
  }

  /// A thin shape has no full cells, and moves those of the other one.
  void aSegmentMovesASolid() {
    const Mesh cube = triangulated(cuboid({0, 0, 0}, {4, 4, 4})).first;
    const std::vector<std::vector<Vec3>> segment{{Vec3(0, 0, 0), Vec3(10, 0, 0)}};
    const SumCore core(*featuresOf(cube, 1, step), featuresOf(segment, 1, step), false, Progress::none());
    const auto isHeld = [&](const Vec3& p) { return core.holds(inSteps({p, p + Vec3(0.1, 0, 0), p + Vec3(0, 0.1, 0)})); };
    for (const double x : {1.0, 4.0, 7.0, 11.0, 13.0}) QVERIFY(isHeld({x, 2, 2}));
    for (const double x : {-0.05, 14.0, 20.0}) QVERIFY(!isHeld({x, 2, 2}));
    QVERIFY(!isHeld({7, 4.01, 2}) && !isHeld({7, 2, -0.01}));
  }
};

BLOSSOM_TEST(MorphologyCoreTest)
#include "morphology_core_test.moc"
