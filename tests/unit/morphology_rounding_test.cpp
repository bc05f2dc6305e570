#include "geometry/mesh/mesh_crossing.h"
#include "geometry/mesh/mesh_topology.h"
#include "morphology/kernel/collapsed.h"
#include "morphology/kernel/finished.h"
#include "support/exchange.h"
#include "support/morphology.h"
#include "support/solid_peer.h"
#include "support/support.h"

using namespace blossom;
using namespace blossom::test;
using namespace blossom::morphology;

namespace {

/// The unit cube with the middle of its top pushed down.
Mesh dentedCube(double depth) {
  const Mesh cube = cuboid({0, 0, 0}, {1, 1, 1});
  Mesh mesh;
  mesh.points = cube.points;
  mesh.points.emplace_back(0.5, 0.5, 1 - depth);
  for (std::size_t f = 0; f < cube.faceCount(); ++f) {
    const auto face = cube.face(f);
    if (f != 1) {
      mesh.addFace(face);
      continue;
    }
    for (std::size_t k = 0; k < 4; ++k) mesh.addFace(std::array{face[k], face[(k + 1) % 4], 8});
  }
  return mesh;
}

/// A block with a slot of this width from above.
Mesh slotted(double width) {
  return prism({{-2, 0}, {2, 0}, {2, 3}, {width / 2, 3}, {width / 2, 1}, {-width / 2, 1}, {-width / 2, 3}, {-2, 3}}, 0, 1);
}

/// Nothing where that is refused.
std::optional<Finished> finishedOrRefused(const Mesh& triangles) {
  try {
    return finished(triangles, Vec3::Zero(), Slivers::Go, Progress::none());
  } catch (const CannotBeRounded&) {
    return std::nullopt;
  }
}

/// Volumes of the shells, below 0 for those that look inwards.
std::vector<double> shellVolumes(const Mesh& polygons) {
  const Mesh mesh = triangulated(polygons).first;
  const MeshTopology topology = meshTopology(mesh);
  std::vector<double> volumes(topology.components.size());
  for (std::size_t f = 0; f < mesh.faceCount(); ++f) {
    const auto at = [&](std::size_t k) -> const Vec3& { return mesh.points[static_cast<std::size_t>(mesh.face(f)[k])]; };
    volumes[static_cast<std::size_t>(topology.componentOfFace[f])] += at(0).dot(at(1).cross(at(2))) / 6;
  }
  return volumes;
}

}  // namespace

/// What rounding to a grid and to doubles does, and does not, to results.
class MorphologyRoundingTest : public QObject {
  Q_OBJECT

 private slots:
  // A square moved about over a dent of the form of a pyramid leaves a smaller one, lower by as much.
  void aShallowDentStays() {
    for (const double depth : {1e-3, 5e-11}) {
      const Mesh cube = dentedCube(depth);
      const double side = 0.25;  // powers of two: the volume of the undented sum is a double
      const Mesh sum = solidSumOf(cube, cuboid({0, 0, 0}, {side, side, side}));
      const double whole = std::pow(1 + side, 3), left = depth * std::pow(1 - side, 3) / 3;
      const double grid = std::ldexp(1, -44);  // half a step: so far may the middle of the dent have been moved
      COMPARE_NEAR(whole - volumeOf(sum), left, grid * std::pow(1 - side, 3) / 3 + 1e-15);
      QVERIFY(sum.faceCount() > 6);
    }
  }

  void resultsCrossNowhere() {
    std::mt19937_64 random = seededRandom();
    for (int k = 0; k < 2; ++k) {
      const Mesh a = turnedBy(lBlock(), randomTurn(random));
      const Mesh b = k % 2 == 0 ? spikyCube(random, 1) : turnedBy(cuboid({0, 0, 0}, {1, 0.5, 0.25}), randomTurn(random));
      QVERIFY(!firstCrossing(solidSumOf(a, b)));
      QVERIFY(!firstCrossing(solidDifferenceOf(scaledBy(a, 3), b)));
    }
  }

