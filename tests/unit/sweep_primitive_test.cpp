#include <BRepCheck_Analyzer.hxx>
#include <numbers>

#include "core/angle.h"
#include "geometry/bspline/bspline.h"
#include "geometry/measure/measure.h"
#include "support/splines.h"
#include "support/support.h"
#include "sweep/kernel/begin/primitive_motions.h"
#include "sweep/kernel/grid/motion_point.h"
#include "sweep/kernel/product_surface.h"
#include "sweep/kernel/solid.h"
#include "sweep/kernel/validity.h"

using namespace blossom;
using namespace blossom::test;
using namespace blossom::sweep;
using std::numbers::pi;

namespace {

constexpr PrimitiveKind allKinds[] = {PrimitiveKind::Cylinder, PrimitiveKind::Cone, PrimitiveKind::Sphere,
                                      PrimitiveKind::Torus,    PrimitiveKind::Tube, PrimitiveKind::Helicoid,
                                      PrimitiveKind::Plane,    PrimitiveKind::Sheet};

PrimitiveOptions randomPrimitive(Random& random, PrimitiveKind kind) {
  PrimitiveOptions o;
  o.kind = kind;
  o.radius = uniform(random, 5, 50);
  o.profile = o.radius * uniform(random, 0.1, 0.9);
  o.topRadius = uniform(random, 1, 50);
  o.width = uniform(random, 5, 50);
  o.height = uniform(random, 5, 50);
  o.angle = uniform(random, 20, 340);
  o.turns = uniform(random, 0.3, 4) * (uniformInt(random, 0, 1) ? 1 : -1);
  o.rows = static_cast<std::size_t>(uniformInt(random, 4, 20));
  o.columns = static_cast<std::size_t>(uniformInt(random, 1, 12));
  return o;
}

/// Distance of a point from the shape, by its closed form.
double distanceFrom(const PrimitiveOptions& o, const Vec3& p) {
  const double around = std::hypot(p.x(), p.y());
  switch (o.kind) {
    case PrimitiveKind::Cylinder:
    case PrimitiveKind::Sheet:
      return std::max({std::abs(around - o.radius), -p.z(), p.z() - o.height});
    case PrimitiveKind::Cone:
      return std::max(
          {std::abs(around - (o.radius + (o.topRadius - o.radius) * p.z() / o.height)), -p.z(), p.z() - o.height});
    case PrimitiveKind::Sphere:
      return std::abs(p.norm() - o.radius);
    case PrimitiveKind::Torus:
    case PrimitiveKind::Tube:
      return std::abs(std::hypot(around - o.radius, p.z()) - o.profile);
    case PrimitiveKind::Helicoid: {
      const double angle = 2 * pi * o.turns * p.z() / o.height;
      return std::abs(p.x() * std::sin(angle) - p.y() * std::cos(angle));
    }
    case PrimitiveKind::Plane:
      return std::max({std::abs(p.z()), std::abs(p.x()) - o.width / 2, std::abs(p.y()) - o.height / 2});
  }
  return 1e9;
}

double sizeOf(const PrimitiveOptions& o) { return o.radius + o.profile + o.topRadius + o.width + o.height; }

double volumeOfSolid(const Motion& motion) {
  const SolidResult result = makeSolid(productSurface(motion).surface);
  if (!BRepCheck_Analyzer(result.solid).IsValid()) return std::nan("");
  for (const Measure& value : measure(Brep(result.solid)).values)
    if (value.name == "volume") return std::get<double>(value.value);
  return std::nan("");
}

}  // namespace

class SweepPrimitiveTest : public QObject {
  Q_OBJECT
 private slots:
  void pointsLieOnTheirShapes() {
    auto random = seededRandom();
    double worst = 0;
    for (int k = 0; k < 10; ++k)
      for (const PrimitiveKind kind : allKinds) {
        const PrimitiveOptions o = randomPrimitive(random, kind);
        const PrimitiveResult made = primitiveMotion(o);
        validate(made.motion);
        const Surface surface = productSurface(made.motion).surface;
        double off = 0;
        for (int i = 0; i < 300; ++i) {
          const double u = randomParameter(random, {0, 1}), v = randomParameter(random, {0, 1});
          const Vec3 at = evaluate(made.motion, u, v).point;
          off = std::max({off, distanceFrom(o, at), distanceFrom(o, point(surface, u, v))});
        }
        if (kind == PrimitiveKind::Helicoid) {
          // Stated along z; across the surface it is less.
          const double across = made.deviation * 2 * pi * std::abs(o.turns) * o.radius / o.height;
          QVERIFY2(off <= across * 1.01 + 1e-12 * sizeOf(o), qPrintable(QString("%1 > %2").arg(off).arg(across)));
          QVERIFY(across <= 1e-6 * o.radius);
        } else {
          QCOMPARE(made.deviation, 0.0);
          worst = std::max(worst, off / sizeOf(o));
        }
      }
    std::printf("figure primitive_share %.3g\n", worst);
    QVERIFY2(worst < 1e-13, qPrintable(QString::number(worst)));
  }

