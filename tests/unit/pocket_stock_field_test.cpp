#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <random>

#include "pocket/kernel/setup/stock_mesh.h"
#include "pocket/kernel/setup/stock_sweep.h"
#include "support/random.h"
#include "support/support.h"

using namespace blossom;
using namespace blossom::pocket;
using namespace blossom::test;

namespace {

using std::numbers::pi;

Bounds slab() { return {{0, 0, -20}, {60, 40, 0}, false}; }

Toolpath programOf(const Cutter& cutter, const Vec3& start, const std::vector<ToolMove>& moves) {
  Toolpath path;
  path.cutter = cutter;
  path.start = start;
  path.moves = moves;
  return path;
}

/// How high the surface of a cutter at a place stands over a point of the plane, from its profile alone.
double surfaceOver(const Cutter& c, const Vec3& tip, const Vec2& at) {
  const double across = (tip.head<2>() - at).norm(), radius = c.diameter / 2;
  if (across > radius) return 1e9;
  if (c.vAngle > 0) return tip.z() + across / std::tan(c.vAngle / 2);
  const double flat = radius - c.cornerRadius;
  if (across <= flat) return tip.z();
  return tip.z() + c.cornerRadius - std::sqrt(c.cornerRadius * c.cornerRadius - (across - flat) * (across - flat));
}

/// Seen from above.
double distanceToWay(const Vec2& at, const Vec3& from, const Vec3& to) {
  const Vec2 along = (to - from).head<2>(), offset = at - from.head<2>();
  const double share = along.isZero() ? 0 : std::clamp(offset.dot(along) / along.squaredNorm(), 0.0, 1.0);
  return (offset - share * along).norm();
}

}  // namespace