  // Where the corners cannot hold a detail, it is closed, and said; what cannot be closed is refused.
  void whatRoundingMakesCrossIsSnapped() {
    const Mesh triangles = triangulated(slotted(1e-9)).first;
    QCOMPARE(finished(triangles, Vec3::Zero(), Slivers::Go, Progress::none()).loss.sentences(), std::string());
    const Vec3 far(1e8, 1e8, 0);  // doubles lie 1.5e-8 apart here
    const Finished snapped = finished(triangles, far, Slivers::Go, Progress::none());
    QVERIFY(!firstCrossing(snapped.mesh));
    COMPARE_NEAR(volumeOf(movedBy(snapped.mesh, -far)), 12, 1e-6);
    QVERIFY(snapped.loss.sentences().starts_with("Corners have been moved by up to "));
    VERIFY_ERROR(finished(scaledBy(triangles, 1e-9), far, Slivers::Go, Progress::none()), ErrorCode::Degenerate);
  }

  // Far from the origin, doubles turn thin plates inside out: those are gone, and said.
  void whatRoundingMayTurnIsLeftOut() {
    std::mt19937_64 random = seededRandom();
    const Vec3 far(1e8, -1e8, 1e8);  // doubles lie 1.5e-8 apart here
    int leftOut = 0, kept = 0;
    for (int run = 0; run < 60; ++run) {
      const double thickness = std::pow(10, std::uniform_real_distribution<double>(-10, -6)(random));
      const Mesh plate = movedBy(turnedBy(cuboid({0, 0, 0}, {1, 1, thickness}), randomTurn(random)), {3, 0, 0});
      const Mesh both = triangulated(together(cuboid({0, 0, 0}, {1, 1, 1}), plate)).first;
      const Finished made = finished(both, far, run % 2 == 0 ? Slivers::Go : Slivers::Stay, Progress::none());
      const std::vector<double> volumes = shellVolumes(movedBy(made.mesh, -far));
      QVERIFY(std::all_of(volumes.begin(), volumes.end(), [](double volume) { return volume > 0; }));
      const bool isSaid = made.loss.sentences().find("Bodies, voids, walls or gaps thinner than ") != std::string::npos;
      QCOMPARE(volumes.size(), std::size_t{isSaid ? 1U : 2U});
      if (thickness > 2e-7) QVERIFY(!isSaid);
      ++(isSaid ? leftOut : kept);
    }
    QVERIFY(leftOut > 5 && kept > 5);
  }

  // Bodies with walls on each other but for rounding are made one on coarser grids. A plate beside them is thinner than such
  // a grid, or not: it never stays as sheets back to back, nor inside out.
  void noGridTurnsAPlate() {
    std::mt19937_64 random = seededRandom();
    for (int run = 0; run < 40; ++run) {
      const double thickness = std::pow(10, std::uniform_real_distribution<double>(-13, -8)(random));
      const double apart = std::pow(10, std::uniform_real_distribution<double>(-16, -9)(random)) * (run % 2 == 0 ? 1 : -1);
      const double along = std::uniform_real_distribution<double>(-0.5, 0.5)(random);
      const Mesh blocks = together(cuboid({0, 0, 0}, {1, 1, 1}), cuboid({along, 0.1, 1 + apart}, {1 + along, 0.8, 2}));
      const Mesh plate = movedBy(turnedBy(cuboid({0, 0, 0}, {1, 1, thickness}), randomTurn(random)), {4, 0, 0});
      const Mesh all = triangulated(turnedBy(together(blocks, plate), randomTurn(random))).first;
      const std::optional<Finished> made = finishedOrRefused(all);
      if (!made) continue;
      const std::vector<double> volumes = shellVolumes(made->mesh);
      QVERIFY(std::all_of(volumes.begin(), volumes.end(), [](double volume) { return volume > 0; }));
      QVERIFY(!firstCrossing(made->mesh));
      COMPARE_NEAR(volumeOf(made->mesh), 1.7, 1e-7);
    }
  }

