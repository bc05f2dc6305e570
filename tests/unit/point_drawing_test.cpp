// Drawings that are one point alone, from file to picture, and pages around curves.
#include <numbers>

#include "geometry/planar/planar.h"
#include "geometry/planar/single_point.h"
#include "geometry/tessellate/tessellate.h"
#include "support/errors.h"
#include "support/exchange.h"
#include "support/support.h"

using namespace blossom;
using namespace blossom::test;

namespace {

std::optional<Vec2> pointIn(const Imported& read) { return singlePoint(read.shape.get<Curves>()->paths); }

std::string svg(const std::string& content) {
  return "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 20 20\">" + content + "</svg>";
}

/// x, y, width and height of the page of an SVG.
std::array<double, 4> viewBoxOf(const Shape& shape) {
  const TemporaryFolder folder;
  const fs::path path = folder.path() / "page.svg";
  writeShape(formats(), shape, path, Value::object());
  const std::string content = readFile(path), name = "viewBox=\"";
  std::istringstream numbers(content.substr(content.find(name) + name.size()));
  std::array<double, 4> box{};
  for (double& number : box) numbers >> number;
  return box;
}

}  // namespace

class PointDrawingTest : public QObject {
  Q_OBJECT

 private slots:
  void ownFilesAreReadBack() {
    const Vec2 place(3, -4.5);
    for (const std::string extension : {"svg", "dxf"}) {
      const Imported back = roundTrip(Shape(pointDrawing(place)), extension);
      QVERIFY2(pointIn(back).has_value(), extension.c_str());
      QVERIFY2((*pointIn(back) - place).norm() < 1e-12, extension.c_str());
      QVERIFY2(back.warnings.empty(), back.warnings.empty() ? "" : back.warnings.front().c_str());
    }
  }

  void everyWayToDrawAPointInSvg() {
    for (const char* drawn : {"<path d='M3 4L3 4'/>", "<path d='M3 4h0'/>", "<line x1='3' y1='4' x2='3' y2='4'/>",
                              "<polyline points='3,4 3,4'/>"}) {
      const auto point = pointIn(readText(svg(drawn), "svg"));
      QVERIFY2(point && *point == Vec2(3, 16), drawn);
    }
    for (const char* nothing : {"<path d='M3 4'/>", "<path d='M3 4Z'/>", "<polyline points='3,4'/>"})
      QVERIFY2(readText(svg(nothing), "svg").shape.get<Curves>()->paths.empty(), nothing);
  }

  void pointsBesideCurvesAreToldAndLeftOut() {
    const Imported read = readText(svg("<path d='M3 4L3 4M5 5L5 5M1 1H9V9Z'/>"), "svg");
    QCOMPARE(read.shape.get<Curves>()->paths.size(), std::size_t{1});
    QCOMPARE(read.warnings.size(), std::size_t{1});
    QVERIFY(read.warnings.front().find("2 paths without length") != std::string::npos);
  }

  void aPointIsDrawn() {
    const Tessellation drawn = tessellate(Shape(pointDrawing({7, 8})));
    QCOMPARE(drawn.markers.size(), std::size_t{1});
    QVERIFY(drawn.markers.front() == Vec3(7, 8, 0));
  }

  void aPageHoldsTheWidthOfItsLines() {
    const auto [x, y, width, height] = viewBoxOf(Shape(pointDrawing({7, 8})));
    for (const double size : {width, height}) COMPARE_NEAR(size, 0.25, 1e-12);
    COMPARE_NEAR(x, 7 - 0.125, 1e-12);
    COMPARE_NEAR(y, 8 - 0.125, 1e-12);
  }

  void aPageFitsArcsExactly() {
    const double r = 4;
    Region disc;
    disc.loops.push_back({{Arc2{{1, 2}, r, 0.3, 2 * std::numbers::pi}}, true, {}, {}});
    const auto [x, y, width, height] = viewBoxOf(Shape(disc));
    for (const double size : {width, height}) COMPARE_NEAR(size, 2 * r, 1e-12);
    COMPARE_NEAR(x, 1 - r, 1e-12);
    COMPARE_NEAR(y, 2 - r, 1e-12);
  }

  void whatNeedsAnAreaNamesThePoint() {
    const Error refused = errorOf([] { toRegion(pointDrawing({7, 8})); });
    QVERIFY2(refused.message().find("is the point (7, 8)") != std::string::npos, refused.message().c_str());
  }
};

BLOSSOM_TEST(PointDrawingTest)
#include "point_drawing_test.moc"
