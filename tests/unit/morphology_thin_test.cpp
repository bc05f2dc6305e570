// Thin operands: beside large ones, whose grid is coarse, and so thin that doubles lose their volume.
#include "geometry/shape/bounds.h"
#include "support/exchange.h"
#include "support/morphology.h"
#include "support/random.h"
#include "support/support.h"

using namespace blossom;
using namespace blossom::test;
using namespace blossom::morphology;

namespace {

bool says(const MorphologyResult& made, const char* words) {
  return std::any_of(made.warnings.begin(), made.warnings.end(),
                     [&](const std::string& warning) { return warning.find(words) != std::string::npos; });
}

/// By how much corners are said to have moved, in mm.
double toldMoved(const MorphologyResult& made) {
  const std::string before = "moved by up to ";
  for (const std::string& warning : made.warnings)
    if (const auto at = warning.find(before); at != std::string::npos) return std::stod(warning.substr(at + before.size()));
  return 0;
}

/// Triangles that each have corners of their own.
Mesh soupOf(const Mesh& mesh) {
  Mesh soup;
  for (std::size_t f = 0; f < mesh.faceCount(); ++f) {
    std::vector<int> face;
    for (const int v : mesh.face(f)) {
      face.push_back(static_cast<int>(soup.points.size()));
      soup.points.push_back(mesh.points[static_cast<std::size_t>(v)]);
    }
    soup.addFace(face);
  }
  return soup;
}

Mesh barAlongX(double length) { return cuboid({0, 0, 0}, {length, 1, 1}); }

}  // namespace

class MorphologyThinTest : public QObject {
  Q_OBJECT

 private slots:
  /// A hollow body whose walls fall together on the grid of a large operand.
  void hollowBodiesDoNotVanishInSilence() {
    constexpr double length = 1e6;
    const double ofOne = (length + 1) * 2 * 2;
    int kept = 0;
    for (const double wall : {1e-6, 1e-8, 1e-9, 1e-10, 1e-11}) {  // thinner ones are rounding of the body
      const Mesh two = together(hollowCube(1, wall), cuboid({0, 3, 0}, {1, 4, 1}));
      MorphologyResult made;
      try {
        made = solidSum(bodyOf(two), bodyOf(barAlongX(length)));
      } catch (const Error& error) {
        QVERIFY(error.code() == ErrorCode::InvalidInput);
        continue;
      }
      const bool isThere = std::abs(volumeOf(made.solids.front()) - 2 * ofOne) < 1e-6 * ofOne;
      QVERIFY2(isThere || says(made, "thinner than"), qPrintable(QString("wall %1").arg(wall)));
      kept += isThere;
    }
    QVERIFY(kept >= 4);
  }

  /// Soups of triangles that each have corners of their own are read as meshes that share them.
  void soupsAreReadAsMeshesThatShareCorners() {
    const Mesh two = together(hollowCube(1, 1e-9), cuboid({0, 3, 0}, {1, 4, 1}));
    const MorphologyResult made = solidSum(bodyOf(soupOf(two)), bodyOf(barAlongX(1e6)));
    const MorphologyResult other = solidSum(bodyOf(two), bodyOf(barAlongX(1e6)));
    COMPARE_NEAR(volumeOf(made.solids.front()), volumeOf(other.solids.front()), 1e-6);
    QCOMPARE(made.warnings, other.warnings);
  }

  /// Corners of a soup that differ in their last digits lose nothing when they become one.
  void roundingOfSoupsIsNoLoss() {
    std::mt19937_64 random = seededRandom();
    for (int run = 0; run < 20; ++run) {
      Mesh soup = soupOf(triangulated(turnedBy(movedBy(lBlock(), {1, 1, 1}), randomTurn(random))).first);
      for (Vec3& p : soup.points)
        for (double& x : p)
          for (int k = std::uniform_int_distribution(-2, 2)(random); k != 0; k -= k > 0 ? 1 : -1)
            x = std::nextafter(x, k > 0 ? 10 : -10);
      const MorphologyResult made = solidSum(bodyOf(soup), bodyOf(barAlongX(300)));
      QVERIFY(!says(made, "thinner than"));
    }
  }

  /// Bodies in an array leave gaps of one unit in the last place, which are none.
  void arraysOfBodiesAreOneBody() {
    Mesh row;
    for (int k = 0; k < 20; ++k) row = together(row, cuboid({0, 0, 0.1 * k}, {1, 1, 0.1 * k + 0.1}));
    const MorphologyResult made = solidSum(bodyOf(row), bodyOf(cuboid({0, 0, 0}, {100, 0.1, 0.1})));
    QCOMPARE(made.warnings, std::vector<std::string>());
    QVERIFY(made.stats.way == Way::Prisms || made.stats.way == Way::Hulls);
    COMPARE_NEAR(volumeOf(made.solids.front()), 101 * 1.1 * 2.1, 1e-9);
  }

