
#include "support/modeling.h"

using namespace blossom;
using namespace blossom::test;
using std::numbers::pi;

namespace {

struct Expected {
  double volume, area, genus;
};

Value standing(std::mt19937_64& random) {
  std::uniform_real_distribution<double> any(-50, 50);
  const auto three = [&] { return Value::array({any(random), any(random), any(random)}); };
  return {{"position", three()}, {"axis", three()}, {"turn", any(random)}};
}

/// Volumes do not depend on where a solid stands.
void compare(const char* command, const Value& measures, const Expected& expected, std::mt19937_64& random) {
  Value parameters = standing(random);
  parameters.update(measures);
  const Evaluated solid = made(command, parameters);
  QVERIFY(isSound(solid));
  COMPARE_NEAR(volume(solid), expected.volume, 1e-9 * expected.volume);
  COMPARE_NEAR(surfaceArea(solid), expected.area, 1e-9 * expected.area);
  COMPARE_NEAR(figure(solid.shape, "genus"), expected.genus, 0);
}

}  // namespace

class ModelingPrimitiveTest : public QObject {
  Q_OBJECT

 private slots:
  void closedForms() {
    auto random = seededRandom();
    std::uniform_real_distribution<double> length(1, 30), part(0.1, 0.9);
    for (int i = 0; i < 10; ++i) {
      const double a = length(random), b = length(random), c = length(random), q = part(random), r = a * part(random);
      compare("box", {{"width", a}, {"depth", b}, {"height", c}}, {a * b * c, 2 * (a * b + b * c + c * a), 0}, random);
      compare("cylinder", {{"radius", a}, {"height", b}}, {pi * a * a * b, 2 * pi * a * (a + b), 0}, random);
      compare("cylinder", {{"radius", a}, {"height", b}, {"angle", 360 * q}},
              {q * pi * a * a * b, q * 2 * pi * a * (a + b) + 2 * a * b, 0}, random);
      compare("cone", {{"bottom-radius", a}, {"height", b}}, {pi * a * a * b / 3, pi * a * (a + std::hypot(a, b)), 0},
              random);
      compare("cone", {{"bottom-radius", r}, {"top-radius", a}, {"height", b}},
              {pi * b * (a * a + a * r + r * r) / 3, pi * (a * a + r * r + (a + r) * std::hypot(a - r, b)), 0}, random);
      compare("sphere", {{"radius", a}}, {4 * pi * a * a * a / 3, 4 * pi * a * a, 0}, random);
      compare("sphere", {{"radius", a}, {"angle", 360 * q}},
              {q * 4 * pi * a * a * a / 3, q * 4 * pi * a * a + pi * a * a, 0}, random);
      compare("torus", {{"radius", a}, {"tube", r}}, {2 * pi * pi * a * r * r, 4 * pi * pi * a * r, 1}, random);
      compare("torus", {{"radius", a}, {"tube", r}, {"angle", 360 * q}},
              {q * 2 * pi * pi * a * r * r, q * 4 * pi * pi * a * r + 2 * pi * r * r, 0}, random);
    }
  }

  void aConeOfEqualRadiiIsACylinder() {
    const Evaluated cone = made("cone", {{"bottom-radius", 4}, {"top-radius", 4}, {"height", 5}});
    COMPARE_NEAR(volume(cone), 80 * pi, 1e-9);
  }

  void theAnchorSaysWhatStandsAtThePosition() {
    const auto box = [](const char* anchor) {
      return bounds(made("box", {{"width", 2}, {"depth", 4}, {"height", 6}, {"anchor", anchor}}).shape);
    };
    QVERIFY(box("corner").low.norm() < 1e-9);
    QVERIFY((box("base").center() - Vec3(0, 0, 3)).norm() < 1e-9);
    QVERIFY(box("centre").center().norm() < 1e-9);
  }

  void theAxisPointsUpForIt() {
    const Bounds b =
        bounds(made("cylinder", {{"radius", 1}, {"height", 7}, {"axis", {1, 0, 0}}, {"position", {2, 0, 0}}}).shape);
    COMPARE_NEAR(b.low.x(), 2, 1e-6);
    COMPARE_NEAR(b.high.x(), 9, 1e-6);
    COMPARE_NEAR(b.high.z(), 1, 1e-2);
  }

  void measuresThatMakeNoSolidAreRefused() {
    VERIFY_REFUSED(refusal("box", {{"width", 0}}), ErrorCode::InvalidParameter, "width");
    VERIFY_REFUSED(refusal("box", {{"axis", {0, 0, 0}}}), ErrorCode::InvalidParameter, "axis has no direction");
    VERIFY_REFUSED(refusal("box", {{"height", 1e-9}}), ErrorCode::InvalidParameter, "height");
    VERIFY_REFUSED(refusal("cylinder", {{"angle", 361}}), ErrorCode::InvalidParameter, "angle");
    VERIFY_REFUSED(refusal("cone", {{"bottom-radius", 0}, {"top-radius", 0}}), ErrorCode::InvalidParameter, "radius");
    VERIFY_REFUSED(refusal("torus", {{"radius", 5}, {"tube", 5}}), ErrorCode::InvalidParameter, "cut through itself");
  }
};

BLOSSOM_TEST(ModelingPrimitiveTest)
#include "modeling_primitive_test.moc"
