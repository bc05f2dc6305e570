
#include "support/modeling.h"

using namespace blossom;
using namespace blossom::test;
using std::numbers::pi;

namespace {

/// Area A(t) of an outline whose sides have moved inwards by t: A - P t + C t^2 while no side vanishes.
double tapered(double area, double perimeter, double corners, double height, double degrees) {
  const double t = height * std::tan(degrees * pi / 180);
  return height * (area - perimeter * t / 2 + corners * t * t / 3);
}

/// Two half circles of radius `r` joined by lines, 2 * w apart.
Region slot(double w, double r) {
  Path path;
  path.closed = true;
  path.segments = {Line2{{-w, -r}, {w, -r}}, Arc2{{w, 0}, r, -pi / 2, pi}, Line2{{w, r}, {-w, r}},
                   Arc2{{-w, 0}, r, pi / 2, pi}};
  return {{path}};
}

}  // namespace

class ModelingExtrudeTest : public QObject {
  Q_OBJECT

 private slots:
  void aPlateWithHoles() {
    Region plate = rectangle(0, 0, 40, 30);
    plate.loops.push_back(circle({10, 10}, 4, true));
    plate.loops.push_back(circle({30, 15}, 5, true));
    const Evaluated solid = made("extrude", {{"height", 6}}, {plate});
    QVERIFY(isSound(solid));
    const double area = 1200 - 41 * pi;
    COMPARE_NEAR(volume(solid), 6 * area, 1e-8);
    COMPARE_NEAR(surfaceArea(solid), 2 * area + 6 * (140 + 18 * pi), 1e-8);
    COMPARE_NEAR(figure(solid.shape, "genus"), 2, 0);
  }

  void bothWaysAndBelow() {
    const Region square = rectangle(0, 0, 10, 10);
    const Bounds both = bounds(made("extrude", {{"height", 5}, {"back", 3}}, {square}).shape);
    COMPARE_NEAR(both.low.z(), -3, 1e-6);
    COMPARE_NEAR(both.high.z(), 5, 1e-6);
    const Evaluated below = made("extrude", {{"height", -4}}, {square});
    QVERIFY(isSound(below));
    COMPARE_NEAR(volume(below), 400, 1e-9);
    COMPARE_NEAR(bounds(below.shape).low.z(), -4, 1e-6);
  }

  void aSlantedDirectionKeepsCavalieri() {
    const Evaluated solid = made("extrude", {{"height", 10}, {"direction", {3, 0, 4}}}, {rectangle(0, 0, 10, 10)});
    QVERIFY(isSound(solid));
    COMPARE_NEAR(volume(solid), 100 * 8.0, 1e-8);
  }

  void tapersAreExact() {
    for (const double degrees : {10.0, -15.0}) {
      const Evaluated square = made("extrude", {{"height", 10}, {"taper", degrees}}, {rectangle(0, 0, 20, 30)});
      QVERIFY(isSound(square));
      COMPARE_NEAR(volume(square), tapered(600, 100, 4, 10, degrees), 1e-7);
      const Evaluated oval = made("extrude", {{"height", 10}, {"taper", degrees}}, {slot(10, 5)});
      QVERIFY(isSound(oval));
      COMPARE_NEAR(volume(oval), tapered(200 + 25 * pi, 40 + 10 * pi, pi, 10, degrees), 1e-6);
    }
  }

  void aHoleWidensWhereTheOutlineNarrows() {
    Region ring{{circle({0, 0}, 10), circle({0, 0}, 4, true)}};
    const Evaluated solid = made("extrude", {{"height", 6}, {"taper", 10}}, {ring});
    const double t = 6 * std::tan(10 * pi / 180);
    const auto frustum = [](double a, double b) { return pi * 6 * (a * a + a * b + b * b) / 3; };
    QVERIFY(isSound(solid));
    COMPARE_NEAR(volume(solid), frustum(10, 10 - t) - frustum(4, 4 + t), 1e-7);
  }

  void aTaperBothWaysIsWidestAtTheOutline() {
    const Evaluated solid = made("extrude", {{"height", 10}, {"back", 5}, {"taper", 8}}, {rectangle(0, 0, 20, 20)});
    QVERIFY(isSound(solid));
    COMPARE_NEAR(volume(solid), tapered(400, 80, 4, 10, 8) + tapered(400, 80, 4, 5, 8), 1e-7);
  }

  void freeFormSidesLeanAsChords() {
    // By Steiner's formula for the ellipse moved inwards; its perimeter by Gauss and Kummer's series.
    const double a = 12, b = 8, h = std::pow((a - b) / (a + b), 2);
    const double perimeter = pi * (a + b) * (1 + h / 4 + h * h / 64 + h * h * h / 256);
    Path oval;
    oval.closed = true;
    oval.segments = {ellipticArc({3, 2}, {a, 0}, b / a, 0, 2 * pi)};
    const Evaluated solid = made("extrude", {{"height", 5}, {"taper", 6}}, {Region{{oval}}});
    QVERIFY(isSound(solid));
    COMPARE_NEAR(volume(solid), tapered(pi * a * b, perimeter, pi, 5, 6), 5e-3 * perimeter * 5);
    QCOMPARE(solid.warnings.size(), std::size_t{1});
    QVERIFY(solid.warnings.front().find("made into straight pieces") != std::string::npos);
  }