  /// A thin wall of a prism is there in the sum, also when it is no thicker than some steps of the grid.
  void thinWallsOfPrismsStay() {
    const double step = std::ldexp(1, 10 - 44);  // to which shapes beside one of 1000 are rounded
    for (const double steps : {0.8, 1.0, 1.5, 2.0, 2.5, 3.0, 5.0, 20.0, 1e3}) {
      const double t = steps * step;
      const Mesh thin = prism({{0, 0}, {1, 0}, {1, 0.1}, {t, 0.1}, {t, 1}, {0, 1}}, 0, 0.5);
      const MorphologyResult made = solidSum(bodyOf(thin), bodyOf(cuboid({0, 0, 0}, {0.01, 0.01, 1000})));
      const double section = 1.01 * 0.11 + (0.01 + t) * 0.9;
      const bool isThere = std::abs(volumeOf(made.solids.front()) - 1000.5 * section) < 1e-6;
      QVERIFY2(isThere || says(made, "thinner than"), qPrintable(QString("%1 steps").arg(steps)));
    }
  }

  /// Beside a hollow body, bodies that touch but for rounding count as one.
  void touchingBodiesBesideVoidsAreOne() {
    std::mt19937_64 random = seededRandom();
    for (int run = 0; run < 30; ++run) {
      const Mesh hollow =
          movedBy(together(cuboid({0, 0, 0}, {1, 1, 1}), insideOut(cuboid({0.2, 0.2, 0.2}, {0.8, 0.8, 0.8}))), {5, 0, 0});
      const Mesh pair = together(cuboid({0, 0, 0}, {1, 1, 1}), cuboid({0.3, 0.2, 1}, {1.3, 1.2, 2}));
      const Eigen::Matrix3d turn = randomTurn(random);
      const double far = std::pow(10, uniform(random, 0, 4));
      const Mesh solid = movedBy(turnedBy(together(pair, hollow), turn), far * Vec3(0.7, -0.9, 0.3));
      const Mesh left = solidDifferenceOf(solid, turnedBy(cuboid({0, 0, 0}, {0.4, 0.4, 0.4}), turn));
      COMPARE_NEAR(volumeOf(left), 0.48, 1e-6);
    }
  }

  /// Ends that are off by a step of the grid leave a wide, low prism one.
  void lowPrismsStayPrisms() {
    for (const auto& [side, height] : {std::pair(1.0, 1e-3), std::pair(1000.0, 0.1), std::pair(1.0, 1e-4)}) {
      Mesh low = triangulated(prism({{0, 0}, {side, 0}, {side, side / 2}, {side / 2, side / 2}, {side / 2, side}, {0, side}},
                                    0, height))
                     .first;
      const auto top = std::find_if(low.points.begin(), low.points.end(), [&](const Vec3& p) { return p.z() == height; });
      top->z() += std::ldexp(1, std::ilogb(side) + 1 - 44);
      const MorphologyResult made = solidSum(bodyOf(low), bodyOf(cuboid({0, 0, 0}, {side / 10, side / 10, height})));
      QVERIFY(made.stats.way == Way::Prisms);
    }
  }

  /// An L of some 1e-10 mm, 10 mm long: doubles do not know the sign of its volume.
  void needlesAreNoBodiesInsideOut() {
    std::mt19937_64 random = seededRandom();
    for (int run = 0; run < 40; ++run) {
      const double width = std::pow(10, uniform(random, -10, -8));
      const Mesh profile =
          prism({{0, 0}, {2 * width, 0}, {2 * width, width}, {width, width}, {width, 2 * width}, {0, 2 * width}}, 0, 10);
      const Eigen::Matrix3d turn = randomTurn(random);
      const MorphologyResult made = solidSum(bodyOf(turnedBy(profile, turn)), bodyOf(cuboid({0, 0, 0}, {1, 1, 1})));
      QVERIFY(!says(made, "inside out"));
      const Vec3 along = 10 * turn.col(2);
      const double swept = 1 + along.cwiseAbs().sum();  // of the cube along a segment
      COMPARE_NEAR(volumeOf(made.solids.front()), swept, 1e-6);
    }
  }

  /// Bodies that touch but for rounding grow a little when they are made one: by how much is told where it is much.
  void growthOfTouchingBodiesIsTold() {
    const Mesh toRound = *readShape(formats(), sourceFolder() / "tests/fixtures/nearly_closed_corner.off").shape.get<Mesh>();
    Mesh point;
    point.points = {{0, 0, 0}};
    for (const double gap : {2e-10, 3e-10, 4e-10}) {
      const Mesh pair =
          movedBy(together(cuboid({0, 0, 0}, {0.5, 0.5, 0.5}), cuboid({0, 0, 0.5 + gap}, {0.5, 0.5, 1})), {0.3, 0.3, 2.6});
      const MorphologyResult made = solidDifference(bodyOf(together(toRound, pair)), bodyOf(point));
      const double grown = bounds(made.solids.front()).high.z() - bounds(pair).high.z(), told = toldMoved(made);
      QVERIFY(grown > 0);
      QVERIFY2(grown <= told && told <= 10 * grown, qPrintable(QString("grown by %1, told %2").arg(grown).arg(told)));
    }
  }
};

BLOSSOM_TEST(MorphologyThinTest)
#include "morphology_thin_test.moc"
