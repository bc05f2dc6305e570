
#include "support/modeling.h"

using namespace blossom;
using namespace blossom::test;
using std::numbers::pi;

namespace {

Region square(double half) { return rectangle(-half, -half, half, half); }
Region disc(double radius) { return {{circle({0, 0}, radius)}}; }

Region ring(double outer, double inner) { return {{circle({0, 0}, outer), circle({0, 0}, inner, true)}}; }

Curves path(std::vector<Segment> segments, bool closed = false) {
  Path one;
  one.segments = std::move(segments);
  one.closed = closed;
  return {{one}, FillRule::EvenOdd};
}

double frustum(double a, double b, double height) { return height * (a + b + std::sqrt(a * b)) / 3; }

}  // namespace

class ModelingLoftTest : public QObject {
  Q_OBJECT

 private slots:
  void straightLoftsAreFrustums() {
    const Evaluated pyramid = made("loft", {{"ruled", true}, {"spacing", 12}}, {square(10), square(4)});
    QVERIFY(isSound(pyramid));
    COMPARE_NEAR(volume(pyramid), frustum(400, 64, 12), 1e-7);
    QCOMPARE(pyramid.stats["sections"], Value(2));
    const Evaluated cone = made("loft", {{"spacing", 9}}, {disc(8), disc(3)});
    QVERIFY(isSound(cone));
    COMPARE_NEAR(volume(cone), frustum(64 * pi, 9 * pi, 9), 1e-3);
  }

  void holesAreLoftedToo() {
    const Evaluated sleeve = made("loft", {{"spacing", 10}, {"ruled", true}}, {ring(10, 4), ring(6, 2)});
    QVERIFY(isSound(sleeve));
    COMPARE_NEAR(volume(sleeve), frustum(100 * pi, 36 * pi, 10) - frustum(16 * pi, 4 * pi, 10), 1e-2);
    COMPARE_NEAR(figure(sleeve.shape, "genus"), 1, 0);
  }

  void heightsPlaceTheSections() {
    const Evaluated solid = made("loft", {{"ruled", true}, {"heights", {0, 10, 15}}}, {square(5), square(5), square(2)});
    QVERIFY(isSound(solid));
    COMPARE_NEAR(volume(solid), 1000 + frustum(100, 16, 5), 1e-7);
    COMPARE_NEAR(bounds(solid.shape).high.z(), 15, 1e-6);
  }

  void sectionsInSpaceStayWhereTheyAre() {
    const Shape top = made("transform", {{"move", {0, 0, 7}}}, {square(5)}).shape;
    QVERIFY(top.get<Brep>());
    const Evaluated prism = made("loft", {{"ruled", true}, {"spacing", 99}}, {square(5), top});
    QVERIFY(isSound(prism));
    COMPARE_NEAR(volume(prism), 700, 1e-8);
  }

  void unlikeSectionsAreMatched() {
    const Evaluated adapter = made("loft", {{"spacing", 20}}, {square(10), disc(6)});
    QVERIFY(isSound(adapter));
    QVERIFY(volume(adapter) > 20 * 36 * pi && volume(adapter) < 20 * 400);
    COMPARE_NEAR(figure(adapter.shape, "genus"), 0, 0);
  }

  void aSheetHasNoEnds() {
    const Evaluated skin = made("loft", {{"ruled", true}, {"solid", false}, {"spacing", 10}}, {square(5), square(5)});
    COMPARE_NEAR(figure(skin.shape, "area"), 400, 1e-7);
    QVERIFY(measure(skin.shape).kind != "solid");
  }

  void badSectionsAreNamed() {
    const Curves open = path({Line2{{0, 0}, {5, 0}}});
    VERIFY_REFUSED(refusal("loft", {}, {square(5), open}), ErrorCode::InvalidInput, "Section 2 is open");
    VERIFY_REFUSED(refusal("loft", {}, {square(5), ring(5, 2)}), ErrorCode::InvalidInput, "Section 2 has another number");
    Region two = square(2);
    two.loops.push_back(rectangle(10, 10, 12, 12).loops[0]);
    VERIFY_REFUSED(refusal("loft", {}, {square(5), two}), ErrorCode::InvalidInput, "Section 2 has several outlines");
    VERIFY_REFUSED(refusal("loft", {{"heights", {0, 1, 2}}}, {square(5), disc(5)}), ErrorCode::InvalidParameter, "heights");
    VERIFY_REFUSED(refusal("loft", {{"heights", {0, 0}}}, {square(5), square(5)}), ErrorCode::Degenerate, "No good shape");
  }

