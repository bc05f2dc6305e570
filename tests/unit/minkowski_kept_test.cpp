#include <algorithm>
#include <cmath>

#include "geometry/planar/planar.h"
#include "geometry/planar/segment_point.h"
#include "geometry/planar/sums/curved_sum.h"
#include "geometry/planar/sums/flattening.h"
#include "minkowski/kernel/morph/morph.h"
#include "minkowski/kernel/morph/repetition.h"
#include "support/curved_regions.h"
#include "support/support.h"

using namespace blossom;
using namespace blossom::test;
using namespace blossom::minkowski;

/// What is kept of pairs of shapes changes no sum of their multiples.
class MinkowskiKeptTest : public QObject {
  Q_OBJECT
 private slots:
  void sumsOfMultiplesOfKeptShapes();
  void framesTogetherAreThoseAlone();
};

namespace {

Region anyCurved(Random& random, double reach) {
  return uniformInt(random, 0, 2) == 0 ? freeRegion(random, reach) : anyRounded(random, reach);
}

double distanceFrom(const Segment& segment, const Vec2& p, double chord) {
  if (!std::holds_alternative<Spline2>(segment)) return distanceTo(segment, p);
  double least = HUGE_VAL;
  const std::vector<Vec2> line = flatten(segment, chord);
  for (std::size_t i = 0; i + 1 < line.size(); ++i)
    least = std::min(least, distanceTo(Segment(Line2{line[i], line[i + 1]}), p));
  return least;
}

/// Where two curves go on from each other nearly smoothly, rounding moves their joint along both.
bool isJoint(const Vec2& p, const Path& path, std::size_t k, double size) {
  const Segment &after = path.segments[k], &before = path.segments[(k + path.segments.size() - 1) % path.segments.size()];
  if ((startPoint(after) - p).norm() < 1e-7 * size) return true;
  const double within = 1e-10 * size;
  return std::max(distanceFrom(before, p, within), distanceFrom(after, p, within)) < 10 * within &&
         (startPoint(after) - p).norm() < 1e-4 * size;
}

void compareRegions(const Region& kept, const Region& plain, double size) {
  QCOMPARE(kept.loops.size(), plain.loops.size());
  QVERIFY(std::abs(area(kept) - area(plain)) < 1e-9 * size * size);
  for (std::size_t i = 0; i < kept.loops.size(); ++i) {
    QCOMPARE(kept.loops[i].segments.size(), plain.loops[i].segments.size());
    for (std::size_t k = 0; k < kept.loops[i].segments.size(); ++k)
      QVERIFY(isJoint(startPoint(kept.loops[i].segments[k]), plain.loops[i], k, size));
  }
}

}  // namespace

void MinkowskiKeptTest::sumsOfMultiplesOfKeptShapes() {
  Random random = seededRandom();
  Effort unlimited;
  for (int round = 0; round < 60; ++round) {
    SoundRegion a = soundRegion(anyCurved(random, 10), {}, "a"), b = soundRegion(anyCurved(random, 10), {}, "b");
    Adder add;
    add.keep(a), add.keep(b);
    for (int k = 0; k < 4; ++k) {
      const double s = std::pow(10, uniform(random, -4, 0.5)), t = std::pow(10, uniform(random, -4, 0.5));
      const SoundRegion kept = add(scaled(a, s), scaled(b, t), Progress::none());
      const SoundRegion plain = sum(scaled(a, s), scaled(b, t), Progress::none(), unlimited);
      compareRegions(kept.region, plain.region, 10 * (s + t));
      QVERIFY(std::abs(kept.tolerance - plain.tolerance) < 1e-15);
    }
    QCOMPARE(add.count(), std::size_t(4));
  }
}

void MinkowskiKeptTest::framesTogetherAreThoseAlone() {
  Random random = seededRandom();
  for (int round = 0; round < 8; ++round) {
    const int degree = uniformInt(random, 1, 3);
    std::vector<Region> shapes;
    for (int i = 0; i <= degree; ++i) shapes.push_back(anyCurved(random, 10));
    std::vector<std::vector<double>> times;
    for (const double t : {0.0, 0.2, 0.55, 0.9, 1.0}) times.push_back(diagonal(static_cast<std::size_t>(degree), t));
    const MorphOptions coarse{.evaluation = EvaluationOrder::Explicit, .tolerance = 0.05};
    const MorphResult together = morph(shapes, times, coarse);
    for (std::size_t k = 0; k < times.size(); ++k)
      compareRegions(together.regions[k], morph(shapes, std::span(times).subspan(k, 1), coarse).regions.front(), 10);
  }
}

BLOSSOM_TEST(MinkowskiKeptTest)
#include "minkowski_kept_test.moc"
