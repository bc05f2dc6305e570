/// Where a single surface passes through itself: beside a slit, and where its sheets are tangent along the crossing.
#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <vector>

#include "geometry/crossing/self_crossing.h"
#include "geometry/crossing/surface_crossing.h"
#include "geometry/occt/occt.h"
#include "support/crossing_shapes.h"
#include "support/support.h"

using namespace blossom;
using namespace blossom::test;

namespace {

std::vector<double> clampedKnots(int degree, std::size_t poles) {
  const auto spans = static_cast<int>(poles) - degree;
  std::vector<double> knots(static_cast<std::size_t>(degree), 0.0);
  for (int k = 0; k <= spans; ++k) knots.push_back(static_cast<double>(k) / spans);
  knots.insert(knots.end(), static_cast<std::size_t>(degree), 1.0);
  return knots;
}

/// Straight from row to row, cubic along each row.
Surface throughRows(const std::vector<std::vector<Vec3>>& rows) {
  Surface surface{1, 3, clampedKnots(1, rows.size()), clampedKnots(3, rows.front().size()), {}};
  for (const auto& row : rows)
    for (const Vec3& p : row) surface.poles.emplace_back(p.x(), p.y(), p.z(), 1);
  return surface;
}

constexpr double cylinderHeight = 20;

/// A band 1 mm thick, wound up with a third of a turn lying over its beginning and a slit of `gap` between. One bump of its
/// outer side fills the slit and reaches `poke` farther: a cubic with poles in even steps is 2/3 of a single pole high.
Surface woundBand(double gap, double poke) {
  constexpr int ofATurn = 40, over = 14, along = 40, bumpK = 7, bumpJ = 20;
  constexpr double radius = 10, thick = 1;
  constexpr int last = ofATurn + over;
  std::vector<std::pair<int, bool>> section;
  for (int k = 0; k <= last; ++k) section.emplace_back(k, false);
  for (int k = last; k >= 0; --k) section.emplace_back(k, true);
  section.emplace_back(0, false);
  std::vector<std::vector<Vec3>> rows;
  for (const auto& [k, outer] : section) {
    auto& row = rows.emplace_back();
    const double angle = 2 * std::numbers::pi * k / ofATurn;
    for (int j = 0; j < along; ++j) {
      double r = radius + (thick + gap) * k / ofATurn + (outer ? thick : 0);
      if (outer && k == bumpK && j == bumpJ && poke > 0) r += 1.5 * (gap + poke);
      row.emplace_back(r * std::cos(angle), r * std::sin(angle), cylinderHeight * j / (along - 1));
    }
  }
  return throughRows(rows);
}

/// A coil of 1.6 turns; the distance between its layers has these Bernstein coefficients along it.
Surface coilWithGap(const std::vector<double>& gap) {
  constexpr int ofATurn = 12, count = 19;
  std::vector<std::vector<Vec3>> rows;
  for (int k = 0; k <= count; ++k) {
    const double angle = 2 * std::numbers::pi * k / ofATurn;
    auto& row = rows.emplace_back();
    for (std::size_t j = 0; j < gap.size(); ++j) {
      const double r = 10 + gap[j] * k / ofATurn;
      row.emplace_back(r * std::cos(angle), r * std::sin(angle),
                       cylinderHeight * static_cast<double>(j) / static_cast<double>(gap.size() - 1));
    }
  }
  return throughRows(rows);
}

/// A cylinder about z of radius 10, as arcs of these angles one after the other.
Surface cylinderOfArcs(const std::vector<double>& angles) {
  Surface surface{2, 1, {0}, {0, 0, 1, 1}, {}};
  double angle = 0;
  const auto add = [&](double at, double weight, double radius) {
    for (const double z : {0.0, cylinderHeight})
      surface.poles.emplace_back(weight * radius * std::cos(at), weight * radius * std::sin(at), weight * z, weight);
  };
  add(0, 1, 10);
  surface.knotsU.insert(surface.knotsU.end(), 2, 0.0);
  for (const double turn : angles) {
    add(angle + turn / 2, std::cos(turn / 2), 10 / std::cos(turn / 2));
    add(angle += turn, 1, 10);
    surface.knotsU.insert(surface.knotsU.end(), 2, angle);
  }
  surface.knotsU.push_back(angle);
  return surface;
}

/// Parabolas one after the other, extruded.
Surface extrudedParabolas(const std::vector<Vec2>& poles) {
  Surface surface{2, 1, {}, {0, 0, 1, 1}, {}};
  surface.knotsU = {0};
  for (std::size_t k = 0; k < poles.size(); k += 2) surface.knotsU.insert(surface.knotsU.end(), 2, static_cast<double>(k));
  surface.knotsU.push_back(surface.knotsU.back());
  for (const Vec2& p : poles)
    for (const double y : {0.0, cylinderHeight}) surface.poles.emplace_back(p.x(), y, p.y(), 1);
  return surface;
}

}  // namespace

class SurfaceCrossingTest : public QObject {
  Q_OBJECT

  std::mt19937_64 random_;

 private slots:
  void initTestCase() { random_ = seededRandom(); }

