#include <fmt/format.h>

#include <numbers>

#include "geometry/bspline/bspline.h"
#include "geometry/planar/planar.h"
#include "support/exchange.h"
#include "support/planar_points.h"

using namespace blossom;
using namespace blossom::test;

namespace {

using std::numbers::pi;

/// "0 LINE 10 1" with a group per two words becomes the lines of a DXF file.
std::string groups(const std::string& words) {
  std::string out = words;
  std::replace(out.begin(), out.end(), ' ', '\n');
  return out + "\n";
}
std::string drawing(const std::string& entities, const std::string& blocks = "", const std::string& header = "") {
  return groups("0 SECTION 2 HEADER" + header + " 0 ENDSEC") + groups("0 SECTION 2 BLOCKS" + blocks + " 0 ENDSEC") +
         groups("0 SECTION 2 ENTITIES" + entities + " 0 ENDSEC 0 EOF");
}
std::string blockEntity(const std::string& name, const std::string& entities, const std::string& base = "10 0 20 0") {
  return " 0 BLOCK 2 " + name + " " + base + entities + " 0 ENDBLK";
}

Curves curvesOf(const std::string& text) { return *readText(text, "dxf").shape.get<Curves>(); }
Path onlyPath(const std::string& text) {
  const Curves curves = curvesOf(text);
  if (curves.paths.size() != 1) qFatal("%zu paths", curves.paths.size());
  return curves.paths.front();
}

}  // namespace

class DxfTest : public QObject {
  Q_OBJECT

 private slots:
  void readsLinesArcsAndCircles() {
    const Imported imported = readText(
        drawing(" 0 LINE 8 cut 62 1 10 1 20 2 11 3 21 4 0 ARC 10 0 20 0 40 2 50 350 51 10 0 CIRCLE 10 5 20 6 40 7"), "dxf");
    QCOMPARE(imported.entities, (Value{{"ARC", 1}, {"CIRCLE", 1}, {"LINE", 1}}));
    const Curves& curves = *imported.shape.get<Curves>();
    QCOMPARE(std::get<Line2>(curves.paths[0].segments[0]), (Line2{{1, 2}, {3, 4}}));
    QCOMPARE(curves.paths[0].layer, std::string("cut"));
    QCOMPARE(curves.paths[0].color, std::optional(Color{1, 0, 0}));
    COMPARE_NEAR(length(curves.paths[1]), 2 * 20 * pi / 180, 1e-12);
    QVERIFY(curves.paths[2].closed);
    COMPARE_NEAR(signedArea(curves.paths[2]), pi * 49, 1e-9);
  }

  void bulgesAreArcs() {
    // Two half circles over a diameter of 2.
    const Path disc = onlyPath(drawing(" 0 LWPOLYLINE 90 2 70 1 10 -1 20 0 42 1 10 1 20 0 42 1"));
    COMPARE_NEAR(signedArea(disc), pi, 1e-12);
    const Path old = onlyPath(drawing(" 0 POLYLINE 66 1 70 1 0 VERTEX 10 -1 20 0 42 -1 0 VERTEX 10 1 20 0 42 -1 0 SEQEND"));
    COMPARE_NEAR(signedArea(old), -pi, 1e-12);
    std::mt19937_64 random = seededRandom();
    std::uniform_real_distribution<double> anywhere(-5, 5);
    for (int i = 0; i < 200; ++i) {
      const double x = anywhere(random), y = anywhere(random), bulge = anywhere(random);
      const Path arc = onlyPath(drawing(fmt::format(" 0 LWPOLYLINE 90 2 70 0 10 0 20 0 42 {} 10 {} 20 {}", bulge, x, y)));
      comparePoints(startPoint(arc.segments[0]), {0, 0}, 1e-11 * (1 + std::abs(bulge)));
      comparePoints(endPoint(arc.segments[0]), {x, y}, 1e-11 * (1 + std::abs(bulge)));
      // The bulge is the height of the arc over half of its chord, to the right of the chord when positive.
      const Arc2& a = std::get<Arc2>(arc.segments[0]);
      const Vec2 top = a.center + a.radius * Vec2(std::cos(a.start + a.sweep / 2), std::sin(a.start + a.sweep / 2));
      const Vec2 chord(x, y), right(y, -x);
      COMPARE_NEAR((top - chord / 2).dot(right) / right.squaredNorm(), bulge / 2, 1e-9);
    }
  }

