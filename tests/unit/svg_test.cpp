#include <fmt/format.h>

#include <Eigen/LU>
#include <numbers>

#include "exchange/svg/svg_path.h"
#include "geometry/bspline/bspline.h"
#include "geometry/planar/planar.h"
#include "support/exchange.h"
#include "support/planar_points.h"

using namespace blossom;
using namespace blossom::test;

namespace {

using std::numbers::pi;

Imported read(const std::string& content, const std::string& attributes = "") {
  return readText("<svg xmlns=\"http://www.w3.org/2000/svg\" xmlns:xlink=\"http://www.w3.org/1999/xlink\" " + attributes +
                      ">" + content + "</svg>",
                  "svg");
}
Curves curvesIn(const std::string& content, const std::string& attributes = "") {
  return *read(content, attributes).shape.get<Curves>();
}
Path onlyPathOf(const std::string& content, const std::string& attributes = "") {
  const Curves curves = curvesIn(content, attributes);
  if (curves.paths.size() != 1) qFatal("%zu paths in %s", curves.paths.size(), content.c_str());
  return curves.paths.front();
}
Vec2 middle(const Segment& s) {
  if (const Arc2* a = std::get_if<Arc2>(&s))
    return a->center + a->radius * Vec2(std::cos(a->start + a->sweep / 2), std::sin(a->start + a->sweep / 2));
  const Curve c = toCurve(std::get<Spline2>(s));
  return point(c, 0.5 * (c.domain().first + c.domain().second)).head<2>();
}

}  // namespace

class SvgTest : public QObject {
  Q_OBJECT

 private slots:
  void pageIsMirroredInPlace() {
    const Path line = onlyPathOf("<path d='M1 2L5 6'/>", "viewBox='0 0 24 24'");
    comparePoints(startPoint(line.segments[0]), {1, 22});
    comparePoints(endPoint(line.segments[0]), {5, 18});
    comparePoints(startPoint(onlyPathOf("<path d='M1 2L5 6'/>", "viewBox='10 -5 24 10'").segments[0]), {1, -2});
  }

  void physicalUnitsGiveMillimetres() {
    const auto end = [](const std::string& attributes) {
      return endPoint(onlyPathOf("<path d='M0 0L10 0'/>", attributes).segments[0]).x();
    };
    COMPARE_NEAR(end("viewBox='0 0 100 100'"), 10, 1e-12);
    COMPARE_NEAR(end("width='100' height='100'"), 10, 1e-12);
    COMPARE_NEAR(end("width='100px' height='100px' viewBox='0 0 10 10'"), 10, 1e-12);
    COMPARE_NEAR(end("width='50mm' height='50mm' viewBox='0 0 100 100'"), 5, 1e-12);
    COMPARE_NEAR(end("width='2in' height='2in' viewBox='0 0 100 100'"), 5.08, 1e-12);
    COMPARE_NEAR(end("width='5cm' height='9cm' viewBox='0 0 100 100'"), 5, 1e-12);
    COMPARE_NEAR(end("width='72pt' viewBox='0 0 100 100'"), 2.54, 1e-12);
    COMPARE_NEAR(end("width='50mm' height='50mm'"), 10 * 25.4 / 96, 1e-12);
  }

