#include <set>

#include "support/morphology.h"
#include "support/support.h"

using namespace blossom;
using namespace blossom::test;
using namespace blossom::morphology;

namespace {

using Place = std::array<int, 3>;

/// Whether the element stays in the solid from all places within a cell.
bool fills(const std::set<Place>& solid, const std::set<Place>& element, const Place& at) {
  for (const auto& [x, y, z] : element)
    for (int k = 0; k < 8; ++k)
      if (!solid.contains({at[0] + x + (k & 1), at[1] + y + ((k >> 1) & 1), at[2] + z + ((k >> 2) & 1)})) return false;
  return true;
}

/// The volume of {x : x + element inside solid} for solids of unit cells, counted: places x within a cell reach two cells
/// along each axis with each cell of the element.
double roomOf(const std::set<Place>& solid, const std::set<Place>& element) {
  return static_cast<double>(
      std::count_if(solid.begin(), solid.end(), [&](const Place& at) { return fills(solid, element, at); }));
}

Mesh solidOf(const std::set<Place>& cells) {
  Operand corners;
  corners.form = Operand::Form::Points;
  for (const auto& [x, y, z] : cells) corners.pieces.push_back({Vec3(x, y, z)});
  return solidSum(corners, bodyOf(cuboid({0, 0, 0}, {1, 1, 1}))).solids.front();
}

std::set<Place> blockOf(const Place& size) {
  std::set<Place> cells;
  for (int x = 0; x < size[0]; ++x)
    for (int y = 0; y < size[1]; ++y)
      for (int z = 0; z < size[2]; ++z) cells.insert({x, y, z});
  return cells;
}

/// A bridge whose front has a corner a little above its upper edge. The front is one polygon, or three with a needle.
Mesh bridge(double above, bool hasNeedle) {
  const std::vector<Vec2> outline{{-1, 0}, {-0.25, 0}, {-0.25, 0.25}, {0.25, 0.25}, {0.25, 0}, {1, 0}, {1, 1}, {-1, 1}};
  Mesh mesh;
  for (const double y : {0.0, 1.0})
    for (const Vec2& p : outline) mesh.points.emplace_back(p.x(), y, p.y());
  mesh.points.emplace_back(0, 0, 1 + above);
  if (hasNeedle) {
    mesh.addFace(std::array{6, 16, 7});
    mesh.addFace(std::array{0, 1, 2, 3, 4, 5, 6, 7});
  } else {
    mesh.addFace(std::array{0, 1, 2, 3, 4, 5, 6, 16, 7});
  }
  mesh.addFace(std::array{15, 14, 13, 12, 11, 10, 9, 8});
  for (const int k : {0, 1, 2, 3, 4, 5}) mesh.addFace(std::array{k + 1, k, k + 8, k + 9});
  mesh.addFace(std::array{0, 7, 15, 8});
  for (const auto& face : {std::array{16, 6, 14}, {16, 14, 15}, {16, 15, 7}}) mesh.addFace(face);
  return mesh;
}

/// Six teeth, one wide, at gaps of one.
Mesh comb() {
  std::vector<Vec2> outline{{0, 0}, {11, 0}};
  for (int x = 11; x > 0; x -= 2)
    for (const Vec2& p : {Vec2(x, 3), Vec2(x - 1, 3), Vec2(x - 1, 1), Vec2(x - 2, 1)})
      if (p.x() >= 0) outline.push_back(p);
  outline.pop_back();  // the left side goes down to the origin
  outline.emplace_back(0, 3);
  outline.erase(std::unique(outline.begin(), outline.end()), outline.end());
  return prism(outline, 0, 1);
}

}  // namespace

/// Solids that fit into each other exactly, lie within each other, or are thin to the last digit.
class MorphologyExactFitTest : public QObject {
  Q_OBJECT