  void ellipsesAreExact() {
    const Path whole = onlyPath(drawing(" 0 ELLIPSE 10 1 20 2 11 3 21 4 40 0.5 41 0 42 6.283185307179586"));
    COMPARE_NEAR(signedArea(whole), pi * 5 * 2.5, 1e-9);
    QVERIFY(whole.closed);
    const Path quarter = onlyPath(drawing(" 0 ELLIPSE 10 0 20 0 11 2 21 0 40 0.5 41 0 42 1.5707963267948966"));
    comparePoints(startPoint(quarter.segments[0]), {2, 0});
    comparePoints(endPoint(quarter.segments[0]), {0, 1});
    const Path mirrored =
        onlyPath(drawing(" 0 ELLIPSE 210 0 220 0 230 -1 10 0 20 0 11 2 21 0 40 0.5 41 0 42 1.5707963267948966"));
    comparePoints(endPoint(mirrored.segments[0]), {0, -1});
  }

  void extrusionMirrors() {
    const Path arc = onlyPath(drawing(" 0 ARC 210 0 220 0 230 -1 10 5 20 0 40 1 50 0 51 90"));
    comparePoints(startPoint(arc.segments[0]), {-6, 0});
    comparePoints(endPoint(arc.segments[0]), {-5, 1});
  }

  void rationalSplinesKeepTheirWeights() {
    // A quarter of the unit circle.
    const Path path =
        onlyPath(drawing(" 0 SPLINE 70 12 71 2 72 6 73 3 40 0 40 0 40 0 40 1 40 1 40 1 41 1 41 0.7071067811865476 41 1 10 1 "
                         "20 0 30 0 10 1 20 1 30 0 10 0 20 1 30 0"));
    const Spline2& spline = std::get<Spline2>(path.segments[0]);
    for (int i = 0; i <= 10; ++i) COMPARE_NEAR(pointOf(spline, i / 10.0).norm(), 1, 1e-14);
  }

  void fitPointsAreInterpolated() {
    const Imported imported = readText(drawing(" 0 SPLINE 70 8 71 3 74 4 11 0 21 0 11 1 21 2 11 3 21 2 11 4 21 0"), "dxf");
    QCOMPARE(imported.warnings.size(), std::size_t(1));
    const Spline2& spline = std::get<Spline2>(imported.shape.get<Curves>()->paths[0].segments[0]);
    QCOMPARE(spline.knots.size(), spline.poles.size() + 4);
    comparePoints(pointOf(spline, spline.knots[4]), {1, 2});
    comparePoints(pointOf(spline, spline.knots[7]), {3, 2});
    for (const std::size_t knot : {4u, 7u}) {  // smooth to the second derivative
      const double h = 1e-4, t = spline.knots[knot];
      const Vec2 before = pointOf(spline, t) - 2 * pointOf(spline, t - h) + pointOf(spline, t - 2 * h),
                 after = pointOf(spline, t + 2 * h) - 2 * pointOf(spline, t + h) + pointOf(spline, t);
      comparePoints(before / (h * h), after / (h * h), 1e-2);
    }
  }

  void closedFitPointsGiveAPeriodicSpline() {
    std::string entity = " 0 SPLINE 70 9 71 3 74 16";
    for (int i = 0; i < 16; ++i) entity += fmt::format(" 11 {} 21 {}", std::cos(i * pi / 8), std::sin(i * pi / 8));
    const Path path = onlyPath(drawing(entity));
    QVERIFY(path.closed);
    COMPARE_NEAR(signedArea(path), pi, 2e-3);
    const Spline2& s = std::get<Spline2>(path.segments[0]);
    const Vec3 tangents = s.poles[1] - s.poles[0] - (s.poles.back() - s.poles[s.poles.size() - 2]);
    COMPARE_NEAR(tangents.norm(), 0, 1e-12);
  }