  // Closings and openings leave sheets that lie on each other but for rounding, beside which thin bodies, gaps, slots and
  // fins are as thin as what these are made of. Nothing flat, turned or crossing remains.
  void thinDetailsNeverTurn() {
    std::mt19937_64 random = seededRandom();
    const auto bumpy = [&](Mesh ball, double share) {
      std::uniform_real_distribution<double> factor(1 - share, 1 + share);
      for (Vec3& p : ball.points) p *= factor(random);
      return triangulated(ball).first;
    };
    for (int run = 0; run < 8; ++run) {
      const double thin = std::pow(10, std::uniform_real_distribution<double>(-12, -8)(random)), half = thin / 2;
      const std::vector<Mesh> details{
          cuboid({0, 0, 0}, {1, 1, thin}), together(cuboid({0, 0, 0}, {2, 2, 1}), cuboid({0, 0, 1 + thin}, {2, 2, 2})),
          slotted(thin), prism({{-2, 0}, {2, 0}, {2, 1}, {half, 1}, {half, 3}, {-half, 3}, {-half, 1}, {-2, 1}}, 0, 1)};
      const Mesh detail = turnedBy(details[static_cast<std::size_t>(run) % details.size()], randomTurn(random));
      const Mesh solid = triangulated(together(bumpy(ballOf(3, 2), 0.1), movedBy(detail, {8, 0, 0}))).first;
      const Mesh element = bumpy(ballOf(0.7, 1), 0.2);
      for (const Mesh& made : {closingOf(solid, element), openingOf(solid, element)}) {
        const std::vector<double> volumes = shellVolumes(made);
        QVERIFY2(std::all_of(volumes.begin(), volumes.end(), [](double volume) { return volume > 0; }),
                 qPrintable(QString::number(thin)));
        QVERIFY(!firstCrossing(made));
      }
    }
  }

  // A plate of two triangles and a polygon with another corner: nothing is between them.
  void sheetsOnEachOtherGo() {
    Mesh sheets;
    sheets.points = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
    sheets.addFace(std::array{0, 1, 2, 3});
    sheets.addFace(std::array{2, 1, 0});
    sheets.addFace(std::array{0, 3, 2});
    QVERIFY(meshTopology(sheets).closed());
    QVERIFY(firstCrossing(sheets));
    QCOMPARE(collapsed(triangulated(sheets).first).faceCount(), std::size_t{0});
    VERIFY_ERROR(finished(triangulated(sheets).first, Vec3::Zero(), Slivers::Stay, Progress::none()), ErrorCode::Degenerate);
  }

  // An open sheet beside a body has no volume, and is no thin body to be left out; triangles with corners of their own
  // close.
  void openSheetsAreRefusedOnGrids() {
    const Mesh cube = triangulated(cuboid({0, 0, 0}, {1, 1, 1})).first;
    Mesh sheet, soup;
    sheet.points = {{3, 0, 0}, {4, 0, 0}, {3, 1, 0}};
    sheet.addFace(std::array{0, 1, 2});
    QVERIFY(!onCoarserGrid(together(cube, sheet), 1e-12));
    for (std::size_t f = 0; f < cube.faceCount(); ++f) {
      const int from = static_cast<int>(soup.points.size());
      for (const Vec3& p : facePoints(cube, f)) soup.points.push_back(p);
      soup.addFace(std::array{from, from + 1, from + 2});
    }
    const auto closed = onCoarserGrid(soup, 1e-12);
    QVERIFY(closed);
    COMPARE_NEAR(volumeOf(closed->triangles), 1, 1e-12);
  }

