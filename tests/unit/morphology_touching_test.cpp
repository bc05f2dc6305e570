#include <array>
#include <set>

#include "geometry/mesh/mesh_crossing.h"
#include "support/morphology.h"
#include "support/support.h"

using namespace blossom;
using namespace blossom::test;
using namespace blossom::morphology;

namespace {

using Cell = std::array<int, 3>;

/// Solids of unit cells, which touch along edges and in corners wherever cells do.
std::set<Cell> randomCells(std::mt19937_64& random, int side) {
  std::bernoulli_distribution filled(0.55);
  std::set<Cell> cells;
  for (int x = 0; x < side; ++x)
    for (int y = 0; y < side; ++y)
      for (int z = 0; z < side; ++z)
        if (filled(random)) cells.insert({x, y, z});
  if (cells.empty()) cells.insert({0, 0, 0});
  return cells;
}

Mesh unitCell() { return cuboid({0, 0, 0}, {1, 1, 1}); }

/// Points plus one cell: a result of our own.
Mesh solidOfCells(const std::set<Cell>& cells, const Vec3& origin) {
  Operand corners;
  corners.form = Operand::Form::Points;
  for (const auto& [x, y, z] : cells) corners.pieces.push_back({origin + Vec3(x, y, z)});
  return solidSum(corners, bodyOf(unitCell())).solids.front();
}

/// The same cells as halves in every direction.
std::set<Cell> halves(const std::set<Cell>& cells) {
  std::set<Cell> result;
  for (const auto& [x, y, z] : cells)
    for (int k = 0; k < 8; ++k) result.insert({2 * x + (k & 1), 2 * y + ((k >> 1) & 1), 2 * z + ((k >> 2) & 1)});
  return result;
}

struct Block {
  Cell low, high;
};

/// Cuts a block in two, and these again, and leaves out every fourth of what stays whole.
void cutUp(const Block& block, std::mt19937_64& random, std::vector<Block>& blocks) {
  const auto axis = std::uniform_int_distribution<std::size_t>(0, 2)(random);
  const int length = block.high[axis] - block.low[axis];
  if (length == 1 || std::bernoulli_distribution(0.2)(random)) {
    if (std::bernoulli_distribution(0.75)(random)) blocks.push_back(block);
    return;
  }
  Block first = block, second = block;
  first.high[axis] = second.low[axis] = block.low[axis] + std::uniform_int_distribution(1, length - 1)(random);
  cutUp(first, random, blocks);
  cutUp(second, random, blocks);
}

/// Volume of cells + [0, 1/2]^3, counted.
double volumeOfSum(const std::set<Cell>& cells) {
  std::set<Cell> result;
  for (const auto& [x, y, z] : halves(cells))
    for (int k = 0; k < 8; ++k) result.insert({x + (k & 1), y + ((k >> 1) & 1), z + ((k >> 2) & 1)});
  return static_cast<double>(result.size()) / 8;
}

/// Volume of cells - [0, 1/2]^3, counted: all eight halves that a cube from within a half reaches are there.
double volumeOfDifference(const std::set<Cell>& cells) {
  const std::set<Cell> all = halves(cells);
  const auto stays = [&](const Cell& c) {
    for (int k = 0; k < 8; ++k)
      if (!all.contains({c[0] + (k & 1), c[1] + ((k >> 1) & 1), c[2] + ((k >> 2) & 1)})) return false;
    return true;
  };
  return static_cast<double>(std::count_if(all.begin(), all.end(), stays)) / 8;
}

/// A ring of eight cells without the last corner: its ends touch along the edge at (2, 2).
std::set<Cell> openRing() { return {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 1, 0}, {2, 1, 0}, {0, 2, 0}, {1, 2, 0}}; }

std::string refusalOf(const std::function<void()>& work) {
  try {
    work();
  } catch (const Error& error) {
    return error.message();
  }
  return {};
}

}  // namespace

/// Solids that touch themselves along edges and in corners, as results and as operands.
class MorphologyTouchingTest : public QObject {
  Q_OBJECT

