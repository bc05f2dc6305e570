#include "app/app.h"
#include "geometry/measure/measure.h"
#include "geometry/planar/planar.h"
#include "support/support.h"

using namespace blossom;
using std::numbers::pi;

namespace {

double perimeter(const Region& region) {
  double sum = 0;
  for (const Path& loop : region.loops) sum += length(loop);
  return sum;
}

/// Perimeter of an ellipse by the series of Gauss and Kummer, which needs no integral.
double ellipsePerimeter(double a, double b) {
  const double h = (a - b) * (a - b) / ((a + b) * (a + b));
  double term = 1, sum = 1;
  for (int n = 1; n < 200; ++n) {
    const double factor = (n - 1.5) / n;  // of the binomial coefficients (1/2 over n)
    term *= factor * factor * h;
    sum += term;
  }
  return pi * (a + b) * sum;
}

std::size_t arcs(const Region& region) {
  std::size_t count = 0;
  for (const Path& loop : region.loops)
    for (const Segment& segment : loop.segments) count += std::holds_alternative<Arc2>(segment) ? 1 : 0;
  return count;
}

}  // namespace

/// The feature types and literal forms of outlines, through the registry as every user meets them.
class ModelingOutlineTest : public QObject {
  Q_OBJECT
 private slots:
  void circlesAreOneArc();
  void ellipsesByTheirSeries();
  void polygonsInAndAroundACircle();
  void starsAreFansOfTriangles();
  void rectanglesWithAndWithoutRoundCorners();
  void slotsHaveRoundEnds();
  void everythingTurnsAboutItsCentre();
  void sizesThatDoNotFitAreRefused();
  void pointsOffThePlaneAreRefused();
  void drawnOutlinesAreRegionsOrCurves();
  void aDrawnOutlineThatMeetsItselfIsRefusedWithThePlace();
  void literalsAreTheSameShapes();
  void wrongLiteralsSayWhatIsWanted();

 private:
  [[nodiscard]] Evaluated evaluated(const char* type, const Value& given) const {
    const auto feature = app_.registry->at(std::string("modeling.") + type);
    return feature->evaluate(completed(feature->parameters, given), Inputs(), Progress::none());
  }
  [[nodiscard]] Region region(const char* type, const Value& given) const {
    const Evaluated result = evaluated(type, given);
    const Region* value = result.shape.get<Region>();
    if (!value) throw Error(ErrorCode::Internal, "not a region");
    return *value;
  }
  const App app_ = loadApp();
};

void ModelingOutlineTest::circlesAreOneArc() {
  const Region circle = region("circle", {{"radius", 7.5}, {"centre", {3, -2, 0}}});
  QCOMPARE(arcs(circle), std::size_t{1});
  COMPARE_NEAR(area(circle), pi * 56.25, 1e-12);
  COMPARE_NEAR(perimeter(circle), 15 * pi, 1e-12);
  QCOMPARE(arcs(region("ellipse", {{"a", 4}, {"b", 4}})), std::size_t{1});
}

void ModelingOutlineTest::ellipsesByTheirSeries() {
  for (const auto& [a, b] : std::vector<std::pair<double, double>>{{20, 10}, {5, 4.999}, {30, 3}, {2, 9}}) {
    const Region shape = region("ellipse", {{"a", a}, {"b", b}, {"rotation", 33}});
    COMPARE_NEAR(area(shape), pi * a * b, 1e-9);
    COMPARE_NEAR(perimeter(shape), ellipsePerimeter(a, b), 1e-8);
    QVERIFY(std::holds_alternative<Spline2>(shape.loops[0].segments[0]));
  }
}