  void basicShapes() {
    COMPARE_NEAR(std::abs(signedArea(onlyPathOf("<rect x='1' y='2' width='3' height='4'/>"))), 12, 1e-12);
    COMPARE_NEAR(std::abs(signedArea(onlyPathOf("<rect width='10' height='6' rx='2'/>"))), 60 - (4 - pi) * 4, 1e-12);
    COMPARE_NEAR(std::abs(signedArea(onlyPathOf("<rect width='10' height='6' rx='20' ry='1'/>"))), 60 - (4 - pi) * 5, 1e-9);
    COMPARE_NEAR(std::abs(signedArea(onlyPathOf("<circle cx='3' cy='3' r='2'/>"))), 4 * pi, 1e-12);
    COMPARE_NEAR(std::abs(signedArea(onlyPathOf("<ellipse cx='3' cy='3' rx='2' ry='5'/>"))), 10 * pi, 1e-9);
    COMPARE_NEAR(std::abs(signedArea(onlyPathOf("<polygon points='0,0 4,0 4,3'/>"))), 6, 1e-12);
    QCOMPARE(onlyPathOf("<polyline points='0 0 4 0 4 3' fill='none'/>").closed, false);
    QCOMPARE(onlyPathOf("<polyline points='0 0 4 0 4 3'/>").closed, true);
    QCOMPARE(onlyPathOf("<line x1='1' y1='1' x2='2' y2='2' stroke='red'/>").closed, false);
    QCOMPARE(curvesIn("<rect width='0' height='6'/><circle r='-1'/>").paths.size(), std::size_t(0));
  }

  void pathCommands() {
    const Curves curves = curvesIn("<path fill='none' d='M1,1h2v2H1zm5 0l1-1.5.5.5q1 1 2 0t2 0c1 1 2 1 3 0s2-1 3 0'/>");
    QCOMPARE(curves.paths.size(), std::size_t(2));
    COMPARE_NEAR(std::abs(signedArea(curves.paths[0])), 4, 1e-12);
    QCOMPARE(curves.paths[1].segments.size(), std::size_t(6));
    const Spline2& cubic = std::get<Spline2>(curves.paths[1].segments[4]);
    QCOMPARE(cubic.degree, 3);
    QCOMPARE(cubic.knots, (std::vector<double>{0, 0, 0, 0, 1, 1, 1, 1}));
    // A new subpath without M starts where the last one closed.
    const Curves twice = curvesIn("<path d='M0 0h1v1zh-1v-1z'/>");
    QCOMPARE(twice.paths.size(), std::size_t(2));
    comparePoints(startPoint(twice.paths[1].segments[0]), {0, 0});
  }

  void arcsKeepTheRules() {
    // Unit semicircles over (0,0)-(2,0), y down in the file: sweep 1 bulges up on the page.
    comparePoints(middle(onlyPathOf("<path fill='none' d='M0 0A1 1 0 0 1 2 0'/>").segments[0]), {1, 1});
    comparePoints(middle(onlyPathOf("<path fill='none' d='M0 0A1 1 0 0 0 2 0'/>").segments[0]), {1, -1});
    // Radii too small are scaled up; zero radii make a line.
    comparePoints(middle(onlyPathOf("<path fill='none' d='M0 0A.1 .1 0 0 1 2 0'/>").segments[0]), {1, 1});
    comparePoints(middle(svg::arcSegment({0, 0}, {2, 0}, 1e-320, 1e-320, 0, false, true).at(0)), {1, -1}, 1e-9);
    QVERIFY(std::holds_alternative<Line2>(svg::arcSegment({0, 0}, {2, 0}, 1e-320, 5, 0, false, true).at(0)));
    // The ends of a half circle, in doubles, lie where they lie; its centre does not move by the root of their rounding.
    for (int k = 0; k < 200; ++k) {
      const Vec2 end = 1000 * Vec2(std::cos(0.1 * k), std::sin(0.1 * k)), middle(500, 3);
      const auto half = std::get<Arc2>(svg::arcSegment(middle + end, middle - end, 1000, 1000, 0, false, true).at(0));
      QVERIFY2((half.center - middle).norm() < 1e-9, qPrintable(QString::number((half.center - middle).norm())));
    }
    QVERIFY(std::holds_alternative<Line2>(onlyPathOf("<path fill='none' d='M0 0A0 5 0 0 1 2 0'/>").segments[0]));
    COMPARE_NEAR(length(onlyPathOf("<path fill='none' d='M1 0A1 1 0 1 1 0 -1'/>").segments[0]), 1.5 * pi, 1e-12);
    COMPARE_NEAR(length(onlyPathOf("<path fill='none' d='M1 0A1 1 0 0 0 0 -1'/>").segments[0]), 0.5 * pi, 1e-12);
  }