  void blocksAreScaledRotatedAndRepeated() {
    const std::string unit = blockEntity("B", " 0 LINE 10 1 20 0 11 2 21 0", "10 1 20 0");
    const Curves grid = curvesOf(drawing(" 0 INSERT 2 b 10 10 20 20 41 2 42 3 50 90 70 3 71 2 44 5 45 7", unit));
    QCOMPARE(grid.paths.size(), std::size_t(6));
    // Spacing turns with the insert but is not scaled.
    comparePoints(startPoint(grid.paths[0].segments[0]), {10, 20});
    comparePoints(endPoint(grid.paths[0].segments[0]), {10, 22});
    comparePoints(startPoint(grid.paths[1].segments[0]), {10, 25});
    comparePoints(startPoint(grid.paths[3].segments[0]), {3, 20});
    const Curves mirrored = curvesOf(drawing(" 0 INSERT 2 A 41 -1", blockEntity("A", " 0 INSERT 2 B 10 1") + unit));
    comparePoints(endPoint(mirrored.paths[0].segments[0]), {-2, 0});
  }

  void blocksTakeLayerAndColourFromTheirInsert() {
    const std::string content =
        blockEntity("B", " 0 LINE 8 0 62 0 10 0 20 0 11 1 21 0 0 LINE 8 own 62 3 10 0 20 0 11 1 21 0");
    const Curves curves = curvesOf(drawing(" 0 INSERT 2 B 8 outer 62 5", content));
    QCOMPARE(curves.paths[0].layer, std::string("outer"));
    QCOMPARE(curves.paths[0].color, std::optional(Color{0, 0, 1}));
    QCOMPARE(curves.paths[1].layer, std::string("own"));
    QCOMPARE(curves.paths[1].color, std::optional(Color{0, 1, 0}));
  }

  void lengthsBecomeMillimetres() {
    comparePoints(endPoint(onlyPath(drawing(" 0 LINE 10 0 20 0 11 1 21 2", "", " 9 $INSUNITS 70 1")).segments[0]),
                  {25.4, 50.8});
    comparePoints(endPoint(onlyPath(drawing(" 0 LINE 10 0 20 0 11 1 21 2", "", " 9 $INSUNITS 70 0")).segments[0]), {1, 2});
    COMPARE_NEAR(signedArea(onlyPath(drawing(" 0 CIRCLE 10 0 20 0 40 1", "", " 9 $INSUNITS 70 6"))), pi * 1e6, 1e-3);
  }

  void hatchBoundariesAreClosed() {
    const Path square =
        onlyPath(drawing(" 0 HATCH 10 0 20 0 30 0 2 SOLID 70 1 71 0 91 1 92 2 72 0 73 1 93 4 10 0 20 0 10 2 20 0 10 2 20 2 "
                         "10 0 20 2 97 0 75 0 76 1 98 1 10 1 20 1"));
    COMPARE_NEAR(signedArea(square), 4, 1e-12);
    const Path halfDisc =
        onlyPath(drawing(" 0 HATCH 10 0 20 0 30 0 70 1 91 1 92 1 93 2 72 1 10 -1 20 0 11 1 21 0 72 2 10 0 20 0 40 1 50 0 51 "
                         "180 73 1 97 0 75 0 76 1 98 0"));
    QVERIFY(halfDisc.closed);
    COMPARE_NEAR(signedArea(halfDisc), pi / 2, 1e-12);
  }

  void countsWhatItLeavesOut() {
    const Imported imported = readText(drawing(" 0 TEXT 1 hello 0 LINE 10 0 20 0 11 1 21 0 0 POINT 10 0 20 0 0 LINE 67 1 10 "
                                               "0 20 0 11 1 21 0 0 POLYLINE 70 64 0 VERTEX 70 192 10 0 20 0 0 SEQEND"),
                                       "dxf");
    QCOMPARE(imported.entities, (Value{{"LINE", 1}, {"POINT", 1}}));
    QCOMPARE(imported.skipped, (Value{{"LINE", 1}, {"POLYLINE", 1}, {"TEXT", 1}}));
    QCOMPARE(imported.shape.get<Curves>()->paths.size(), std::size_t(1));
  }

