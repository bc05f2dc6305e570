/// Solids that profiles sweep: what would cut through itself is refused with its place, what overlaps counts once, and what
/// is merely thin, tight or leaning stays.
#include "geometry/tessellate/tessellate.h"
#include "support/modeling.h"

using namespace blossom;
using namespace blossom::test;
using std::numbers::pi;

namespace {

Region together(std::initializer_list<Region> parts) {
  Region all;
  for (const Region& part : parts) all.loops.insert(all.loops.end(), part.loops.begin(), part.loops.end());
  return all;
}

Curves arcPath(double radius, double turn) {
  Path one;
  one.segments.emplace_back(Arc2{{0, 0}, radius, 0, turn});
  return {{one}, FillRule::EvenOdd};
}

/// What rectangles of equal height fill when their sides lean out by `slope`, by the midpoint rule.
double leaningRectangles(const std::vector<Bounds>& rectangles, double slope, double height) {
  constexpr int slices = 200000;
  double volume = 0;
  for (int i = 0; i < slices; ++i) {
    const double grown = (i + 0.5) / slices * height * slope;
    double covered = 0, end = -1e300;
    for (const Bounds& each : rectangles) {  // from left to right
      covered += std::max(0.0, each.high.x() + grown - std::max(each.low.x() - grown, end));
      end = std::max(end, each.high.x() + grown);
    }
    volume += covered * (rectangles.front().high.y() - rectangles.front().low.y() + 2 * grown) * height / slices;
  }
  return volume;
}

std::vector<Bounds> boxesOf(const Region& region) {
  std::vector<Bounds> boxes;
  for (const Path& loop : region.loops) boxes.push_back(bounds(Region{{loop}}));
  std::sort(boxes.begin(), boxes.end(), [](const Bounds& a, const Bounds& b) { return a.low.x() < b.low.x(); });
  return boxes;
}

}  // namespace

class ModelingSoundTest : public QObject {
  Q_OBJECT

 private slots:
  void anAxisThatLeansIsCheckedLikeOneInThePlane() {
    const Region crossing = rectangle(-3, 0, 5, 10), beside = rectangle(3, 0, 5, 10);
    for (const double lean : {1e-3, -0.01, 0.2}) {
      const Value axis = {{"axis", {0, 1, lean}}};
      VERIFY_REFUSED(refusal("revolve", axis, {crossing}), ErrorCode::InvalidInput, "crosses the axis near (0, ");
      // Pappus: the area moves through the axis' share of the normal's flow
      const Evaluated tube = made("revolve", axis, {beside});
      QVERIFY(isSound(tube));
      COMPARE_NEAR(volume(tube), 2 * pi * 4 * 20 / std::hypot(1, lean), 1e-6);
    }
  }

  /// The tip of a wedge of a cone: places on one ruling and the tip make triangles without area.
  void partsOfATurnOnTheAxisCostNoMoreThanTheWhole() {
    const Region wedge{{polygon({{0, 0}, {10, 10}, {0, 10}})}}, corner{{polygon({{0, 5}, {5, 0}, {10, 5}, {5, 10}})}};
    for (const auto& [profile, whole] : {std::pair(wedge, 1000 * pi / 3), std::pair(corner, 2 * pi * 5 * 50)}) {
      const std::size_t facets = meshOf(made("revolve", {}, {profile}).shape, {.chord = 0.01, .angle = 0.5}).faceCount();
      for (const double angle : {30.0, 90.0, 180.0, 270.0, 359.9, -180.0}) {
        const Evaluated part = made("revolve", {{"angle", angle}}, {profile});
        QVERIFY(isSound(part));
        COMPARE_NEAR(volume(part), whole * std::abs(angle) / 360, 1e-8 * whole);
        QVERIFY(meshOf(part.shape, {.chord = 0.01, .angle = 0.5}).faceCount() < 2 * facets);
      }
    }
  }

  /// The axis passes in front of the drawing: what matters is on which side of its shadow the outline lies.
  void anAxisBesideThePlaneIsCheckedToo() {
    const Value above = {{"point", {0, 0, 7}}};
    VERIFY_REFUSED(refusal("revolve", above, {rectangle(-3, 0, 5, 10)}), ErrorCode::InvalidInput,
                   "crosses the axis near (0, ");
    const Evaluated tube = made("revolve", above, {rectangle(3, 0, 5, 10)});
    QVERIFY(isSound(tube));
    COMPARE_NEAR(volume(tube), 2 * pi * 4 * 20, 1e-6);
  }