  // Coarser grids close what is open by less than they round; sheets that would vanish there are refused.
  void cracksAreClosedAndSheetsAreNot() {
    std::mt19937_64 random = seededRandom();
    Mesh point;
    point.points = {{0, 0, 0}};
    for (const double wide : {1e-10, 1e-8, 1e-7}) {
      const Eigen::Matrix3d turn = randomTurn(random);
      Mesh cracked = triangulated(cuboid({0, 0, 0}, {1, 1, 1})).first;
      cracked.points.push_back(cracked.points[static_cast<std::size_t>(cracked.face(0)[0])] + wide * Vec3(1, 0.7, -0.3));
      cracked.faceVertices[0] = static_cast<int>(cracked.points.size()) - 1;
      const MorphologyResult closed = solidSum(bodyOf(turnedBy(cracked, turn)), bodyOf(point));
      COMPARE_NEAR(volumeOf(closed.solids.front()), 1, 50 * wide);
      QCOMPARE(closed.warnings.size(), std::size_t{1});
      QVERIFY(closed.warnings.front().find("was open: its corners have been rounded to") != std::string::npos);
      for (const double side : {1.0, 0.01}) {
        Mesh sheets;
        for (const double z : {0.0, wide})
          for (const Vec2& p : {Vec2(0, 0), Vec2(1, 0), Vec2(1, 1), Vec2(0, 1)})
            sheets.points.emplace_back(3 + side * p.x(), side * p.y(), z);
        sheets.addFace(std::array{0, 3, 2, 1});
        sheets.addFace(std::array{4, 5, 6, 7});
        const Mesh both = turnedBy(together(cuboid({0, 0, 0}, {1, 1, 1}), sheets), turn);
        VERIFY_ERROR(solidSum(bodyOf(both), bodyOf(point)), ErrorCode::InvalidInput);
      }
    }
  }

  // A closing left steps of 1e-13 mm in a corner, which on any grid fall into faces without area: nearly one, they are made
  // one.
  void stepsOfRoundingInAnOperandAreMadeOne() {
    const Mesh given = *readShape(formats(), sourceFolder() / "tests/fixtures/nearly_closed_corner.off").shape.get<Mesh>();
    const Mesh element = scaledBy(
        turnedBy(cuboid({0, 0, 0}, {1, 2, 3}), Eigen::AngleAxisd(0.4, Vec3(1, 2, 3).normalized()).toRotationMatrix()), 0.1);
    const MorphologyResult made = solidSum(bodyOf(given), bodyOf(element));
    QVERIFY(!firstCrossing(made.solids.front()));
    const Mesh block = prism({{0, 0}, {3.6, 0}, {3.6, 3.6}, {0, 3.6}}, 0, 1.8);
    QVERIFY(volumeOf(made.solids.front()) > volumeOf(given) &&
            volumeOf(made.solids.front()) < volumeOf(solidSumOf(block, element)));
    QCOMPARE(made.warnings.size(), std::size_t{1});
    QVERIFY(made.warnings.front().find("has been rounded to") != std::string::npos);
    // A hollow body with walls as thin as that is not left out in silence.
    const double wall = 2e-11;
    const Mesh hollow =
        together(cuboid({0.5, 0.5, 2.3}, {1.5, 1.5, 3.3}),
                 insideOut(cuboid(Vec3(0.5, 0.5, 2.3) + Vec3::Constant(wall), Vec3(1.5, 1.5, 3.3) - Vec3::Constant(wall))));
    VERIFY_ERROR(solidSum(bodyOf(together(given, hollow)), bodyOf(element)), ErrorCode::InvalidInput);
  }

  // What doubles hold exactly is not thin, however far it lies from the origin.
  void exactPlacesStay() {
    const double thickness = std::ldexp(1, -24);
    const Mesh plate = triangulated(cuboid({0, 0, 0}, {1, 1, thickness})).first;
    const Vec3 far(std::ldexp(1, 27), 0, 0);
    const Finished made = finished(plate, far, Slivers::Go, Progress::none());
    QCOMPARE(made.loss.sentences(), std::string());
    COMPARE_NEAR(shellVolumes(movedBy(made.mesh, -far)).front(), thickness, 1e-9 * thickness);
  }