  void pipesFollowPappus() {
    const Evaluated rod = made("pipe", {}, {disc(3), path({Line2{{0, 0}, {40, 0}}})});
    QVERIFY(isSound(rod));
    COMPARE_NEAR(volume(rod), 9 * pi * 40, 1e-6);
    const Evaluated bend = made("pipe", {}, {disc(3), path({Arc2{{0, 0}, 20, 0.3, 1.7}})});
    QVERIFY(isSound(bend));
    COMPARE_NEAR(volume(bend), 9 * pi * 20 * 1.7, 1e-4);
    const Evaluated ring = made("pipe", {}, {disc(3), path({Arc2{{0, 0}, 20, 0, 2 * pi}}, true)});
    QVERIFY(isSound(ring));
    COMPARE_NEAR(volume(ring), 9 * pi * 40 * pi, 1e-3);
    COMPARE_NEAR(figure(ring.shape, "genus"), 1, 0);
  }

  void aTubeKeepsItsHole() {
    const Evaluated tube = made("pipe", {}, {ring(5, 3), path({Line2{{0, 0}, {0, 25}}})});
    QVERIFY(isSound(tube));
    COMPARE_NEAR(volume(tube), 16 * pi * 25, 1e-6);
    COMPARE_NEAR(figure(tube.shape, "genus"), 1, 0);
  }

  void cornersAreMitred() {
    // A centred square section round a corner: the mitre adds outside what it takes away inside.
    const Evaluated frame = made("pipe", {}, {square(2), path({Line2{{0, 0}, {30, 0}}, Line2{{30, 0}, {30, 20}}})});
    QVERIFY(isSound(frame));
    COMPARE_NEAR(volume(frame), 16 * 50, 1e-6);
    const Evaluated closed = made("pipe", {}, {square(2), toCurves(rectangle(0, 0, 40, 30))});
    QVERIFY(isSound(closed));
    COMPARE_NEAR(volume(closed), 16 * 140, 1e-6);
    COMPARE_NEAR(figure(closed.shape, "genus"), 1, 0);
  }

  void pathsMayLeaveThePlane() {
    Curve rise{3, {0, 0, 0, 0, 1, 1, 1, 1}, {{0, 0, 0, 1}, {0, 0, 20, 1}, {30, 0, 20, 1}, {30, 30, 40, 1}}};
    const Evaluated pipe = made("pipe", {}, {disc(2), rise});
    QVERIFY(isSound(pipe));
    COMPARE_NEAR(volume(pipe), 4 * pi * figure(rise, "length"), 1e-3 * volume(pipe));
  }

  void tightBendsAreWarnedOf() {
    const Evaluated tight = made("pipe", {{"solid", false}}, {disc(3), path({Arc2{{0, 0}, 2, 0, 1}})});
    QCOMPARE(tight.warnings.size(), std::size_t{1});
    QVERIFY(tight.warnings.front().find("radius of 2 mm") != std::string::npos);
  }

  void badPathsAreRefused() {
    Curves two = path({Line2{{0, 0}, {10, 0}}});
    two.paths.push_back(path({Line2{{20, 0}, {30, 0}}}).paths.front());
    VERIFY_REFUSED(refusal("pipe", {}, {disc(1), two}), ErrorCode::InvalidInput, "one curve without gaps; it has 2 parts");
    VERIFY_REFUSED(refusal("pipe", {}, {disc(1), made("box").shape}), ErrorCode::InvalidInput, "solid");
  }
};

BLOSSOM_TEST(ModelingLoftTest)
#include "modeling_loft_test.moc"