  void outlinesThatTouchTheAxisCostNoMoreThanThoseBesideIt() {
    const auto facets = [](const Region& profile, double wanted) {
      const Evaluated turned = made("revolve", {}, {profile});
      if (!isSound(turned) || std::abs(volume(turned) - wanted) > 1e-8 * wanted) return std::size_t{0};
      return meshOf(turned.shape, {.chord = 0.01, .angle = 0.5}).faceCount();
    };
    const auto triangle = [](double from) { return Region{{polygon({{from, 0}, {10, 0}, {10, 10}})}}; };
    const double away = 10 - 0.1;  // Pappus: half away * 10 at a radius of 0.1 + 2/3 away
    const std::size_t beside = facets(triangle(0.1), away * 10 * pi * (0.1 + away * 2 / 3));
    const std::size_t touching = facets(triangle(0), 2000 * pi / 3);
    QVERIFY(beside > 0 && touching > 0);
    QVERIFY2(touching <= beside + beside / 10, qPrintable(QString("%1, %2").arg(touching).arg(beside)));
    const std::size_t horn = facets({{circle({5, 5}, 5)}}, 250 * pi * pi);
    const std::size_t ring = facets({{circle({5.1, 5}, 5)}}, 255 * pi * pi);
    QVERIFY(ring > 0 && horn > 0);
    QVERIFY2(horn <= 2 * ring, qPrintable(QString("%1, %2").arg(horn).arg(ring)));
  }

  void ringsThatOverlapAreOne() {
    const Value axis = {{"point", {20, 0, 0}}};
    const Evaluated mirrored = made("revolve", axis, {together({rectangle(10, 0, 15, 5), rectangle(25, 0, 30, 5)})});
    COMPARE_NEAR(volume(mirrored), pi * (100 - 25) * 5, 1e-6);
    const Evaluated lapping = made("revolve", axis, {together({rectangle(10, 0, 15, 5), rectangle(22, 2, 27, 9)})});
    // radii 5..10 in heights 0..5, radii 2..7 in heights 2..9, both in radii 5..7 and heights 2..5
    COMPARE_NEAR(volume(lapping), pi * (75 * 5 + 45 * 7 - 24 * 3), 1e-6);
    QVERIFY(isSound(lapping));
    const Evaluated apart = made("revolve", axis, {together({rectangle(10, 0, 15, 5), rectangle(22, 6, 27, 9)})});
    COMPARE_NEAR(volume(apart), pi * (75 * 5 + 45 * 3), 1e-6);
    const Evaluated touching = made("revolve", axis, {together({rectangle(10, 0, 15, 5), rectangle(25, 5, 30, 9)})});
    COMPARE_NEAR(volume(touching), pi * 75 * 9, 1e-6);
  }

  /// Squares across the axis from each other, at one radius: half of each ring lies in the other.
  void ringsOfOneRadiusAreOne() {
    const Region squares = together({rectangle(8, -2, 12, 2), rectangle(-12, 0, -8, 4)});
    for (const double angle : {360.0, -360.0, 300.0, 200.0, 90.0}) {
      const Evaluated rings = made("revolve", {{"angle", angle}}, {squares});
      QVERIFY(isSound(rings));
      // each square sweeps its angle; what both sweep is counted once
      const double swept = 2 * 16 * 10 * std::abs(angle) * pi / 180;
      const double both = 8 * 10 * std::max(0.0, 2 * std::abs(angle) - 360) * pi / 180;
      COMPARE_NEAR(volume(rings), swept - both, 1e-6);
    }
  }

  void tapersThatOverlapAreUnited() {
    const Region squares = together({rectangle(-11, -5, -1, 5), rectangle(1, -5, 11, 5)});
    const Region letters = *made("text", {{"text", "lll"}, {"height", 20}}).shape.get<Region>();
    QCOMPARE(letters.loops.size(), 3U);
    COMPARE_NEAR(figure(letters, "vertices"), 12, 0);  // the letter l of the standard font is a rectangle
    for (const Region& region : {squares, letters})
      for (const double degrees : {-4.0, -20.0, -40.0}) {
        const Evaluated solid = made("extrude", {{"height", 10}, {"taper", degrees}}, {region});
        const double wanted = leaningRectangles(boxesOf(region), std::tan(-degrees * pi / 180), 10);
        COMPARE_NEAR(volume(solid), wanted, 1e-6 * wanted);
        QVERIFY(isSound(solid));
      }
  }