 private slots:
  // Faces no wider than what rests on them bound nothing: they are left out before they are cut.
  void cellsInCellsThatFitExactly() {
    std::mt19937_64 random = seededRandom();
    std::bernoulli_distribution filled(0.85);
    int compared = 0;
    for (int run = 0; run < 60; ++run) {
      std::set<Place> solid;
      for (const Place& cell : blockOf({4, 4, 4}))
        if (filled(random)) solid.insert(cell);
      std::set<Place> element = blockOf({1 + run % 3, 1 + run % 2, 1});
      if (run % 4 == 3) element.insert({0, 0, 1});
      const double room = roomOf(solid, element);
      if (room == 0) continue;
      ++compared;
      COMPARE_NEAR(volumeOf(solidDifferenceOf(solidOf(solid), solidOf(element))), room, 1e-9);
    }
    QVERIFY(compared > 20);
  }

  void aTurnedCombIsFilledByACube() {
    std::mt19937_64 random = seededRandom();
    for (int run = 0; run < 12; ++run) {
      const Eigen::Matrix3d turn = randomTurn(random);
      const Mesh sum = solidSumOf(turnedBy(comb(), turn), turnedBy(cuboid({0, 0, 0}, {1, 1, 1}), turn));
      COMPARE_NEAR(volumeOf(sum), 12 * 4 * 2, 1e-5);
    }
  }

  // The normal cone of the corner is long and thin, as two of its edges point in nearly opposite directions.
  void needlesLoseNoFaces() {
    const Mesh element = turnedBy(cuboid({-0.25, -0.35, -0.35}, {0.25, 0.35, 0.35}),
                                  Eigen::AngleAxisd(std::numbers::pi / 4, Vec3::UnitX()).toRotationMatrix());
    const Mesh shell = together(cuboid({-5, -5, -5}, {5, 5, 5}), insideOut(cuboid({-4, -4, -4}, {4, 4, 4})));
    for (const double above : {1e-3, 1e-5, 3e-6, 1e-6, 1e-8}) {
      const Mesh needle = bridge(above, true), ridge = bridge(above, false);
      COMPARE_NEAR(volumeOf(solidSumOf(needle, element)), volumeOf(solidSumOf(ridge, element)), 1e-9);
      COMPARE_NEAR(volumeOf(solidSumOf(together(shell, needle), element)),
                   volumeOf(solidSumOf(shell, element)) + volumeOf(solidSumOf(ridge, element)), 1e-9);
    }
  }

  void aBodyWithinABodyAddsNothing() {
    const Mesh outer = cuboid({0, 0, 0}, {10, 10, 10}), inner = cuboid({4, 4, 4}, {6, 6, 6}),
               cube = cuboid({0, 0, 0}, {1, 1, 1});
    const Mesh nested = together(outer, inner);
    COMPARE_NEAR(volumeOf(solidDifferenceOf(nested, cube)), 729, 1e-9);
    COMPARE_NEAR(volumeOf(openingOf(nested, cube)), 1000, 1e-9);
    COMPARE_NEAR(volumeOf(solidSumOf(nested, cube)), 1331, 1e-9);
    COMPARE_NEAR(volumeOf(closingOf(nested, cube)), 1000, 1e-9);
    const auto both = solidDifference(bodyOf(nested), bodyOf(cube));
    QVERIFY(!both.warnings.empty() && both.warnings.front().find("lies within another one") != std::string::npos);
    // A body in a void stays one of its own.
    const Mesh inVoid = together(together(outer, insideOut(cuboid({1, 1, 1}, {9, 9, 9}))), inner);
    COMPARE_NEAR(volumeOf(solidSumOf(inVoid, cube)), 1331 - 343 + 27, 1e-9);
  }

  void smallPartsFarApartAndThinRods() {
    const Mesh cube = cuboid({0, 0, 0}, {1, 1, 1}), far = together(cube, movedBy(cube, {20'000, 0, 0}));
    COMPARE_NEAR(volumeOf(solidSumOf(far, cube)), 16, 1e-9);
    COMPARE_NEAR(volumeOf(solidSumOf(cuboid({0, 0, 0}, {0.01, 0.01, 20'000}), cube)), 1.01 * 1.01 * 20'001, tiny * 20'403);
  }
};

BLOSSOM_TEST(MorphologyExactFitTest)
#include "morphology_exact_fit_test.moc"