  void randomArcsLieOnTheirEllipse() {
    std::mt19937_64 random = seededRandom();
    std::uniform_real_distribution<double> anywhere(-10, 10), radius(6, 20), degrees(-180, 180);
    for (int i = 0; i < 300; ++i) {
      const Vec2 from(anywhere(random), anywhere(random)), to(anywhere(random), anywhere(random));
      const double rx = 2 * radius(random), ry = 2 * radius(random), rotation = degrees(random);
      const bool large = i % 2, sweep = i / 2 % 2;
      const Segment s = onlyPathOf(fmt::format("<path fill='none' d='M{} {}A{} {} {} {} {} {} {}'/>", from.x(), from.y(), rx,
                                               ry, rotation, large ? 1 : 0, sweep ? 1 : 0, to.x(), to.y()))
                            .segments[0];
      comparePoints(startPoint(s), {from.x(), -from.y()}, 1e-9);
      comparePoints(endPoint(s), {to.x(), -to.y()}, 1e-9);
      // In the frame of the ellipse all points keep the distance 1 from one centre; three of them find it, others prove it.
      const Spline2* spline = std::get_if<Spline2>(&s);
      QVERIFY(spline);
      const Curve curve = toCurve(*spline);
      const double angle = rotation * pi / 180;
      const auto unit = [&](double share) {
        const double t = curve.domain().first + share * (curve.domain().second - curve.domain().first);
        const Vec2 p = point(curve, t).head<2>();
        const Vec2 q(p.x(), -p.y());
        return Vec2(Vec2(std::cos(angle), std::sin(angle)).dot(q) / rx, Vec2(-std::sin(angle), std::cos(angle)).dot(q) / ry);
      };
      const Vec2 a = unit(0), b = unit(0.5), c = unit(1);
      Eigen::Matrix2d m;
      m.row(0) = 2 * (b - a);
      m.row(1) = 2 * (c - a);
      const Vec2 center = m.inverse() * Vec2(b.squaredNorm() - a.squaredNorm(), c.squaredNorm() - a.squaredNorm());
      double turned = 0;
      for (int k = 0; k <= 20; ++k) {
        const Vec2 p = unit(k / 20.0) - center;
        COMPARE_NEAR(p.norm(), 1, 1e-6);
        if (k > 0) {
          const Vec2 q = unit((k - 1) / 20.0) - center;
          turned += std::atan2(q.x() * p.y() - q.y() * p.x(), q.dot(p));
        }
      }
      QCOMPARE(std::abs(turned) > pi, large);
      QCOMPARE(turned > 0, sweep);
    }
  }

  void transformsNest() {
    const auto start = [](const std::string& content) { return startPoint(onlyPathOf(content).segments[0]); };
    const std::string line = "<path d='M1 0L2 0'/>";
    comparePoints(start("<g transform='translate(10,20) scale(2)'>" + line + "</g>"), {12, -20});
    comparePoints(start("<g transform='rotate(90)'>" + line + "</g>"), {0, -1});
    comparePoints(start("<g transform='rotate(90 1 1)'>" + line + "</g>"), {2, -1});
    comparePoints(start("<g transform='matrix(1 2 3 4 5 6)'>" + line + "</g>"), {6, -8});
    comparePoints(start("<g transform='skewY(45)'>" + line + "</g>"), {1, -1});
    comparePoints(start("<g transform='skewX(45)translate(0-1)'>" + line + "</g>"), {0, 1});
    comparePoints(
        start("<g transform='scale(2)'><g transform='translate(1)'><path transform='scale(3)' d='M1 0L2 0'/></g></g>"),
        {8, 0});
    VERIFY_ERROR(read("<g transform='twist(3)'>" + line + "</g>"), ErrorCode::FormatDamaged);
    VERIFY_ERROR(read("<g transform='scale(1e300)'><g transform='scale(1e300)'>" + line + "</g></g>"),
                 ErrorCode::FormatDamaged);
  }