  /// A rectangle of 20 x 12 leaning by 45 degrees ends in a ridge at 6 mm; two rooms with a neck of 4 mm part at 2 mm.
  void tapersTellWhereTheirSidesMeet() {
    const Value steep = {{"height", 10}, {"taper", 45}};
    const auto isTold = [&](const Region& region, const std::string& height, const std::string& place) {
      const std::string message = refusal("extrude", steep, {region}).message();
      qInfo("%s", message.c_str());
      return message.find("meet at a height of about " + height) != std::string::npos &&
             message.find(place) != std::string::npos;
    };
    QVERIFY(isTold(rectangle(-10, -6, 10, 6), "5.99", ", 0, 5.99"));
    const Region rooms{{polygon({{0, 0},
                                 {30, 0},
                                 {30, 18},
                                 {70, 18},
                                 {70, 0},
                                 {100, 0},
                                 {100, 40},
                                 {70, 40},
                                 {70, 22},
                                 {30, 22},
                                 {30, 40},
                                 {0, 40}})}};
    QVERIFY(isTold(rooms, "1.99", ", 20, 1.99"));
  }

  void loftsThatTurnBackAreRefused() {
    const Region a = rectangle(-10, -10, 10, 10), b = rectangle(-8, -8, 8, 8);
    for (const bool ruled : {false, true}) {
      VERIFY_REFUSED(refusal("loft", {{"heights", {0, 20, 10}}, {"ruled", ruled}}, {a, b, a}), ErrorCode::Degenerate,
                     "cut through itself near (");
      QVERIFY(isSound(made("loft", {{"heights", {0, 10, 20}}, {"ruled", ruled}}, {a, b, a})));
    }
    // Straight walls lie on themselves when they turn back: between them is no space.
    const Region round{{circle({0, 0}, 5)}};
    for (const Region& same : {a, round})
      VERIFY_REFUSED(refusal("loft", {{"heights", {0, 20, 10}}, {"ruled", true}}, {same, same, same}), ErrorCode::Degenerate,
                     "cut through itself near (");
    VERIFY_REFUSED(refusal("loft", {{"heights", {0, 10}}}, {a, b, a}), ErrorCode::InvalidParameter,
                   "The number of heights, 2, differs from the number of sections, 3.");
  }

  void pipesThroughThemselvesAreRefusedThinOnesNot() {
    const Region disc{{circle({0, 0}, 8)}}, thin{{circle({0, 0}, 8), circle({0, 0}, 7.999, true)}};
    VERIFY_REFUSED(refusal("pipe", {}, {disc, arcPath(5, 3)}), ErrorCode::Degenerate, "It would cut through itself near (");
    // Tubes of spindle and horn tori: what their surfaces enclose is not what the disc passes through.
    for (const double reach : {10.0, 10.5, 14.0})
      VERIFY_REFUSED(refusal("pipe", {}, {Region{{circle({0, 0}, reach)}}, arcPath(10, 2 * pi)}), ErrorCode::Degenerate,
                     "where the path bends with a radius of 10 mm");
    QVERIFY(isSound(made("pipe", {}, {Region{{circle({0, 0}, 9.9)}}, arcPath(10, 1)})));
    const Curves hairpin{{polygon({{0, 0}, {10, 0}, {0, 1}}, false)}, FillRule::EvenOdd};
    VERIFY_REFUSED(refusal("pipe", {}, {disc, hairpin}), ErrorCode::Degenerate,
                   "Its sharpest corner, of 174 degrees, is in (10, 0, 0).");
    const Evaluated tube = made("pipe", {}, {thin, arcPath(20, 1.5)});
    QVERIFY(isSound(tube));
    COMPARE_NEAR(volume(tube), pi * (64 - 7.999 * 7.999) * 30, 1e-4);
  }

  void thinConesStay() {
    const Path wall = polygon({{5, 0}, {5.0005, 0}, {15.0005, 20}, {15, 20}});
    const Evaluated funnel = made("revolve", {}, {Region{{wall}}});
    QVERIFY(isSound(funnel));
    COMPARE_NEAR(volume(funnel), 2 * pi * 10.00025 * 0.0005 * 20, 1e-6);
  }
};

BLOSSOM_TEST(ModelingSoundTest)
#include "modeling_sound_test.moc"