void ModelingOutlineTest::polygonsInAndAroundACircle() {
  for (const int n : {3, 4, 5, 6, 17, 1000}) {
    const double r = 12;
    const Region in = region("polygon", {{"sides", n}, {"radius", r}});
    COMPARE_NEAR(area(in), n * r * r * std::sin(2 * pi / n) / 2, 1e-9);
    COMPARE_NEAR(perimeter(in), 2 * n * r * std::sin(pi / n), 1e-9);
    const Region about = region("polygon", {{"sides", n}, {"radius", r}, {"size", "circumscribed"}});
    COMPARE_NEAR(area(about), n * r * r * std::tan(pi / n), 1e-9);
  }
}

void ModelingOutlineTest::starsAreFansOfTriangles() {
  for (const int n : {2, 5, 9}) {
    const double outer = 20, inner = 8;
    const Region star = region("star", {{"points", n}, {"outer", outer}, {"inner", inner}});
    COMPARE_NEAR(area(star), n * outer * inner * std::sin(pi / n), 1e-9);
    const double side = std::sqrt(outer * outer + inner * inner - 2 * outer * inner * std::cos(pi / n));
    COMPARE_NEAR(perimeter(star), 2 * n * side, 1e-9);
  }
}

void ModelingOutlineTest::rectanglesWithAndWithoutRoundCorners() {
  COMPARE_NEAR(area(region("rectangle", {{"width", 30}, {"height", 20}})), 600, 1e-12);
  const double r = 4;
  const Region round = region("rectangle", {{"width", 30}, {"height", 20}, {"corner", r}});
  COMPARE_NEAR(area(round), 600 - (4 - pi) * r * r, 1e-11);
  COMPARE_NEAR(perimeter(round), 100 - (8 - 2 * pi) * r, 1e-11);
  QCOMPARE(arcs(round), std::size_t{4});
  // Round ends: the short sides have gone altogether.
  const Region slot = region("rectangle", {{"width", 30}, {"height", 20}, {"corner", 10}});
  QCOMPARE(slot.loops[0].segments.size(), std::size_t{6});
  COMPARE_NEAR(area(slot), 200 + 100 * pi, 1e-11);
}

void ModelingOutlineTest::slotsHaveRoundEnds() {
  const Region slot = region("slot", {{"length", 40}, {"width", 10}, {"rotation", 71}});
  COMPARE_NEAR(area(slot), 300 + 25 * pi, 1e-11);
  COMPARE_NEAR(perimeter(slot), 60 + 10 * pi, 1e-11);
  QCOMPARE(arcs(slot), std::size_t{2});
  COMPARE_NEAR(area(region("slot", {{"length", 10}, {"width", 10}})), 25 * pi, 1e-12);
}

void ModelingOutlineTest::everythingTurnsAboutItsCentre() {
  auto random = test::seededRandom();
  std::uniform_real_distribution<double> place(-100, 100), turn(-360, 360);
  for (const char* type : {"ellipse", "polygon", "star", "rectangle", "slot"}) {
    const Value straight{{"rotation", 0}};
    const Region before = region(type, straight);
    const double angle = turn(random);
    const Vec2 centre(place(random), place(random));
    const Region after = region(type, {{"rotation", angle}, {"centre", {centre.x(), centre.y(), 0}}});
    COMPARE_NEAR(area(after), area(before), 1e-8);
    COMPARE_NEAR(perimeter(after), perimeter(before), 1e-8);
    const Vec2 start = startPoint(before.loops[0]);
    const double c = std::cos(angle * pi / 180), s = std::sin(angle * pi / 180);
    const Vec2 expected = centre + Vec2(c * start.x() - s * start.y(), s * start.x() + c * start.y());
    COMPARE_NEAR((startPoint(after.loops[0]) - expected).norm(), 0, 1e-10);
  }
}

void ModelingOutlineTest::sizesThatDoNotFitAreRefused() {
  VERIFY_ERROR(evaluated("rectangle", {{"width", 30}, {"height", 20}, {"corner", 10.5}}), ErrorCode::InvalidParameter);
  VERIFY_ERROR(evaluated("slot", {{"length", 10}, {"width", 11}}), ErrorCode::InvalidParameter);
  VERIFY_ERROR(evaluated("circle", {{"radius", 0}}), ErrorCode::InvalidParameter);
  VERIFY_ERROR(evaluated("polygon", {{"sides", 2}}), ErrorCode::InvalidParameter);
}

