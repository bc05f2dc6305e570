#include <cmath>

#include "geometry/planar/planar.h"
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

bool sameBut(const Path& one, const Path& other, double size) {
  if (one.segments.size() != other.segments.size()) return false;
  if (std::abs(signedArea(one) - signedArea(other)) >= 1e-9 * size * size) return false;
  const auto *circle = std::get_if<Arc2>(&one.segments[0]), *sameCircle = std::get_if<Arc2>(&other.segments[0]);
  if (one.segments.size() == 1 && circle && sameCircle)  // where it begins is chance
    return (circle->center - sameCircle->center).norm() < 1e-7 * size &&
           std::abs(circle->radius - sameCircle->radius) < 1e-7 * size;
  for (std::size_t k = 0; k < one.segments.size(); ++k)
    if ((startPoint(one.segments[k]) - startPoint(other.segments[k])).norm() >= 1e-7 * size) return false;
  return true;
}

/// @returns whether they are the same but for rounding; if not, which only free-form loops may be, they are within a
/// hundredth of the tolerance of each other, by area
bool compareRegions(const Region& kept, const Region& plain, double size, double tolerance) {
  if (kept.loops.size() != plain.loops.size()) qFatal("%zu and %zu loops", kept.loops.size(), plain.loops.size());
  bool same = true;
  for (std::size_t i = 0; i < kept.loops.size(); ++i) {
    const Path &one = kept.loops[i], &other = plain.loops[i];
    if (sameBut(one, other, size)) continue;
    same = false;
    const double off = std::abs(signedArea(one) - signedArea(other));
    if (!hasSplines({{other}}) || off >= 0.01 * tolerance * length(other)) qFatal("areas differ by %g", off);
  }
  return same;
}

}  // namespace

void MinkowskiKeptTest::sumsOfMultiplesOfKeptShapes() {
  Random random = seededRandom();
  Effort unlimited;
  int different = 0;
  for (int round = 0; round < 60; ++round) {
    SoundRegion a = soundRegion(anyCurved(random, 10), {}, "a"), b = soundRegion(anyCurved(random, 10), {}, "b");
    Adder add;
    add.keep(a), add.keep(b);
    for (int k = 0; k < 4; ++k) {
      const double s = std::pow(10, uniform(random, -4, 0.5)), t = std::pow(10, uniform(random, -4, 0.5));
      const SoundRegion kept = add(scaled(a, s), scaled(b, t), Progress::none());
      const SoundRegion plain = sum(scaled(a, s), scaled(b, t), Progress::none(), unlimited);
      different += compareRegions(kept.region, plain.region, 10 * (s + t), plain.tolerance) ? 0 : 1;
      QVERIFY(std::abs(kept.tolerance - plain.tolerance) < 1e-15);
    }
    QCOMPARE(add.count(), std::size_t(4));
  }
  QVERIFY2(different <= 1, qPrintable(QString::number(different)));  // of 240
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
      QVERIFY(
          compareRegions(together.regions[k], morph(shapes, std::span(times).subspan(k, 1), coarse).regions.front(), 10, 0));
  }
}

BLOSSOM_TEST(MinkowskiKeptTest)
#include "minkowski_kept_test.moc"