  void useAndSymbol() {
    const Imported twice = read(
        "<defs><path id='a' d='M0 0h1v1z'/></defs><use href='#a' x='5'/><use xlink:href='#a' y='7' transform='scale(2)'/>");
    const Curves& curves = *twice.shape.get<Curves>();
    QCOMPARE(curves.paths.size(), std::size_t(2));
    QCOMPARE(twice.entities, (Value{{"use", 2}}));
    comparePoints(startPoint(curves.paths[0].segments[0]), {5, 0});
    comparePoints(startPoint(curves.paths[1].segments[0]), {0, -14});
    // The symbol's box is fitted into the size of the use.
    const Path symbol = onlyPathOf(
        "<symbol id='s' viewBox='0 0 10 10'><rect width='10' height='10'/></symbol><use href='#s' width='20' height='40'/>");
    COMPARE_NEAR(std::abs(signedArea(symbol)), 400, 1e-9);
    comparePoints(startPoint(symbol.segments[0]), {0, -10});
  }

  void cyclesAndExplosionsEnd() {
    VERIFY_ERROR(read("<g id='a'><use href='#b'/></g><g id='b'><use href='#a'/></g>"), ErrorCode::FormatDamaged);
    std::string bomb = "<g id='a0'><path d='M0 0h1v1z'/></g>";
    for (int i = 1; i < 30; ++i)
      bomb += fmt::format("<g id='a{0}'><use href='#a{1}'/><use href='#a{1}'/><use href='#a{1}'/></g>", i, i - 1);
    VERIFY_ERROR(read("<defs>" + bomb + "</defs><use href='#a29'/>"), ErrorCode::LimitExceeded);
    std::string deep, end;
    for (int i = 0; i < 100000; ++i) deep += "<g>", end += "</g>";
    VERIFY_ERROR(read(deep + end), ErrorCode::LimitExceeded);
  }

  void whatIsNotDrawnIsNotRead() {
    const Imported imported = read(
        "<defs><path d='M0 0h1'/></defs><clipPath><rect width='1' height='1'/></clipPath><mask><circle r='1'/></mask><g "
        "display='none'><circle r='1'/></g>"
        "<circle style='display:none' r='1'/><circle visibility='hidden' "
        "r='2'/><text>hello</text><image/><style>.a{display:none}</style><circle class='a' r='1'/>");
    QCOMPARE(imported.shape.get<Curves>()->paths.size(), std::size_t(0));
    QCOMPARE(imported.skipped, (Value{{"image", 1}, {"text", 1}}));
    QVERIFY(!imported.warnings.empty());
  }

  void whatIsCroppedIsTold() {
    const std::string square = "<rect width='10' height='10'/>";
    const std::string ways = "<defs><clipPath id='c'/><mask id='m'/></defs>";
    for (const std::string none :
         {"clip-path='none'", "clip-path='url(#gone)'", "clip-path='url(#c)' style='clip-path:none'"})
      QVERIFY(read(ways + square + "<g " + none + ">" + square + "</g>").warnings.empty());
    for (const std::string way : {"clip-path='url(#c)'", "style='clip-path:url(#c)'", "mask='url(#m)'"}) {
      const Imported cropped =
          read(ways + square + "<g " + way + "><g style='clip-path:none'>" + square + square + "</g></g>");
      QCOMPARE(cropped.warnings.size(), std::size_t{1});
      QVERIFY2(cropped.warnings[0].ends_with("may crop them: 2 of its shapes."), cropped.warnings[0].c_str());
    }
  }