  void refusesDamage_data() {
    QTest::addColumn<QString>("text");
    const auto row = [](const char* name, const std::string& text) { QTest::newRow(name) << QString::fromStdString(text); };
    row("no EOF", groups("0 SECTION 2 ENTITIES 0 ENDSEC"));
    row("no end of section", groups("0 SECTION 2 ENTITIES 0 LINE 10 0 0 EOF"));
    row("no entities", groups("0 SECTION 2 HEADER 0 ENDSEC 0 EOF"));
    row("word for a code", groups("0 SECTION 2 ENTITIES 0 LINE x 0 0 ENDSEC 0 EOF"));
    row("word for a number", drawing(" 0 LINE 10 a 20 0 11 1 21 1"));
    row("nan", drawing(" 0 LINE 10 nan 20 0 11 1 21 1"));
    row("too large", drawing(" 0 LINE 10 1e300 20 0 11 1 21 1"));
    row("spline without poles", drawing(" 0 SPLINE 70 8 71 3 72 8 73 4"));
    row("spline with too few knots", drawing(" 0 SPLINE 70 8 71 1 40 0 40 1 10 0 20 0 10 1 20 1"));
    row("spline with falling knots", drawing(" 0 SPLINE 70 8 71 1 40 0 40 1 40 0 40 1 10 0 20 0 10 1 20 1"));
    row("spline with equal knots", drawing(" 0 SPLINE 70 8 71 1 40 0 40 0 40 0 40 0 10 0 20 0 10 1 20 1"));
    row("spline with weight zero", drawing(" 0 SPLINE 70 12 71 1 40 0 40 0 40 1 40 1 41 0 41 1 10 0 20 0 10 1 20 1"));
    row("bulge before its vertex", drawing(" 0 LWPOLYLINE 90 2 42 1 10 0 20 0 10 1 20 1"));
    row("polyline without vertices", drawing(" 0 LWPOLYLINE 90 1000000"));
    row("insert without block", drawing(" 0 INSERT 10 0 20 0"));
    row("block in a block", drawing("", " 0 BLOCK 2 A 0 BLOCK 2 B 0 ENDBLK 0 ENDBLK"));
    row("block without end", drawing("", " 0 BLOCK 2 A 0 LINE 10 0"));
    row("block in itself", drawing(" 0 INSERT 2 A", blockEntity("A", " 0 INSERT 2 B") + blockEntity("B", " 0 INSERT 2 A")));
    row("binary", "AutoCAD Binary DXF\r\n\x1a");
  }
  void refusesDamage() {
    QFETCH(QString, text);
    VERIFY_ERROR(readText(text.toStdString(), "dxf"), ErrorCode::FormatDamaged);
  }

  void falseCountsDoNoHarm() {
    const Curves curves = curvesOf(
        drawing(" 0 LWPOLYLINE 90 2000000000 70 0 10 0 20 0 10 1 20 1 0 LWPOLYLINE 90 -3 70 0 10 0 20 0 10 1 20 1 0 "
                "LWPOLYLINE 70 0 10 0 20 0 10 1 20 1 10 2 20 2"
                " 0 SPLINE 71 1 72 2000000000 73 2000000000 74 2000000000 40 0 40 0 40 1 40 1 10 0 20 0 10 1 20 1"));
    QCOMPARE(curves.paths.size(), std::size_t(4));
    QCOMPARE(curves.paths[2].segments.size(), std::size_t(2));
  }

  void arraysOfArraysEnd() {
    std::string blocks = blockEntity("B0", " 0 LINE 10 0 20 0 11 1 21 0");
    for (int i = 1; i < 12; ++i)
      blocks += blockEntity(fmt::format("B{}", i), fmt::format(" 0 INSERT 2 B{} 70 100 71 100 44 1 45 1", i - 1));
    VERIFY_ERROR(readText(drawing(" 0 INSERT 2 B11", blocks), "dxf"), ErrorCode::LimitExceeded);
    VERIFY_ERROR(readText(drawing(" 0 INSERT 2 E 70 30000 71 30000", blockEntity("E", "")), "dxf"),
                 ErrorCode::LimitExceeded);
  }

  void longLinesDoNotHang() {
    VERIFY_ERROR(readText(drawing(" 0 LINE 10 " + std::string(5000, '1') + " 20 0"), "dxf"), ErrorCode::FormatDamaged);
    VERIFY_ERROR(readText(drawing(" 0 LINE 8 " + std::string(5000, 'x') + " 10 1"), "dxf"), ErrorCode::FormatDamaged);
  }