  void aTaperWhoseSidesMeetIsRefused() {
    Path circle;
    circle.closed = true;
    circle.segments.emplace_back(Arc2{{0, 0}, 5, 0, 2 * pi});
    const Region disc{{circle}};
    VERIFY_REFUSED(refusal("extrude", {{"height", 6}, {"taper", 45}}, {disc}), ErrorCode::Degenerate, "the sides meet");
    VERIFY_REFUSED(refusal("extrude", {{"height", 100}, {"taper", 10}}, {rectangle(0, 0, 20, 20)}), ErrorCode::Degenerate,
                   "sides meet");
    VERIFY_REFUSED(refusal("extrude", {{"height", 40}, {"taper", 10}}, {slot(10, 5)}), ErrorCode::Degenerate, "sides meet");
  }

  void aConeMayComeCloseToItsTip() {
    Path arcs;
    arcs.closed = true;
    arcs.segments = {Arc2{{3, 2}, 5, 0, pi}, Arc2{{3, 2}, 5, pi, pi}};
    const auto frustum = [](double height) { return pi / 3 * (125 - std::pow(5 - height, 3)); };
    for (const Region& disc : {Region{{circle({3, 2}, 5)}}, Region{{arcs}}})
      for (const double height : {2.0, 4.9, -4.9, 4.999, 5.0}) {
        const Evaluated solid = made("extrude", {{"height", height}, {"taper", 45}}, {disc});
        QVERIFY(isSound(solid));
        COMPARE_NEAR(volume(solid), frustum(std::abs(height)), 1e-7);
        COMPARE_NEAR(height > 0 ? bounds(solid.shape).high.z() : bounds(solid.shape).low.z(), height, 1e-6);
      }
    const Region disc{{circle({3, 2}, 5)}};
    for (const double taper : {1e-10, 1e-8, 1e-6, 1e-4}) {  // hardly leaning at all
      const double top = 5 - 4 * std::tan(taper * pi / 180);
      COMPARE_NEAR(volume(made("extrude", {{"height", 4}, {"taper", taper}}, {disc})),
                   pi * 4 / 3 * (25 + 5 * top + top * top), 1e-5);
    }
    const Evaluated both = made("extrude", {{"height", 4.9}, {"back", 2}, {"taper", 45}}, {disc});
    QVERIFY(isSound(both));
    COMPARE_NEAR(volume(both), frustum(4.9) + frustum(2), 1e-7);
    VERIFY_REFUSED(refusal("extrude", {{"height", 6}, {"taper", 45}}, {disc}), ErrorCode::Degenerate,
                   "They meet at a height of 5 mm, in (3, 2, 5)");
  }

  void openCurvesMakeSheets() {
    const Curves open{{polygon({{0, 0}, {10, 0}, {10, 5}}, false)}, FillRule::EvenOdd};
    const Evaluated sheet = made("extrude", {{"height", 7}}, {open});
    COMPARE_NEAR(figure(sheet.shape, "area"), 105, 1e-9);
    QVERIFY(measure(sheet.shape).kind != "solid");
    const Evaluated tube = made("extrude", {{"height", 7}, {"solid", false}}, {rectangle(0, 0, 10, 5)});
    COMPARE_NEAR(figure(tube.shape, "area"), 210, 1e-9);
  }

  void closedCurvesMakeSolids() {
    const Curves drawn{{polygon({{0, 0}, {10, 0}, {10, 10}, {0, 10}}), circle({5, 5}, 2)}, FillRule::EvenOdd};
    const Evaluated solid = made("extrude", {{"height", 3}}, {drawn});
    QVERIFY(isSound(solid));
    COMPARE_NEAR(volume(solid), 3 * (100 - 4 * pi), 1e-9);
  }

  void severalOutlinesMakeSeveralSolids() {
    Region two = rectangle(0, 0, 10, 10);
    two.loops.push_back(rectangle(20, 0, 25, 5).loops.front());
    const Evaluated solids = made("extrude", {{"height", 2}}, {two});
    COMPARE_NEAR(volume(solids), 250, 1e-9);
    COMPARE_NEAR(figure(solids.shape, "components"), 2, 0);
  }