 private slots:
  void aResultThatTouchesItselfIsAnOperand() {
    const Vec3 origin(10, 20, 30);
    const Mesh ring = solidOfCells(openRing(), origin);
    COMPARE_NEAR(volumeOf(ring), 7, 1e-12);
    QVERIFY(!firstCrossing(ring));
    const Mesh half = cuboid({0, 0, 0}, {0.5, 0.5, 0.5});
    COMPARE_NEAR(volumeOf(solidSumOf(ring, half)), volumeOfSum(openRing()), 1e-12);
    COMPARE_NEAR(volumeOf(solidDifferenceOf(ring, half)), volumeOfDifference(openRing()), 1e-12);
    COMPARE_NEAR(volumeOf(solidSumOf(half, ring)), volumeOfSum(openRing()), 1e-12);
    COMPARE_NEAR(volumeOf(morphOf(ring, half, {0}).solids.front()), 7, 1e-12);
  }

  void cellsThatTouchAnyhow() {
    std::mt19937_64 random = seededRandom();
    const Mesh half = cuboid({0, 0, 0}, {0.5, 0.5, 0.5});
    for (int k = 0; k < 20; ++k) {
      const std::set<Cell> cells = randomCells(random, k < 3 ? 2 : 3);
      const Mesh solid = solidOfCells(cells, {-1, -1, -1});
      COMPARE_NEAR(volumeOf(solid), static_cast<double>(cells.size()), 1e-12);
      QVERIFY(!firstCrossing(solid));
      COMPARE_NEAR(volumeOf(solidSumOf(solid, half)), volumeOfSum(cells), 1e-10);
      if (volumeOfDifference(cells) > 0)
        COMPARE_NEAR(volumeOf(solidDifferenceOf(solid, half)), volumeOfDifference(cells), 1e-10);
    }
  }

  /// Hollows within a block, which touch one another along edges and in corners.
  void hollowsThatTouchOneAnother() {
    for (const std::vector<Cell>& hollows : std::vector<std::vector<Cell>>{{{1, 1, 1}, {2, 2, 1}},
                                                                           {{1, 1, 1}, {2, 2, 2}},
                                                                           {{1, 1, 1}, {1, 2, 2}, {3, 2, 1}},
                                                                           {{1, 1, 1}, {2, 1, 1}, {2, 2, 2}, {1, 2, 2}}}) {
      std::set<Cell> cells;
      for (int x = 0; x < 5; ++x)
        for (int y = 0; y < 4; ++y)
          for (int z = 0; z < 4; ++z) cells.insert({x, y, z});
      for (const Cell& hollow : hollows) cells.erase(hollow);
      const Mesh solid = solidOfCells(cells, {0, 0, 0});
      const Mesh half = cuboid({0, 0, 0}, {0.5, 0.5, 0.5});
      COMPARE_NEAR(volumeOf(solidSumOf(solid, half)), volumeOfSum(cells), 1e-9);
      COMPARE_NEAR(volumeOf(solidDifferenceOf(solid, half)), volumeOfDifference(cells), 1e-9);
    }
  }

  /// Each cell with all of its six walls, as an assembly of bricks comes from a file.
  void bricksThatShareWallsAreOneSolid() {
    std::mt19937_64 random = seededRandom();
    for (int run = 0; run < 10; ++run) {
      const std::set<Cell> cells = randomCells(random, 3);
      Mesh bricks;
      for (const auto& [x, y, z] : cells) bricks = together(bricks, cuboid(Vec3(x, y, z), Vec3(x + 1, y + 1, z + 1)));
      COMPARE_NEAR(volumeOf(solidSumOf(bricks, cuboid({0, 0, 0}, {0.5, 0.5, 0.5}))), volumeOfSum(cells), 1e-9);
    }
  }