  // The areas of the triangles that a comb is fanned into are a hundred times that of its side.
  void combsAreAsThickAsTheyAre() {
    std::vector<Vec2> outline{{0, 0}};
    constexpr int teeth = 200;
    for (int k = teeth; k-- > 0;)
      for (const Vec2& p : {Vec2(k + 0.75, 0), Vec2(k + 0.75, 10), Vec2(k + 0.25, 10), Vec2(k + 0.25, 0)})
        outline.push_back(p);
    std::reverse(outline.begin() + 1, outline.end());
    outline.emplace_back(teeth, 0);
    outline.emplace_back(teeth, -1);
    outline.emplace_back(0, -1);
    std::reverse(outline.begin(), outline.end());
    const double thin = 4e-10;
    const Mesh comb = prism(outline, 0, thin);
    const double volume = std::abs(volumeOf(comb));
    const Mesh both = together(volumeOf(comb) < 0 ? insideOut(comb) : comb, cuboid({0, 20, 0}, {10, 30, 10}));
    const Finished made = finished(triangulated(both).first, Vec3::Zero(), Slivers::Go, Progress::none());
    std::vector<double> volumes = shellVolumes(made.mesh);
    std::sort(volumes.begin(), volumes.end());
    QCOMPARE(volumes.size(), std::size_t{2});
    COMPARE_NEAR(volumes.front(), volume, 1e-3 * volume);
    QCOMPARE(made.loss.sentences(), std::string());
  }

  void theSameSolidGivesTheSameMesh() {
    std::mt19937_64 random = seededRandom();
    const Mesh solid = triangulated(slotted(1)).first;
    const Mesh first = finished(solid, Vec3::Zero(), Slivers::Go, Progress::none()).mesh;
    for (int k = 0; k < 5; ++k) {
      // Other numbers, other orders, other first corners.
      std::vector<int> number(solid.points.size());
      std::iota(number.begin(), number.end(), 0);
      std::shuffle(number.begin(), number.end(), random);
      std::vector<std::size_t> order(solid.faceCount());
      std::iota(order.begin(), order.end(), std::size_t{0});
      std::shuffle(order.begin(), order.end(), random);
      Mesh shuffled;
      shuffled.points.resize(solid.points.size());
      for (std::size_t v = 0; v < number.size(); ++v) shuffled.points[static_cast<std::size_t>(number[v])] = solid.points[v];
      for (const std::size_t f : order) {
        std::vector<int> face;
        for (const int v : solid.face(f)) face.push_back(number[static_cast<std::size_t>(v)]);
        std::rotate(face.begin(), face.begin() + k % 3, face.end());
        shuffled.addFace(face);
      }
      QVERIFY(finished(shuffled, Vec3::Zero(), Slivers::Go, Progress::none()).mesh == first);
    }
  }

  void whatCgalMakesGivesTheSameMesh() {
    const Mesh l = lBlock(), frame = frameBlock(3, 1, 0, 2);
    for (const Mesh& b : {cornerTetrahedron(), cuboid({0, 0, 0}, {0.5, 0.25, 1}), lBlock()})
      for (const Mesh& a : {l, frame}) {
        const Mesh one = solidSum(bodyOf(a), bodyOf(b)).solids.front();
        const Mesh theirs = sumByNef(triangulated(a).first, triangulated(b).first);
        const Mesh other = finished(theirs, Vec3::Zero(), Slivers::Go, Progress::none()).mesh;
        COMPARE_NEAR(volumeOf(one), volumeOf(other), 1e-12 * volumeOf(one));
        QVERIFY(one == other);
      }
  }
};

BLOSSOM_TEST(MorphologyRoundingTest)
#include "morphology_rounding_test.moc"