  void whatANestedWindowCropsIsTold() {
    const auto told = [](const std::string& body) {
      const Imported imported = read(body, "viewBox='0 0 100 100'");
      return imported.warnings.empty() ? std::string() : imported.warnings.front();
    };
    const std::string inside = "<circle cx='10' cy='10' r='10'/>", outside = "<circle cx='10' cy='10' r='10.1'/>";
    const auto nested = [](const std::string& more, const std::string& body) {
      return "<svg x='30' width='20' height='20' " + more + ">" + body + "</svg>";
    };
    const std::string sentence = "the window of a nested svg or symbol may crop them: 1 of its shapes.";
    QCOMPARE(told(nested("", inside)), std::string());
    QVERIFY(told(nested("", inside + outside)).ends_with(sentence));
    QVERIFY(told(nested("overflow='visible'", nested("style='overflow:hidden'", outside))).ends_with(sentence));
    for (const char* shown : {"overflow='visible'", "style='overflow:visible'"})
      QCOMPARE(told(nested(shown, outside)), std::string());
    // The circle of radius 10 about (10, 10) seen through boxes of its size, half of it, and turned with all around it.
    QCOMPARE(told(nested("viewBox='0 0 20 20'", inside)), std::string());
    QVERIFY(told(nested("viewBox='0 0 10 10'", inside)).ends_with(sentence));
    QCOMPARE(told("<g transform='rotate(30) scale(2)'>" + nested("", inside) + "</g>"), std::string());
    // A symbol has the size that its use gives it; per cents within a window are of that window.
    const std::string symbol =
        "<symbol id='s' viewBox='0 0 20 20'>" + inside + "<rect width='100%' height='100%'/></symbol>";
    QCOMPARE(told(symbol + "<use href='#s' width='5' height='5'/>"), std::string());
    QCOMPARE(told(nested("", "<rect width='100%' height='100%'/>")), std::string());
    QVERIFY(told("<symbol id='s'>" + outside + "</symbol><use href='#s' width='20' height='20'/>").ends_with(sentence));
  }

  void paintAndLayer() {
    const Curves curves = curvesIn(
        "<g id='cut'><circle r='1' fill='#ff0000'/><g inkscape:label='inner' style='fill:none;stroke:rgb(0,0,255)'><circle "
        "r='1'/></g></g><circle r='1'/>",
        "xmlns:inkscape='http://www.inkscape.org/namespaces/inkscape'");
    QCOMPARE(curves.paths[0].layer, std::string("cut"));
    QCOMPARE(curves.paths[0].color, std::optional(Color{1, 0, 0}));
    QCOMPARE(curves.paths[1].layer, std::string("inner"));
    QCOMPARE(curves.paths[1].color, std::optional(Color{0, 0, 1}));
    QVERIFY(!curves.paths[2].color);
    QCOMPARE(curves.fillRule, FillRule::NonZero);
    QCOMPARE(curvesIn("<path fill-rule='evenodd' d='M0 0h1v1z'/>").fillRule, FillRule::EvenOdd);
  }

  void refusesDamage_data() {
    QTest::addColumn<QString>("text");
    QTest::newRow("cut off") << "<svg><path d='M0 0";
    QTest::newRow("unclosed") << "<svg><g></svg>";
    QTest::newRow("not svg") << "<html><svg/></html>";
    QTest::newRow("text") << "hello";
    QTest::newRow("broken path") << "<svg><path d='M0 0 Q hello'/></svg>";
    QTest::newRow("path without M") << "<svg><path d='L 1 1'/></svg>";
    QTest::newRow("infinite") << "<svg><path d='M0 0L1e999 0'/></svg>";
    QTest::newRow("huge") << "<svg><path d='M0 0L1e200 0'/></svg>";
    QTest::newRow("nan") << "<svg><rect width='nan' height='1'/></svg>";
    QTest::newRow("odd points") << "<svg><polygon points='1 2 3'/></svg>";
    QTest::newRow("words for points") << "<svg><polygon points='a b'/></svg>";
    QTest::newRow("broken viewBox") << "<svg viewBox='0 0 1'/>";
  }
  void refusesDamage() {
    QFETCH(QString, text);
    VERIFY_ERROR(readText(text.toStdString(), "svg"), ErrorCode::FormatDamaged);
  }