  /// Blocks of a block that was cut up, some left out: they touch in parts of faces, flush on some sides only.
  void blocksOfManySizesAreOneSolid() {
    std::mt19937_64 random = seededRandom();
    for (int run = 0; run < 40; ++run) {
      std::vector<Block> blocks;
      cutUp({{0, 0, 0}, {4, 4, 4}}, random, blocks);
      std::set<Cell> cells;
      Mesh solid;
      for (const auto& [low, high] : blocks) {
        solid = together(solid, cuboid(Vec3(low[0], low[1], low[2]), Vec3(high[0], high[1], high[2])));
        for (int x = low[0]; x < high[0]; ++x)
          for (int y = low[1]; y < high[1]; ++y)
            for (int z = low[2]; z < high[2]; ++z) cells.insert({x, y, z});
      }
      if (cells.empty()) continue;
      const Mesh half = cuboid({0, 0, 0}, {0.5, 0.5, 0.5});
      COMPARE_NEAR(volumeOf(solidSumOf(solid, half)), volumeOfSum(cells), 1e-9);
      if (volumeOfDifference(cells) > 0)
        COMPARE_NEAR(volumeOf(solidDifferenceOf(solid, half)), volumeOfDifference(cells), 1e-9);
    }
  }

  /// Turned, walls that lie on each other overlap or gape by what rounding does.
  void turnedBodiesThatTouchAreOneSolid() {
    std::mt19937_64 random = seededRandom();
    const Mesh low = cuboid({0, 0, 0}, {4, 4, 2}), half = cuboid({0, 0, 0}, {0.5, 0.5, 0.5});
    for (int run = 0; run < 12; ++run) {
      const bool isFlush = run % 2 == 0;
      const Mesh high = isFlush ? cuboid({0, 1, 2}, {3, 3, 4}) : cuboid({1, 1, 2}, {3, 3, 4});
      const Eigen::Matrix3d turn = randomTurn(random);
      const MorphologyResult made =
          solidDifference(bodyOf(turnedBy(together(low, high), turn)), bodyOf(turnedBy(half, turn)));
      COMPARE_NEAR(volumeOf(made.solids.front()), 3.5 * 3.5 * 1.5 + (isFlush ? 2.5 : 1.5) * 1.5 * 2, 1e-9);
      QVERIFY(!made.warnings.empty() && made.warnings.front().find("touch or overlap") != std::string::npos);
    }
  }

  /// Of coordinates with eight decimals, what is between the bodies may be a gap: it is told.
  void bodiesThatFilesLeaveApartAreTold() {
    std::mt19937_64 random = seededRandom();
    const Mesh half = cuboid({0, 0, 0}, {0.5, 0.5, 0.5});
    for (int run = 0; run < 12; ++run) {
      const Eigen::Matrix3d turn = randomTurn(random);
      Mesh solid = turnedBy(together(cuboid({0, 0, 0}, {4, 4, 2}), cuboid({0, 1, 2}, {3, 3, 4})), turn);
      for (Vec3& p : solid.points)
        for (double& x : p) x = std::round(x * 1e8) / 1e8;
      const MorphologyResult sum = solidSum(bodyOf(solid), bodyOf(turnedBy(half, turn)));
      COMPARE_NEAR(volumeOf(sum.solids.front()), 4.5 * 4.5 * 2.5 + 3.5 * 2.5 * 2, 1e-5);
      QVERIFY(!sum.warnings.empty() && sum.warnings.front().find("touch") != std::string::npos);
    }
  }

  /// The ends of a morph are the solids themselves: bodies that overlap, or meet within a face, are one there.
  void bodiesThatMeetAreOneAtTheEnds() {
    const Mesh cube = unitCell();
    const Mesh overlapping = together(cube, movedBy(cube, {0.5, 0.25, 0.125}));
    const Mesh onAFace = together(cube, tetrahedron({0.5, 0.5, 1}, {0, 0, 2}, {1, 0, 2}, {0, 1, 2}));
    const auto end = [&](const Mesh& solid) { return morphOf(solid, cube, {0}).solids.front(); };
    COMPARE_NEAR(volumeOf(end(overlapping)), 2 - 0.5 * 0.75 * 0.875, 1e-12);
    COMPARE_NEAR(volumeOf(end(onAFace)), 1 + 1.0 / 6, 1e-12);
    QVERIFY(!firstCrossing(end(overlapping)) && !firstCrossing(end(onAFace)));
  }