  void cornersAreWhereTheyShouldBe() {
    const auto at = [](const PrimitiveOptions& o, double u, double v) {
      return evaluate(primitiveMotion(o).motion, u, v).point;
    };
    const auto near = [](const Vec3& a, const Vec3& b) { return (a - b).norm() < 1e-12; };
    PrimitiveOptions o{.radius = 20, .profile = 5, .topRadius = 0, .width = 60, .height = 40, .angle = 90, .turns = 1.5};
    o.kind = PrimitiveKind::Cylinder;
    QVERIFY(near(at(o, 0, 0), {20, 0, 0}) && near(at(o, 0.5, 1), {-20, 0, 40}));
    o.kind = PrimitiveKind::Cone;
    QVERIFY(near(at(o, 0.25, 0), {0, 20, 0}) && near(at(o, 0.3, 1), {0, 0, 40}));
    o.kind = PrimitiveKind::Sphere;
    QVERIFY(near(at(o, 0.7, 0), {0, 0, -20}) && near(at(o, 0.7, 1), {0, 0, 20}) && near(at(o, 0, 0.5), {20, 0, 0}));
    o.kind = PrimitiveKind::Torus;
    QVERIFY(near(at(o, 0, 0), {25, 0, 0}) && near(at(o, 0, 0.5), {-25, 0, 0}) && near(at(o, 0.25, 1), {20, 0, 5}));
    o.kind = PrimitiveKind::Tube;
    QVERIFY(near(at(o, 0, 0), {25, 0, 0}) && near(at(o, 0, 1), {0, 25, 0}));
    o.kind = PrimitiveKind::Helicoid;
    QVERIFY(near(at(o, 1, 0), {20, 0, 0}) && near(at(o, 1, 1), {-20, 0, 40}) && near(at(o, 0, 0.5), {0, 0, 20}));
    o.kind = PrimitiveKind::Plane;
    QVERIFY(near(at(o, 0, 0), {-30, -20, 0}) && near(at(o, 1, 1), {30, 20, 0}));
    o.kind = PrimitiveKind::Sheet;
    const double c = 20 * std::sqrt(0.5);
    QVERIFY(near(at(o, 0, 0), {c, -c, 0}) && near(at(o, 1, 1), {c, c, 40}));
  }

  void closedOnesEncloseTheirVolumes() {
    PrimitiveOptions o{.radius = 20, .profile = 5, .topRadius = 8, .height = 40, .angle = 90};
    const auto volume = [&](PrimitiveKind kind) {
      o.kind = kind;
      return volumeOfSolid(primitiveMotion(o).motion);
    };
    const auto compare = [](double measured, double wanted) { COMPARE_NEAR(measured, wanted, 1e-6 * wanted); };
    compare(volume(PrimitiveKind::Cylinder), pi * 400 * 40);
    compare(volume(PrimitiveKind::Cone), pi * 40 * (400 + 160 + 64) / 3);
    compare(volume(PrimitiveKind::Torus), 2 * pi * pi * 20 * 25);
    compare(volume(PrimitiveKind::Tube), pi * pi * 20 * 25 / 2);
    compare(volume(PrimitiveKind::Sphere), 4 * pi * 8000 / 3);
    o.topRadius = 0;
    compare(volume(PrimitiveKind::Cone), pi * 400 * 40 / 3);
  }

  void rowsAndColumnsAreSpans() {
    for (const PrimitiveKind kind : allKinds) {
      const Motion motion = primitiveMotion({.kind = kind, .rows = 17, .columns = 9}).motion;
      const auto spans = [](const Surface& s) {
        const BezierSurface pieces = toBezier(s);
        return std::pair(pieces.breaksU.size() - 1, pieces.breaksV.size() - 1);
      };
      QCOMPARE(spans(motion.scaling), std::pair(std::size_t(17), std::size_t(9)));
      QCOMPARE(spans(motion.orientation).first, std::size_t(17));
      QVERIFY(spans(motion.orientation).second % 9 == 0);
      QVERIFY(motion.point == Vec3::Ones());
      // Nothing folds but where poles, axes and points of shapes must.
      if (kind != PrimitiveKind::Sphere) QVERIFY(examine(motion).smallestShare > 1e-3);
    }
  }

  void sizesThatCannotBeAreRefused() {
    VERIFY_ERROR(primitiveMotion({.radius = 0}), ErrorCode::InvalidParameter);
    VERIFY_ERROR(primitiveMotion({.height = -1}), ErrorCode::InvalidParameter);
    VERIFY_ERROR(primitiveMotion({.rows = 3}), ErrorCode::InvalidParameter);
    VERIFY_ERROR(primitiveMotion({.columns = 0}), ErrorCode::InvalidParameter);
    VERIFY_ERROR(primitiveMotion({.kind = PrimitiveKind::Torus, .radius = 5, .profile = 5}), ErrorCode::InvalidParameter);
    VERIFY_ERROR(primitiveMotion({.kind = PrimitiveKind::Tube, .angle = 360}), ErrorCode::InvalidParameter);
    VERIFY_ERROR(primitiveMotion({.kind = PrimitiveKind::Helicoid, .turns = 0}), ErrorCode::InvalidParameter);
  }
};

BLOSSOM_TEST(SweepPrimitiveTest)
#include "sweep_primitive_test.moc"