  void roundTripKeepsCurves() {
    Curves curves;
    const auto add = [&](std::vector<Segment> segments, bool closed) {
      curves.paths.push_back({std::move(segments), closed, "a & b", Color{0, 0.4, 1}});
    };
    add({Line2{{-7, 3}, {5, 9}}}, false);
    add({Arc2{{3, 4}, 2.5, 0.3, 4}}, false);
    add({Arc2{{3, 4}, 2.5, 0.3, -2 * pi}}, true);
    add({Spline2{3, {0, 0, 0, 0, 1, 2, 2, 2, 2}, {{0, 0, 1}, {1, 3, 1}, {4, 4, 1}, {6, -2, 1}, {8, 1, 1}}}}, false);
    add({ellipticArc({1, 2}, {3, 1}, 0.5, 0.2, 2 * pi)}, true);
    add({Line2{{0, 0}, {4, 0}}, Line2{{4, 0}, {4, 3}}, Line2{{4, 3}, {0, 0}}}, true);
    const Curves back = *roundTrip(curves, "svg").shape.get<Curves>();
    QCOMPARE(back.paths.size(), curves.paths.size());
    for (std::size_t i = 0; i < curves.paths.size(); ++i) {
      const Path &a = curves.paths[i], &b = back.paths[i];
      QCOMPARE(b.closed, a.closed);
      QCOMPARE(b.layer, a.layer);
      QCOMPARE(toHex(*b.color), toHex(*a.color));
      comparePoints(startPoint(b.segments.front()), startPoint(a.segments.front()), 1e-9);
      comparePoints(endPoint(b.segments.back()), endPoint(a.segments.back()), 1e-9);
      COMPARE_NEAR(length(b), length(a), 1e-9);
      if (a.closed) COMPARE_NEAR(signedArea(b), signedArea(a), 1e-9);
    }
  }

  void noColourStaysNone() {
    Curves curves;
    curves.paths.push_back({{Arc2{{0, 0}, 1, 0, 2 * pi}}, true, {}, {}});
    curves.paths.push_back({{Line2{{0, 0}, {1, 0}}}, false, {}, {}});
    const Curves back = *roundTrip(curves, "svg").shape.get<Curves>();
    for (const Path& path : back.paths) QVERIFY(!path.color);
  }

  void otherSplinesStayWithinTheTolerance() {
    Spline2 wild{4, {0, 0, 0, 0, 0, 0.4, 1, 1, 1, 1, 1}, {}};
    const std::array<Vec3, 6> poles{Vec3(0, 0, 1), {3, 9, 2}, {8, -4, 0.5}, {12, 5, 3}, {15, 0, 1}, {20, 4, 1}};
    for (const Vec3& p : poles) wild.poles.emplace_back(p.x() * p.z(), p.y() * p.z(), p.z());
    Curves curves;
    curves.paths.push_back({{wild}, false, {}, {}});
    for (const double tolerance : {1e-1, 1e-3, 1e-5}) {
      const Curves back = *roundTrip(curves, "svg", {{"tolerance", tolerance}}).shape.get<Curves>();
      // Every point of a fine polyline of the one is near the fine polyline of the other.
      const std::vector<Vec2> a = flatten(curves.paths[0], 1e-7), b = flatten(back.paths[0], 1e-7);
      for (std::size_t i = 0; i < a.size(); i += 7) {
        double nearest = 1e9;
        for (std::size_t k = 0; k + 1 < b.size(); ++k) {
          const Vec2 d = b[k + 1] - b[k];
          const double t = std::clamp((a[i] - b[k]).dot(d) / d.squaredNorm(), 0.0, 1.0);
          nearest = std::min(nearest, (a[i] - b[k] - t * d).norm());
        }
        QVERIFY2(nearest <= tolerance + 1e-6, qPrintable(QString::number(nearest)));
      }
    }
  }
};

BLOSSOM_TEST(SvgTest)
#include "svg_test.moc"