class PocketStockFieldTest final : public QObject {
  Q_OBJECT
 private slots:
  void aBlockHasItsVolume() {
    const StockField field(slab(), 100'000);
    COMPARE_NEAR(field.volume(), 60 * 40 * 20, 60 * 40 * 20 * 0.01);
    QVERIFY(field.cell() < 0.2);
  }
  /// A slot with round ends: closed form.
  void aSlotHasItsVolume() {
    StockField field(slab(), 250'000);
    const double before = field.volume();
    field.cut({6, 0, 0, 1, 0}, {15, 20, -4}, {45, 20, -4});
    const double rim = 2 * 30 + pi * 6;  // along which a cell is either whole or not there
    COMPARE_NEAR(before - field.volume(), 4 * (30 * 6 + pi * 9), 4 * rim * field.cell() / 2);
  }
  void aBallLeavesAGroove() {
    StockField field(slab(), 250'000);
    const double before = field.volume();
    field.cut({6, 3, 0, 1, 0}, {15, 20, -3}, {45, 20, -3});
    const double wanted = 30 * pi * 9 / 2 + 2.0 / 3 * pi * 27;
    COMPARE_NEAR(before - field.volume(), wanted, 2e-3 * wanted);
  }
  /// Random ways of random cutters: each cell is as low as the lowest of a hundred places of the way.
  void cellsAreAsLowAsTheCutterComes() {
    std::mt19937_64 random = seededRandom();
    for (int k = 0; k < 40; ++k) {
      Cutter cutter{uniform(random, 2, 12), 0, 0, 1, 0};
      if (k % 3 == 1) cutter.cornerRadius = uniform(random, 0.1, 0.5) * cutter.diameter;
      if (k % 3 == 2) cutter.vAngle = uniform(random, 0.5, 2.5);
      const auto place = [&] { return Vec3(uniform(random, -5, 65), uniform(random, -5, 45), uniform(random, -10, 2)); };
      const Vec3 from = place();
      Vec3 to = place();
      if (k % 4 == 0) to.z() = from.z();
      if (k % 4 == 1) to.head<2>() = from.head<2>();
      StockField field(slab(), 5'000);
      field.cut(cutter, from, to);
      double worst = 0;
      for (std::size_t row = 0; row < field.rows(); ++row)
        for (std::size_t column = 0; column < field.columns(); ++column) {
          const Vec2 at = field.middleOf(column, row);
          if (std::abs(distanceToWay(at, from, to) - cutter.diameter / 2) < 0.01) continue;  // between two of the places
          double lowest = 0;
          for (int s = 0; s <= 1000; ++s)
            lowest = std::min(lowest, surfaceOver(cutter, from + s / 1000.0 * (to - from), at));
          lowest = std::max(lowest, -20.0);
          worst = std::max(worst, std::abs(field.heightAt(column, row) - lowest));
        }
      QVERIFY2(worst < 0.12, qPrintable(QString("%1 at %2").arg(worst).arg(k)));
    }
  }
  void aCylinderStandsWhereItsTrianglesAre() {
    Triangles lid;
    const int sides = 400;
    for (int i = 0; i < sides; ++i) {
      const double a = 2 * pi * i / sides, b = 2 * pi * (i + 1) / sides;
      lid.push_back({Vec3(30, 20, -5), Vec3(30 + 15 * std::cos(a), 20 + 15 * std::sin(a), -5),
                     Vec3(30 + 15 * std::cos(b), 20 + 15 * std::sin(b), -5)});
    }
    StockField field(slab(), 250'000);
    field.lowerTo(lid);
    const double wanted = pi * 225 * 15;
    COMPARE_NEAR(field.volume(), wanted, 1e-3 * wanted);
  }
  /// Every edge has two faces, run through both ways, and the volume is that of the cells but for the slopes between them.
  void itsMeshIsClosed() {
    StockField field(slab(), 4'000);
    field.cut({6, 0, 0, 1, 0}, {15, 20, -4}, {45, 20, -4});
    field.cut({8, 4, 0, 1, 0}, {-3, -3, -6}, {30, 50, -2});
    field.cut({10, 0, 0, 1, 0}, {50, 10, -30}, {50, 10, -30});  // a hole
    const Mesh mesh = meshOf(field);
    std::map<std::pair<int, int>, int> sides;
    double volume = 0;
    for (std::size_t f = 0; f < mesh.faceCount(); ++f) {
      const auto face = mesh.face(f);
      for (std::size_t i = 0; i < 3; ++i) ++sides[{face[i], face[(i + 1) % 3]}];
      const auto at = [&](std::size_t i) { return mesh.points[static_cast<std::size_t>(face[i])]; };
      volume += at(0).dot(at(1).cross(at(2))) / 6;
    }
    for (const auto& [side, count] : sides) {
      QCOMPARE(count, 1);
      QVERIFY(sides.contains({side.second, side.first}));
    }
    COMPARE_NEAR(volume, field.volume(), 0.01 * field.volume());
  }
  /// In steps as at once, and half a program of one straight cut is half of the slot.
  void aProgramIsCutInParts() {
    const Toolpath path = programOf({6, 0, 0, 1, 0}, {10, 20, -4}, {{MoveKind::Feed, {50, 20, -4}, 0, {0, 0}, 100, 0}});
    StockField half(slab(), 50'000), steps(slab(), 50'000), whole(slab(), 50'000);
    cutBetween(half, path, 0, 0.5, Progress::none());
    for (int k = 0; k < 7; ++k) cutBetween(steps, path, k / 7.0, (k + 1) / 7.0, Progress::none());
    cutBetween(whole, path, 0, 1, Progress::none());
    COMPARE_NEAR(steps.volume(), whole.volume(), 1e-6);
    const double full = 60 * 40 * 20;
    COMPARE_NEAR(half.volume() - whole.volume(), 20 * 6 * 4, 0.05 * 20 * 6 * 4);
    QVERIFY(half.volume() < full);
  }
  void rapidsThroughMaterialAreTold() {
    const ToolAssembly tool{{6, 0, 0, 1, 0}};
    const auto told = [&](const std::vector<ToolMove>& moves) {
      StockField field(slab(), 50'000);
      return carve(field, programOf(tool.cutter, {10, 20, 5}, moves), tool, 0.02, Progress::none());
    };
    const ToolMove down{MoveKind::Plunge, {10, 20, -3}, 0, {0, 0}, 100, 0};
    const ToolMove along{MoveKind::Feed, {40, 20, -3}, 0, {0, 0}, 100, 0};
    const ToolMove back{MoveKind::Rapid, {10, 20, -3}, 0, {0, 0}, 0, 0};
    const ToolMove aside{MoveKind::Rapid, {10, 24, -3}, 0, {0, 0}, 0, 0};
    QVERIFY(told({down, along, back}).empty());
    const auto hits = told({down, along, back, aside});
    QCOMPARE(hits.size(), std::size_t(1));
    QCOMPARE(hits[0].move, std::size_t(3));
    QCOMPARE(hits[0].part, ToolPart::Flutes);
  }
  /// A shank as thick as its cutter meets what the flutes are too short to remove.
  void shortFlutesAreTold() {
    const ToolMove down{MoveKind::Plunge, {10, 20, -8}, 0, {0, 0}, 100, 0};
    const ToolMove along{MoveKind::Feed, {40, 20, -8}, 0, {0, 0}, 100, 0};
    const auto told = [&](double flutes, double holder) {
      StockField field(slab(), 50'000);
      const ToolAssembly tool{{6, 0, 0, 1, 0}, flutes, 6, holder, 30, 40};
      return carve(field, programOf(tool.cutter, {10, 20, 5}, {down, along}), tool, 0.02, Progress::none());
    };
    QVERIFY(told(9, 20).empty());
    // A thinner shank follows the flutes down: it touches nothing on the way.
    StockField field(slab(), 50'000);
    const ToolAssembly thin{{6, 0, 0, 1, 0}, 3, 5, 40, 0, 0};
    QVERIFY(carve(field, programOf(thin.cutter, {10, 20, 5}, {down}), thin, 0.02, Progress::none()).empty());
    const auto shank = told(6, 20);
    QVERIFY(!shank.empty());
    QCOMPARE(shank[0].part, ToolPart::Shank);
    const auto holder = told(7.5, 7.5);
    QVERIFY(std::any_of(holder.begin(), holder.end(), [](const StockHit& hit) { return hit.part == ToolPart::Holder; }));
  }
};

BLOSSOM_TEST(PocketStockFieldTest)
#include "pocket_stock_field_test.moc"
