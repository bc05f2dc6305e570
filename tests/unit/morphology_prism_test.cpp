/// Prisms along one axis: their sums are planar. Beside closed forms, what CGAL's own sum makes of them and what the solids
/// make when they are turned out of the axes, which is another way.
#include "core/stopwatch.h"
#include "geometry/planar/sums/polygon_sum.h"
#include "morphology/kernel/prisms/prism.h"
#include "support/morphology.h"
#include "support/solid_peer.h"
#include "support/support.h"

using namespace blossom;
using namespace blossom::test;
using namespace blossom::morphology;

namespace {

std::vector<Vec2> starOutline(int tips, double outer, double inner) {
  std::vector<Vec2> corners;
  for (int k = 0; k < 2 * tips; ++k) {
    const double angle = std::numbers::pi * k / tips, radius = k % 2 == 0 ? outer : inner;
    corners.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
  }
  return corners;
}

using PairMaker = MorphologyResult (*)(const Operand&, const Operand&, const Progress&);

MorphologyResult sumOfTwo(const Operand& a, const Operand& b, const Progress& p) { return solidSum(a, b, p); }

struct Case {
  const char* name;
  PairMaker make;
};

const std::vector<Case> operations{
    {"sum", sumOfTwo}, {"difference", solidDifference}, {"opening", solidOpening}, {"closing", solidClosing}};

const std::vector<Vec2> lOutline{{0, 0}, {6, 0}, {6, 2}, {2, 2}, {2, 5}, {0, 5}};
const std::vector<Vec2> uOutline{{0, 0}, {7, 0}, {7, 4}, {5, 4}, {5, 2}, {3, 2}, {3, 5}, {0, 5}};
const std::vector<Vec2> smallTriangle{{0, 0}, {1.25, 0.25}, {0.25, 0.75}};

}  // namespace

class MorphologyPrismTest : public QObject {
  Q_OBJECT

 private slots:
  void solidsAreRecognised() {
    const Mesh star = prism(starOutline(5, 10, 4), -2, 3);
    for (int axis = 0; axis < 3; ++axis) {
      Mesh turned = along(axis, star);
      const double step = 0x1p-38;
      for (Vec3& p : turned.points)
        for (int k = 0; k < 3; ++k) p[k] = step * std::nearbyint(p[k] / step);
      const std::vector<Prism> found = prismsOf(triangulated(turned).first, step);
      QCOMPARE(found.size(), std::size_t{1});
      QCOMPARE(found[0].axis, axis);
      QVERIFY(found[0].low == -2 && found[0].high == 3);
      COMPARE_NEAR(planar::area(found[0].section), volumeOf(star) / 5, 1e-9);
      COMPARE_NEAR(volumeOf(trianglesOf(found[0])), volumeOf(star), 1e-9);
    }
    QCOMPARE(prismsOf(triangulated(cuboid({0, 0, 0}, {1, 2, 3})).first, 0x1p-40).size(), std::size_t{3});
    QVERIFY(prismsOf(triangulated(cornerTetrahedron()).first, 0x1p-40).empty());
    QVERIFY(prismsOf(triangulated(ballOf(2)).first, 0x1p-40).empty());
  }

  void allOperationsAreThoseOfTurnedSolids() {
    std::mt19937_64 random = seededRandom();
    const Mesh element = prism(smallTriangle, 0.25, 0.75);
    for (const std::vector<Vec2>& outline : {lOutline, uOutline})
      for (const Case& operation : operations)
        for (int axis = 0; axis < 3; ++axis) {
          const Mesh a = along(axis, prism(outline, 1, 3)), b = along(axis, element);
          const MorphologyResult flat = operation.make(bodyOf(a), bodyOf(b), Progress::none());
          QVERIFY2(flat.stats.way == Way::Prisms, operation.name);
          if (axis != 0) continue;
          const Eigen::Matrix3d turn = randomTurn(random);
          const MorphologyResult turned =
              operation.make(bodyOf(turnedBy(a, turn)), bodyOf(turnedBy(b, turn)), Progress::none());
          QVERIFY(turned.stats.way != Way::Prisms);
          const Mesh &made = flat.solids.front(), &other = turned.solids.front();
          COMPARE_NEAR(volumeOf(made), volumeOf(other), tiny * volumeOf(other));
          COMPARE_NEAR(area(triangulated(made).first), area(triangulated(other).first),
                       tiny * area(triangulated(other).first));
          QVERIFY(meshTopology(made).closed());
          QCOMPARE(made.faceCount(), other.faceCount());
        }
  }