  /// What lies beyond the layer that is crossed may be a slit that is far thinner than the crossing is deep.
  void bumpThroughALayerBesideASlitIsFound() {
    for (const double poke : {0.1, 0.2, 0.5}) {
      const double gap = uniform(random_, 0.005, 0.01);
      const auto found = findCrossing(woundBand(gap, poke)).deepest;
      QVERIFY2(found, qPrintable(QStringLiteral("slit %1, reaches %2 beyond").arg(gap).arg(poke)));
      // The bump is four steps of poles wide.
      QVERIFY(std::abs(found->point.z() - cylinderHeight * 20 / 39) < 2 * cylinderHeight / 39);
      QVERIFY(found->depth > 0 && found->depth <= gap + poke);
    }
    for (const double gap : {0.003, 0.005, 0.01, 0.1}) QVERIFY(!findCrossing(woundBand(gap, 0)).deepest);
  }

  /// A tube along a loop that comes back through itself. Poles of small weights lie far beyond it and tell nothing of its
  /// size.
  void polesFarAwayDoNotHideACrossing() {
    const std::vector<Vec3> loop{{-20, 0, 0}, {150, 0, 150}, {-150, 0, 150}, {20, 0, 0}};
    const CrossingResult plain = findCrossing(circleMoved(circleWithFarPoles(10, 0.4), loop));
    QVERIFY(plain.deepest);
    for (const double weight : {1e-3, 1e-5, 1e-7}) {
      const TopoDS_Shape face = toFace(circleMoved(circleWithFarPoles(10, weight), loop));
      const CrossingResult found = findCrossing(face);
      QVERIFY2(found.deepest, qPrintable(QStringLiteral("weight %1").arg(weight)));
      COMPARE_NEAR(found.size, plain.size, 0.01 * plain.size);
      QVERIFY(selfCrossing(face, Progress::none()));
    }
    const std::vector<Vec3> straight{{0, 0, 0}, {0, 0, 40}};
    QVERIFY(!findCrossing(toFace(circleMoved(circleWithFarPoles(10, 1e-7), straight))).deepest);
  }

  /// The gap changes its sign where its slope is zero, or next to it.
  void crossingsAlongWhichTheSheetsAreTangentAreFound() {
    for (const double a : {0.05, 0.2, 0.5, 1.0, 2.0})
      for (const double inner : {1.0, 0.9}) {
        const auto found = findCrossing(coilWithGap({-a, inner * a, -inner * a, a})).deepest;
        QVERIFY2(found, qPrintable(QStringLiteral("amplitude %1, inner %2").arg(a).arg(inner)));
        QVERIFY(found->depth > 0 && found->depth <= a);
        QVERIFY(inner < 1 || std::abs(found->point.z() - cylinderHeight / 2) < 0.2);
      }
  }

  /// The same triangles twice, and triangles of two divisions of one cylinder.
  void sheetsThatCoverOneAnotherAreTold() {
    const CrossingResult coil = findCrossing(coilWithGap({0, 0, 0, 0}));
    QVERIFY(coil.covered && !coil.deepest);
    const double share = 5 * std::numbers::pi / 6;  // of one arc in three, at the seams of which the cylinder goes on
    for (const double other : {0.5, 0.9, 1.3, share}) {
      const CrossingResult wound = findCrossing(cylinderOfArcs({share, share, share, other}));
      QVERIFY2(wound.covered && !wound.deepest, qPrintable(QString::number(other)));
      COMPARE_NEAR(wound.covered->head<2>().norm(), 10.0, 1e-6);
    }
  }

  void sheetsThatOnlyTouchOrGoOnDoNotCover() {
    const double third = 2 * std::numbers::pi / 3;
    QVERIFY(!findCrossing(cylinderOfArcs({third, third, third})).covered);
    QVERIFY(!findCrossing(cylinderOfArcs({third, third, 0.9 * third})).covered);
    for (const double a : {0.05, 0.5, 2.0})
      for (const double inner : {1.0, -1.0 / 3}) QVERIFY(!findCrossing(coilWithGap({a, -inner * a, -inner * a, a})).covered);
    for (const double a : {0.05, 0.5, 2.0}) QVERIFY(!findCrossing(coilWithGap({-a, a, -a, a})).covered);  // a (2 t - 1)^3
  }

  void sheetsThatTouchAlongALineDoNotCross() {
    for (const double a : {0.05, 0.2, 0.5, 1.0, 2.0}) {
      QVERIFY(!findCrossing(coilWithGap({a, -a / 3, -a / 3, a})).deepest);
      QVERIFY(!findCrossing(coilWithGap({-a, a / 3, a / 3, -a})).deepest);
    }
    // A plate, touched from below by a sheet that comes round its border to the upper side.
    QVERIFY(!findCrossing(extrudedParabolas({{0, 0},
                                             {10, 0},
                                             {20, 0},
                                             {25, 0},
                                             {25, -5},
                                             {25, -12},
                                             {15, -12},
                                             {7, -6},
                                             {5, -2},
                                             {3, 2},
                                             {1, -2},
                                             {0, -4},
                                             {-2, -2},
                                             {-4, 0},
                                             {-2, 2},
                                             {-1, 3},
                                             {2, 3}}))
                 .deepest);
  }
};

BLOSSOM_TEST(SurfaceCrossingTest)
#include "surface_crossing_test.moc"