  void canBeCancelled() {
    CancelToken token;
    token.cancel();
    const TemporaryFolder folder;
    writeText(folder.path() / "a.dxf", drawing(" 0 LINE 10 0 20 0 11 1 21 0"));
    VERIFY_ERROR(readShape(formats(), folder.path() / "a.dxf", Value::object(), Progress(token)), ErrorCode::Cancelled);
  }

  void roundTripKeepsEveryCurve() {
    std::mt19937_64 random = seededRandom();
    std::uniform_real_distribution<double> anywhere(-100, 100), positive(0.1, 10);
    Curves curves;
    const auto add = [&](std::vector<Segment> segments, bool closed) {
      curves.paths.push_back({std::move(segments), closed, "layer", Color{1, 0.2, 0.4}});
    };
    const auto somewhere = [&] { return Vec2(anywhere(random), anywhere(random)); };
    for (int i = 0; i < 20; ++i) {
      add({Line2{somewhere(), somewhere()}}, false);
      add({Arc2{somewhere(), positive(random), anywhere(random) / 50, positive(random) / 2}}, false);
      add({Arc2{somewhere(), positive(random), 0, 2 * pi}}, true);
      Spline2 spline{3, {0, 0, 0, 0, 0.3, 1, 1, 1, 1}, {}};
      for (int k = 0; k < 5; ++k) {
        const double w = positive(random);
        spline.poles.emplace_back(w * anywhere(random), w * anywhere(random), w);
      }
      add({spline}, false);
      // A slot: two lines and two half circles.
      const Vec2 c = somewhere();
      const double r = positive(random);
      add({Line2{c + Vec2(0, -r), c + Vec2(9, -r)}, Arc2{c + Vec2(9, 0), r, -pi / 2, pi},
           Line2{c + Vec2(9, r), c + Vec2(0, r)}, Arc2{c, r, pi / 2, pi}},
          true);
    }
    const Imported back = roundTrip(curves, "dxf");
    QCOMPARE(back.entities, (Value{{"ARC", 20}, {"CIRCLE", 20}, {"LINE", 20}, {"LWPOLYLINE", 20}, {"SPLINE", 20}}));
    const Curves& other = *back.shape.get<Curves>();
    QCOMPARE(other.paths.size(), curves.paths.size());
    for (std::size_t i = 0; i < curves.paths.size(); ++i) {
      const Path &a = curves.paths[i], &b = other.paths[i];
      QCOMPARE(b.closed, a.closed);
      QCOMPARE(b.layer, a.layer);
      QCOMPARE(toHex(*b.color), toHex(*a.color));
      QCOMPARE(b.segments.size(), a.segments.size());
      for (std::size_t s = 0; s < a.segments.size(); ++s) compareSegments(b.segments[s], a.segments[s]);
    }
  }

 private:
  static void compareSegments(const Segment& actual, const Segment& expected) {
    QCOMPARE(actual.index(), expected.index());
    if (const Line2* line = std::get_if<Line2>(&expected)) {
      comparePoints(std::get<Line2>(actual).from, line->from);
      comparePoints(std::get<Line2>(actual).to, line->to);
    } else if (const Spline2* spline = std::get_if<Spline2>(&expected)) {
      const Spline2& other = std::get<Spline2>(actual);
      QCOMPARE(other.knots, spline->knots);
      for (std::size_t i = 0; i < spline->poles.size(); ++i)
        COMPARE_NEAR((other.poles[i] - spline->poles[i]).norm(), 0, 1e-12 * (1 + spline->poles[i].norm()));
    } else {
      const Arc2 &a = std::get<Arc2>(actual), &e = std::get<Arc2>(expected);
      comparePoints(a.center, e.center);
      COMPARE_NEAR(a.radius, e.radius, 1e-12);
      comparePoints(startPoint(actual), startPoint(expected));
      comparePoints(endPoint(actual), endPoint(expected));
      COMPARE_NEAR(a.sweep, e.sweep, 1e-12);
    }
  }
};

BLOSSOM_TEST(DxfTest)
#include "dxf_test.moc"