  void everyFaceOfABoxGrowsOutward() {
    const Evaluated box = made("box", {{"width", 10}, {"depth", 20}, {"height", 30}});
    double sum = 0;
    for (int face = 0; face < 6; ++face) {
      const Value picked{{"input", "profile"}, {"kind", "face"}, {"index", face}};
      const Evaluated pad = made("extrude", {{"height", 1}, {"face", picked}}, {box.shape});
      QVERIFY(isSound(pad));
      const Vec3 centre = bounds(pad.shape).center();
      QVERIFY((centre.array() < 0).any() || (centre.array() > Eigen::Array3d(10, 20, 30)).any());
      sum += volume(pad);
    }
    COMPARE_NEAR(sum, surfaceArea(box), 1e-8);
  }

  void aClosingLineWithoutLengthIsNoCrossing() {
    Path disc;
    disc.closed = true;
    disc.segments = {Arc2{{0, 0}, 2, 0, pi}, Arc2{{0, 0}, 2, pi, pi}, Line2{{2, -4.9e-16}, {2, 0}}};
    COMPARE_NEAR(volume(made("extrude", {{"height", 1}}, {Region{{disc}}})), 4 * pi, 1e-9);
  }

  void badOutlinesAreRefusedWithTheirPlace() {
    const Region bow{{polygon({{0, 0}, {10, 10}, {10, 0}, {0, 10}})}};
    VERIFY_REFUSED(refusal("extrude", {}, {bow}), ErrorCode::InvalidInput, "crosses itself near (5, 5)");
    const Curves mixed{{polygon({{0, 0}, {10, 0}, {10, 10}}), polygon({{20, 0}, {30, 0}}, false)}, FillRule::EvenOdd};
    VERIFY_REFUSED(refusal("extrude", {}, {mixed}), ErrorCode::InvalidInput, "begins at (20, 0) and ends at (30, 0)");
    VERIFY_REFUSED(refusal("extrude", {{"height", 0}}, {rectangle(0, 0, 1, 1)}), ErrorCode::InvalidParameter, "no height");
    VERIFY_REFUSED(refusal("extrude", {{"direction", {1, 0, 0}}}, {rectangle(0, 0, 1, 1)}), ErrorCode::InvalidParameter,
                   "plane of the outline");
    const Shape box = made("box").shape;
    VERIFY_REFUSED(refusal("extrude", {}, {box}), ErrorCode::InvalidInput, "which of its faces");
    const Value missing{{"input", "profile"}, {"kind", "face"}, {"index", 6}};
    VERIFY_REFUSED(refusal("extrude", {{"face", missing}}, {box}), ErrorCode::NotFound, "face 6");
    const Value round{{"input", "profile"}, {"kind", "face"}, {"index", 0}};
    VERIFY_REFUSED(refusal("extrude", {{"face", round}}, {made("sphere").shape}), ErrorCode::InvalidInput, "curved");
    VERIFY_REFUSED(refusal("extrude", {}, {Region{}}), ErrorCode::InvalidInput, "empty");
  }

  void revolutionsFollowPappus() {
    auto random = seededRandom();
    std::uniform_real_distribution<double> any(1, 10);
    for (int i = 0; i < 10; ++i) {
      const double r = any(random), distance = r + any(random), share = any(random) / 11;
      const Region disc{{circle({distance, any(random)}, r)}};
      const Evaluated ring = made("revolve", {}, {disc});
      QVERIFY(isSound(ring));
      COMPARE_NEAR(volume(ring), 2 * pi * distance * pi * r * r, 1e-8 * volume(ring));
      COMPARE_NEAR(figure(ring.shape, "genus"), 1, 0);
      const Evaluated bend = made("revolve", {{"angle", -360 * share}}, {disc});
      QVERIFY(isSound(bend));
      COMPARE_NEAR(volume(bend), share * volume(ring), 1e-8 * volume(ring));
    }
  }

  void anOutlineMayTouchTheAxis() {
    Path half;
    half.closed = true;
    half.segments = {Arc2{{0, 0}, 5, -pi / 2, pi}, Line2{{0, 5}, {0, -5}}};
    const Evaluated ball = made("revolve", {}, {Region{{half}}});
    QVERIFY(isSound(ball));
    COMPARE_NEAR(volume(ball), 4 * pi * 125 / 3, 1e-7);
    const Evaluated cylinder = made("revolve", {{"axis", {1, 0, 0}}}, {rectangle(0, 0, 8, 3)});
    COMPARE_NEAR(volume(cylinder), pi * 9 * 8, 1e-8);
  }

  void revolutionsThatCutThroughThemselvesAreRefused() {
    VERIFY_REFUSED(refusal("revolve", {}, {rectangle(-1, 0, 5, 5)}), ErrorCode::InvalidInput, "crosses the axis");
    VERIFY_REFUSED(refusal("revolve", {{"axis", {0, 0, 1}}}, {rectangle(1, 0, 5, 5)}), ErrorCode::InvalidInput, "square to");
    VERIFY_REFUSED(refusal("revolve", {{"angle", 0}}, {rectangle(1, 0, 5, 5)}), ErrorCode::InvalidParameter, "angle");
  }
};

BLOSSOM_TEST(ModelingExtrudeTest)
#include "modeling_extrude_test.moc"