  /// A needle as thin as a step of the grid, which rounding has turned inside out on the lid of a cube.
  void turnedSliversAreNothing() {
    const double step = std::ldexp(1, -41);
    const Mesh cube = cuboid({0, 0, 0}, {4, 4, 4}), other = ballOf(0.5, 1);
    const Mesh needle = tetrahedron({2, 2, 4 + step}, {1, 2, 4}, {3, 2, 4}, {2, 2 + step, 4});
    const double alone = volumeOf(solidSumOf(cube, other));
    for (const Mesh& each : {needle, insideOut(needle)})
      COMPARE_NEAR(volumeOf(solidSumOf(together(cube, each), other)), alone, 1e-9);
  }

  void aVoidThatLeavesItsSolidIsRefused() {
    const Mesh cube = cuboid({0, 0, 0}, {4, 4, 4}), void_ = insideOut(cuboid({1, 1, 3}, {2, 2, 5}));
    const Operand solid = bodyOf(together(cube, void_));
    for (const std::string& refusal : {refusalOf([&] { solidSum(solid, bodyOf(ballOf(1, 0))); }), refusalOf([&] {
                                         solidMorph({solid, bodyOf(cube)}, {{1, 0}});
                                       })})
      QVERIFY2(refusal.find("looks inwards") != std::string::npos, refusal.c_str());
  }

  /// A void thinner than doubles can tell what is inside, in one of two bodies that touch: uniting them keeps it, so what is
  /// taken away from them moves about it as about a wider one.
  void thinVoidsInBodiesThatTouchStay() {
    std::mt19937_64 random = seededRandom();
    const Mesh touching = together(unitCell(), movedBy(unitCell(), {1, 0.3, 0.2}));
    const Mesh element = turnedBy(cuboid({-0.05, -0.05, -0.05}, {0.05, 0.05, 0.05}), randomTurn(random));
    for (int round = 0; round < 40; ++round) {
      const double thin = std::pow(10, std::uniform_real_distribution<double>(-10, -8)(random));
      const Eigen::Matrix3d turn = randomTurn(random);
      const auto volumeWith = [&](double width) {
        const Vec3 half = round % 2 == 0 ? Vec3(width / 2, 0.65 * width, 0.15) : Vec3(0.1, 0.1, width / 2);
        const Mesh hollow = insideOut(movedBy(turnedBy(cuboid(-half, half), turn), {0.5, 0.5, 0.5}));
        return volumeOf(solidDifference(bodyOf(together(touching, hollow)), bodyOf(element)).solids.front());
      };
      COMPARE_NEAR(volumeWith(thin), volumeWith(1e-7), 1e-5);
    }
  }

  // What still cannot be used is told by its name and where it is, far from the origin as well.
  void complaintsNameTheOperandAndThePlace() {
    const Mesh far = movedBy(together(unitCell(), movedBy(unitCell(), {1, 1, 0.5})), {100, 200, 300});
    Operand operand = bodyOf(movedBy(prism({{0, 0}, {3, 3}, {3, 0}, {0, 2}}, 0, 1), {100, 200, 300}));
    operand.name = "The second shape";
    const std::string crossing = refusalOf([&] { solidSum(bodyOf(unitCell()), operand); });
    QVERIFY2(crossing.starts_with("The second shape crosses or touches itself near (10"), crossing.c_str());
    QVERIFY2(crossing.find(", 20") != std::string::npos && crossing.find(", 30") != std::string::npos, crossing.c_str());
    // Two bodies along a part of an edge count as one.
    COMPARE_NEAR(volumeOf(solidSumOf(far, cuboid({0, 0, 0}, {0.5, 0.5, 0.5}))), 2 * 1.5 * 1.5 * 1.5 - 0.5 * 0.5 * 1, 1e-9);
  }
};

BLOSSOM_TEST(MorphologyTouchingTest)
#include "morphology_touching_test.moc"
