// What once took minutes, or for ever: faces of very many corners, documents of very many features, figures beyond all
// numbers. All of it ends, or ends when asked to.
#include <Eigen/Geometry>
#include <numbers>

#include "document/document_json.h"
#include "feature/feature_type.h"
#include "geometry/measure/measure.h"
#include "geometry/mesh/mesh_topology.h"
#include "geometry/mesh/polygon_triangulation.h"
#include "support/exchange.h"

using namespace blossom;
using namespace blossom::test;

namespace {

using Polygon3 = std::vector<Vec3>;

double shoelace(const Polygon3& polygon) {
  double sum = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec3 &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
    sum += a.x() * b.y() - b.x() * a.y();
  }
  return sum / 2;
}

double sumOfAreas(const Polygon3& polygon, const std::vector<std::array<int, 3>>& triangles) {
  double sum = 0;
  for (const auto& [a, b, c] : triangles) {
    const auto at = [&](int i) { return polygon[static_cast<std::size_t>(i)]; };
    sum += (at(b) - at(a)).cross(at(c) - at(a)).norm() / 2;
  }
  return sum;
}

Polygon3 star(int corners) {
  Polygon3 polygon;
  for (int i = 0; i < corners; ++i) {
    const double angle = 2 * std::numbers::pi * i / corners, reach = i % 2 ? 60 : 100;
    polygon.emplace_back(reach * std::cos(angle), reach * std::sin(angle), 0);
  }
  return polygon;
}

/// Long teeth on a thin back.
Polygon3 comb(int teeth) {
  Polygon3 polygon{{0, -1, 0}, {2.0 * teeth, -1, 0}};
  for (int i = 2 * teeth; i > 0; --i) polygon.emplace_back(i, i % 2 ? 100 : 0, 0);
  polygon.emplace_back(0, 0, 0);
  return polygon;
}

/// A corridor wound up.
Polygon3 spiral(int corners) {
  Polygon3 out, in;
  for (int i = 0; i < corners / 2; ++i) {
    const double angle = 0.05 * i, reach = 10 + angle;
    out.emplace_back(reach * std::cos(angle), reach * std::sin(angle), 0);
    in.emplace_back((reach - 2) * std::cos(angle), (reach - 2) * std::sin(angle), 0);
  }
  out.insert(out.end(), in.rbegin(), in.rend());
  return out;
}

std::string objOf(const Polygon3& polygon) {
  std::string text, face = "f";
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    text += fmt::format("v {} {} {}\n", polygon[i].x(), polygon[i].y(), polygon[i].z());
    face += fmt::format(" {}", i + 1);
  }
  return text + face + "\n";
}

Polygon3 crossing(std::size_t corners) {
  auto random = seededRandom();
  std::uniform_real_distribution<double> anywhere(-100, 100);
  Polygon3 polygon;
  for (std::size_t i = 0; i < corners; ++i) polygon.emplace_back(anywhere(random), anywhere(random), 0);
  return polygon;
}

double areaOfShape(const Shape& shape) {
  for (const Measure& each : measure(shape).values)
    if (each.name == "area") return std::get<double>(each.value);
  return std::nan("");
}

Surface sheetOfSize(double size) {
  Surface sheet{1, 1, {0, 0, 1, 1}, {0, 0, 1, 1}, {}};
  for (const double x : {0.0, size})
    for (const double y : {0.0, size}) sheet.poles.emplace_back(x, y, 0, 1);
  return sheet;
}

}  // namespace

class EndlessWorkTest : public QObject {
  Q_OBJECT

 private slots:
  void largePolygonsAreCoveredOnce() {
    for (const Polygon3& polygon : {star(3000), star(200'000), comb(20'000), spiral(4000)}) {
      const auto triangles = triangulate(polygon, Progress::none());
      QCOMPARE(triangles.size(), polygon.size() - 2);
      const double area = std::abs(shoelace(polygon));
      COMPARE_NEAR(sumOfAreas(polygon, triangles), area, 1e-9 * area);
    }
  }

  /// The quick way and the plain one agree where both are used.
  void largeAndSmallAreAlike() {
    const Polygon3 small = star(256), large = star(258);
    COMPARE_NEAR(sumOfAreas(small, triangulate(small)) - sumOfAreas(large, triangulate(large)),
                 shoelace(small) - shoelace(large), 1e-9);
  }

  void aFaceOf60000CrossingCorners() {
    const Polygon3 polygon = crossing(60'000);
    QCOMPARE(triangulate(polygon, Progress::none()).size(), polygon.size() - 2);
    const Imported imported = readText(objOf(polygon), "obj");
    QVERIFY(areaOfShape(imported.shape) > 0);
  }

  /// Facets of a large sum are hundreds of thousands of numbers.
  void figuresAreLookedAtOnce() {
    Evaluated evaluated;
    Value& facets = evaluated.stats["facets"] = Value::array();
    for (int k = 0; k < 300'000; ++k) facets.push_back(Value::array({0.5 * k, 1.0, 2.0}));
    refuseInfiniteFigures(evaluated);
    facets[299'999][1] = HUGE_VAL;
    VERIFY_ERROR(refuseInfiniteFigures(evaluated), ErrorCode::LimitExceeded);
    try {
      refuseInfiniteFigures(evaluated);
    } catch (const Error& error) {
      QCOMPARE(error.message(), std::string("The figure \"facets/299999/1\" is beyond all numbers."));
    }
  }

  void workEndsWhenAsked() {
    const CancelToken token;
    token.cancel();
    const Progress cancelled(token);
    VERIFY_ERROR(triangulate(crossing(5000), cancelled), ErrorCode::Cancelled);
    VERIFY_ERROR(triangulate(star(5000), cancelled), ErrorCode::Cancelled);
    VERIFY_ERROR(measure(sheetOfSize(10), cancelled), ErrorCode::Cancelled);
  }

  void figuresBeyondAllNumbersAreErrors() {
    COMPARE_NEAR(areaOfShape(sheetOfSize(1e60)) / 1e120, 1, 1e-12);
    VERIFY_ERROR(measure(sheetOfSize(1e308)), ErrorCode::LimitExceeded);
    VERIFY_ERROR(
        measure(Region{{Path{
            {Line2{{0, 0}, {1e200, 0}}, Line2{{1e200, 0}, {1e200, 1e200}}, Line2{{1e200, 1e200}, {0, 0}}}, true, "", {}}}}),
        ErrorCode::LimitExceeded);
  }

  void aDocumentOf200000FeaturesIsRefused() {
    std::string json = R"({"blossom": 1, "features": [)";
    for (int i = 0; i < 200'000; ++i)
      json += fmt::format(R"({}{{"id": "box-{}", "type": "modeling.box", "parameters": {{}}}})", i ? "," : "", i);
    VERIFY_ERROR(fromJson(json + "]}", false), ErrorCode::LimitExceeded);
  }
};

BLOSSOM_TEST(EndlessWorkTest)
#include "endless_work_test.moc"