void ModelingOutlineTest::pointsOffThePlaneAreRefused() {
  VERIFY_ERROR(evaluated("circle", {{"centre", {0, 0, 1}}}), ErrorCode::InvalidParameter);
  VERIFY_ERROR(evaluated("outline", {{"segments", {{{"to", {10, 0, 2}}}}}}), ErrorCode::InvalidParameter);
}

void ModelingOutlineTest::drawnOutlinesAreRegionsOrCurves() {
  const Value segments{
      {{"to", {40, 0, 0}}}, {{"kind", "arc"}, {"through", {{50, 10, 0}}}, {"to", {40, 20, 0}}}, {{"to", {0, 20, 0}}}};
  const Region closed = region("outline", {{"segments", segments}});
  COMPARE_NEAR(area(closed), 800 + 50 * pi, 1e-10);
  const Evaluated open = evaluated("outline", {{"segments", segments}, {"closed", false}});
  const auto* curves = open.shape.get<Curves>();
  QVERIFY(curves && curves->paths.size() == 1);
  COMPARE_NEAR(length(curves->paths[0]), 80 + 10 * pi, 1e-10);
  VERIFY_ERROR(evaluated("outline", {{"segments", Value::array()}}), ErrorCode::InvalidInput);
}

void ModelingOutlineTest::aDrawnOutlineThatMeetsItselfIsRefusedWithThePlace() {
  const Value bow{{{"to", {40, 0, 0}}}, {{"to", {0, 20, 0}}}, {{"to", {40, 20, 0}}}};
  try {
    (void)evaluated("outline", {{"segments", bow}});
    QFAIL("it was taken");
  } catch (const Error& e) {
    QVERIFY2(e.message().find("(20, 10)") != std::string::npos, e.message().c_str());
  }
  const Evaluated open = evaluated(
      "outline", {{"segments", {{{"to", {40, 0, 0}}}, {{"to", {40, 20, 0}}}, {{"to", {20, -20, 0}}}}}, {"closed", false}});
  QCOMPARE(open.warnings.size(), std::size_t{1});
}

void ModelingOutlineTest::literalsAreTheSameShapes() {
  const auto areaOf = [&](const char* text) {
    const Shape shape = app_.registry->literal(text);
    return shape.get<Region>() ? area(*shape.get<Region>()) : -1;
  };
  COMPARE_NEAR(areaOf("circle:5"), 25 * pi, 1e-12);
  COMPARE_NEAR(areaOf("circle:5cm"), 2500 * pi, 1e-9);
  COMPARE_NEAR(areaOf("ellipse:5:2"), 10 * pi, 1e-10);
  COMPARE_NEAR(areaOf("rectangle:30:20"), 600, 1e-12);
  COMPARE_NEAR(areaOf("polygon:4:10"), 200, 1e-10);
  COMPARE_NEAR(areaOf("star:5:20:8"), area(region("star", {{"outer", 20}, {"inner", 8}})), 1e-10);
  QVERIFY(areaOf("text:Blossom") > 100);
}

void ModelingOutlineTest::wrongLiteralsSayWhatIsWanted() {
  for (const char* text : {"circle:", "circle:x", "circle:-1", "circle:1:2", "rectangle:3", "polygon:3.5:1", "polygon:2:1",
                           "polygon:99999999999:1", "star:5:1", "ellipse:0:1", "text:", "text: "})
    VERIFY_ERROR(app_.registry->literal(text), ErrorCode::InvalidParameter);
}

BLOSSOM_TEST(ModelingOutlineTest)
#include "modeling_outline_test.moc"

#include <numbers>  // not first: moc stumbles over it