  /// The planar sum has 16 sides or more: 128 s by convex parts.
  void starsAreWhatCgalMakes() {
    const Mesh a = prism(starOutline(5, 10, 4), 0, 3), b = prism(starOutline(7, 8, 5), -1, 1);
    Stopwatch watch;
    const MorphologyResult made = solidSum(bodyOf(a), bodyOf(b));
    qInfo("figure stars_ms %.3g", watch.lapMs());
    QVERIFY(made.stats.way == Way::Prisms);
    const Mesh cgal = sumByNef(triangulated(a).first, triangulated(b).first);
    qInfo("figure stars_nef_ms %.3g", watch.lapMs());
    const double volume = volumeOf(cgal);
    COMPARE_NEAR(volumeOf(made.solids.front()), volume, tiny * volume);
    COMPARE_NEAR(areaOf(made.solids.front()), areaOf(cgal), tiny * areaOf(cgal));
  }

  void aMorphIsOneOfSections() {
    const Mesh a = prism(starOutline(5, 10, 4), 0, 3), b = prism(starOutline(7, 8, 5), -1, 1);
    const std::vector<double> weights{0, 0.25, 0.5, 0.75, 1};
    const MorphologyResult morph = morphOf(a, b, weights);
    QVERIFY(morph.stats.way == Way::Prisms);
    for (std::size_t k = 0; k < weights.size(); ++k) {
      const double w = weights[k];
      const auto section = [&](int tips, double outer, double inner, double by) {
        return planar::scaled({{starOutline(tips, outer, inner), {}}}, by);
      };
      const double flat = w == 0   ? planar::area(section(5, 10, 4, 1))
                          : w == 1 ? planar::area(section(7, 8, 5, 1))
                                   : planar::area(planar::sum(section(5, 10, 4, 1 - w), section(7, 8, 5, w)));
      const double expected = flat * ((1 - w) * 3 + w * 2);
      COMPARE_NEAR(volumeOf(morph.solids[k]), expected, tiny * expected);
    }
  }

  /// A frame: what goes round a hole goes into it, and a slot that is as wide as the element closes.
  void holesAndSlotsClose() {
    const Mesh frame = withHole(10, 4, 2);
    const Mesh block = cuboid({0, 0, 0}, {3.5, 3.5, 1}), plug = cuboid({0, 0, 0}, {4, 4, 1});
    const auto sumWith = [&](const Mesh& b) { return solidSum(bodyOf(frame), bodyOf(b)).solids.front(); };
    COMPARE_NEAR(volumeOf(sumWith(block)), (13.5 * 13.5 - 0.25) * 3, 1e-9);
    COMPARE_NEAR(volumeOf(sumWith(plug)), 14 * 14 * 3, 1e-9);
    VERIFY_ERROR(solidDifference(bodyOf(frame), bodyOf(plug)), ErrorCode::Degenerate);
    VERIFY_ERROR(solidDifference(bodyOf(block), bodyOf(cuboid({0, 0, 0}, {1, 1, 1}))), ErrorCode::Degenerate);
  }

 private:
  /// A square plate of that side about the origin with a square hole.
  static Mesh withHole(double side, double hole, double height) {
    const Loop outer{{-side / 2, -side / 2}, {side / 2, -side / 2}, {side / 2, side / 2}, {-side / 2, side / 2}};
    const Loop inner{{-hole / 2, -hole / 2}, {-hole / 2, hole / 2}, {hole / 2, hole / 2}, {hole / 2, -hole / 2}};
    return trianglesOf({2, {{outer, {inner}}}, 0, height});
  }
  using Loop = planar::Loop;
};

BLOSSOM_TEST(MorphologyPrismTest)
#include "morphology_prism_test.moc"
