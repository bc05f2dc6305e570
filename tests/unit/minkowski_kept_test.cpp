#include <cmath>
#include <numbers>

#include "geometry/planar/planar.h"
#include "geometry/planar/sums/curved_sum.h"
#include "geometry/planar/sums/flattening.h"
#include "geometry/planar/sums/sampled_pair.h"
#include "minkowski/kernel/morph/morph.h"
#include "minkowski/kernel/morph/repetition.h"
#include "support/curved_regions.h"
#include "support/support.h"

using namespace blossom;
using namespace blossom::test;
using namespace blossom::minkowski;
using std::numbers::pi;

/// What is kept of pairs of shapes changes no sum of their multiples.
class MinkowskiKeptTest : public QObject {
  Q_OBJECT
 private slots:
  void sumsOfMultiplesOfKeptShapes();
  void shapesThatTouchThemselvesInCorners();
  void petalsThatCrossInTheirCorner();
  void framesTogetherAreThoseAlone();
};

namespace {

Region anyCurved(Random& random, double reach) {
  return uniformInt(random, 0, 2) == 0 ? freeRegion(random, reach) : anyRounded(random, reach);
}

/// Two slices of discs with one corner in common, each between two lines and an arc.
Region twoLeaves(Random& random, double reach) {
  const Vec2 corner(uniform(random, -reach, reach), uniform(random, -reach, reach));
  const double turn = uniform(random, 0, 2 * pi);
  Region region;
  for (const double way : {turn, turn + pi + uniform(random, -0.2, 0.2)}) {
    const double far = reach * uniform(random, 0.4, 0.6), radius = far * uniform(random, 0.3, 0.8);
    const double half = uniform(random, 0.5, pi / 2);
    const Arc2 arc{corner + far * Vec2(std::cos(way), std::sin(way)), radius, way - half, 2 * half};
    Path leaf;
    leaf.closed = true;
    leaf.segments = {Line2{corner, startPoint(Segment(arc))}, arc, Line2{endPoint(Segment(arc)), corner}};
    region.loops.push_back(std::move(leaf));
  }
  return region;
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

void MinkowskiKeptTest::shapesThatTouchThemselvesInCorners() {
  Random random = seededRandom();
  Effort unlimited;
  int different = 0;
  for (int round = 0; round < 20; ++round) {
    SoundRegion a = soundRegion(twoLeaves(random, 10), {}, "a"), b = soundRegion(anyCurved(random, 10), {}, "b");
    SampledPair pair = sampledPair(a, b, 1, Sampling::Chords, Progress::none());
    certifyClear(pair, Progress::none());
    QVERIFY(pair.clearA);
    Adder add;
    add.keep(a), add.keep(b);
    for (int k = 0; k < 4; ++k) {
      const double s = std::pow(10, uniform(random, -3, 0.5)), t = std::pow(10, uniform(random, -3, 0.5));
      const SoundRegion kept = add(scaled(a, s), scaled(b, t), Progress::none());
      const SoundRegion plain = sum(scaled(a, s), scaled(b, t), Progress::none(), unlimited);
      different += compareRegions(kept.region, plain.region, 10 * (s + t), plain.tolerance) ? 0 : 1;
    }
  }
  QVERIFY2(different <= 1, qPrintable(QString::number(different)));  // of 80
}

/// Holes of four petals around one corner, drawn in one path in either order: their sides cross there in one of them.
void MinkowskiKeptTest::petalsThatCrossInTheirCorner() {
  const std::vector<std::array<Vec2, 2>> petals{
      {{{6, -2}, {5, -4}}}, {{{1, 2}, {2, 2}}}, {{{-12, 1}, {-9, 7}}}, {{{-1, -5}, {-3, -5}}}};
  const Region small{{polygonPath({{-6, -3}, {3, -3}, {3, 2}, {-6, 2}})}};
  std::vector<Region> shapes;
  for (const bool turned : {false, true}) {
    std::vector<Vec2> corners;
    for (std::size_t k = 0; k < petals.size(); ++k) {
      const auto& petal = petals[turned ? petals.size() - 1 - k : k];
      corners.insert(corners.end(), {{0, 0}, petal[0], petal[1]});
    }
    shapes.push_back(circleRegion(40));
    shapes.back().loops.push_back(polygonPath(corners));
  }
  for (int k = 1; k < 20; ++k) {
    const std::vector<std::vector<double>> time{diagonal(1, k / 20.0)};
    const Region one = morph(std::vector{shapes[0], small}, time).regions.front(),
                 other = morph(std::vector{shapes[1], small}, time).regions.front();
    COMPARE_NEAR(area(one), area(other), 1e-9 * area(other));
    QCOMPARE(one.loops.size(), other.loops.size());
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
      QVERIFY(
          compareRegions(together.regions[k], morph(shapes, std::span(times).subspan(k, 1), coarse).regions.front(), 10, 0));
  }
}

BLOSSOM_TEST(MinkowskiKeptTest)
#include "minkowski_kept_test.moc"
