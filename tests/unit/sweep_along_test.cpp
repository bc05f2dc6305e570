#include <BRepCheck_Analyzer.hxx>
#include <Eigen/Geometry>
#include <numbers>

#include "core/angle.h"
#include "geometry/bspline/bspline.h"
#include "geometry/measure/measure.h"
#include "geometry/planar/planar.h"
#include "support/bishop.h"
#include "support/smooth_curves.h"
#include "support/support.h"
#include "sweep/kernel/begin/curve_chain.h"
#include "sweep/kernel/begin/motion_from_curve.h"
#include "sweep/kernel/begin/smooth_curve.h"
#include "sweep/kernel/grid/motion_point.h"
#include "sweep/kernel/product_surface.h"
#include "sweep/kernel/solid.h"

using namespace blossom;
using namespace blossom::test;
using namespace blossom::sweep;
using std::numbers::pi;

namespace {

Curve polygon(const std::vector<Vec2>& points) {
  Curve curve{1, {0}, {}};
  for (std::size_t i = 0; i <= points.size(); ++i) {
    const Vec2& p = points[i % points.size()];
    curve.poles.emplace_back(p.x(), p.y(), 0, 1);
    curve.knots.push_back(static_cast<double>(i));
  }
  curve.knots.push_back(curve.knots.back());
  return curve;
}

Curve star(int points, double inner, double outer, const Vec2& centre = Vec2::Zero()) {
  std::vector<Vec2> corners;
  for (int i = 0; i < 2 * points; ++i) {
    const double angle = pi * i / points, radius = i % 2 ? inner : outer;
    corners.push_back(centre + radius * Vec2(std::cos(angle), std::sin(angle)));
  }
  return polygon(corners);
}

/// Distance of a point from a closed polygon.
double distanceFromPolygon(const Curve& polygon, const Vec2& p) {
  double least = 1e9;
  for (std::size_t i = 0; i + 1 < polygon.poles.size(); ++i) {
    const Vec2 a = polygon.poles[i].head<2>(), b = polygon.poles[i + 1].head<2>();
    const double t = std::clamp((p - a).dot(b - a) / (b - a).squaredNorm(), 0.0, 1.0);
    least = std::min(least, (p - a - t * (b - a)).norm());
  }
  return least;
}

/// The frame at t of the true tube: its equation integrated, and on a ring turned by the closing angle's share.
struct TrueTube {
  const SmoothCurve& curve;
  const CurveMotionResult& made;
  Vec3 start;

  [[nodiscard]] std::pair<Vec3, Vec3> axes(double t) const {
    const auto tangents = [&](double at) {
      const CurvePoint p = curve.at(at);
      const Vec3 tangent = p.tangent();
      return TangentAt{tangent, (p.second - p.second.dot(tangent) * tangent) / p.first.norm()};
    };
    Vec3 normal = start;
    double from = 0;
    for (std::size_t b = 1; b < curve.breaks().size() && from < t; ++b) {
      const double to = std::min(t, curve.breaks()[b]);
      normal = bishopNormal(tangents, normal, from, to, 600);
      from = to;
    }
    const Vec3 tangent = curve.at(t).tangent();
    if (made.closed)
      normal = Eigen::AngleAxisd(made.closing * (t > 0 ? curve.length(0, t) : 0) / curve.length(0, 1), tangent) * normal;
    return {normal, tangent.cross(normal)};
  }
};

double volumeIn(const SolidResult& result) {
  for (const Measure& value : measure(Brep(result.solid)).values)
    if (value.name == "volume") return std::get<double>(value.value);
  return std::nan("");
}

Curve regionCurve(const std::vector<Segment>& segments) {
  std::vector<Curve> parts;
  for (const Segment& segment : segments) {
    if (const auto* line = std::get_if<Line2>(&segment))
      parts.push_back(
          Curve{1, {0, 0, 1, 1}, {Vec4(line->from.x(), line->from.y(), 0, 1), Vec4(line->to.x(), line->to.y(), 0, 1)}});
    if (const auto* arc = std::get_if<Arc2>(&segment))
      parts.push_back(toCurve(ellipticArc(arc->center, Vec2(arc->radius, 0), 1, arc->start, arc->sweep)));
  }
  return chained(parts, 1e-4);
}

}  // namespace

class SweepAlongTest : public QObject {
  Q_OBJECT
 private slots:
  void roundTubesKeepTheirTolerance() {
    auto random = seededRandom();
    double worst = 0;
    for (int k = 0; k < 16; ++k) {
      const Curve path = k % 2 == 0 ? randomPath(random) : randomRing(random);
      const double tolerance = std::pow(10.0, -uniformInt(random, 1, 5)), radius = uniform(random, 0.5, 4);
      const CurveMotionResult made = motionFromCurve(path, {.radius = radius, .tolerance = tolerance});
      validate(made.motion);
      QVERIFY(made.deviation <= tolerance);
      QCOMPARE(made.closed, k % 2 == 1);
      const Surface surface = productSurface(made.motion).surface;
      const SmoothCurve curve(path);
      const Vec3 start = (evaluate(made.motion, 0, 0).point - curve.at(0).point).normalized();
      const TrueTube tube{curve, made, start};
      for (int i = 0; i < 25; ++i) {
        const double u = uniform(random, 0, 1), v = uniform(random, 0, 1);
        const auto [normal, binormal] = tube.axes(v);
        const Vec3 arm = point(surface, u, v) - curve.at(v).point;
        // The angle that u stands for is the same all along the tube.
        const Vec3 first = evaluate(made.motion, u, 0).point - curve.at(0).point;
        const double angle = std::atan2(first.dot(curve.at(0).tangent().cross(start)), first.dot(start));
        const Vec3 wanted = radius * (std::cos(angle) * normal + std::sin(angle) * binormal);
        worst = std::max(worst, (arm - wanted).norm() / tolerance);
        QVERIFY2((arm - wanted).norm() <= 1.1 * tolerance + 1e-9, qPrintable(QString::number((arm - wanted).norm())));
      }
    }
    std::printf("figure tube_share %.3g\n", worst);
  }

  void ringsCloseAndEncloseTheirVolume() {
    auto random = seededRandom();
    for (int k = 0; k < 3; ++k) {
      const Curve path = randomRing(random);
      const double radius = 2;
      const CurveMotionResult made = motionFromCurve(path, {.radius = radius, .tolerance = 1e-4});
      if (made.smallestBend < 1.5 * radius) continue;
      const SolidResult solid = makeSolid(productSurface(made.motion).surface);
      QCOMPARE(solid.start, EndCap::None);
      QVERIFY(BRepCheck_Analyzer(solid.solid).IsValid());
      // Pappus: the section's area times the way of its middle, whatever the bends.
      const double wanted = pi * radius * radius * SmoothCurve(path).length(0, 1);
      COMPARE_NEAR(volumeIn(solid), wanted, 1e-4 * wanted);
    }
  }

  void outlinesBecomeSections() {
    const Curve line{1, {0, 0, 1, 1}, {Vec4(0, 0, 0, 1), Vec4(0, 0, 50, 1)}};
    auto random = seededRandom();
    for (int k = 0; k < 12; ++k) {
      const Vec2 centre(uniform(random, -30, 30), uniform(random, -30, 30));
      const Curve outline = star(uniformInt(random, 2, 7), uniform(random, 3, 7), 10, centre);
      const double tolerance = std::pow(10.0, -uniformInt(random, 2, 4));
      const CurveMotionResult made =
          motionFromCurve(line, {.profile = PolarProfile(outline), .tolerance = tolerance, .normal = Vec3(1, 0, 0)});
      validate(made.motion);
      QVERIFY(made.deviation <= tolerance);
      double worst = 0;
      for (int i = 0; i < 400; ++i) {
        const Vec3 at = evaluate(made.motion, uniform(random, 0, 1), 0.5).point;
        worst = std::max(worst, distanceFromPolygon(outline, centre + at.head<2>()));
      }
      QVERIFY2(worst <= 1.05 * tolerance, qPrintable(QString("%1 > %2").arg(worst).arg(tolerance)));
      // The corners are met.
      const Surface surface = productSurface(made.motion).surface;
      double farthest = 0;
      for (int i = 0; i <= 4000; ++i) farthest = std::max(farthest, point(surface, i / 4000.0, 0.3).head<2>().norm());
      COMPARE_NEAR(farthest, 10, 0.05);
    }
  }

  void roundedAndSmoothOutlines() {
    const Curve line{1, {0, 0, 1, 1}, {Vec4(0, 0, 0, 1), Vec4(0, 0, 50, 1)}};
    // A slot: two lines, two half circles; 20 by 10.
    const Curve slot = regionCurve({Line2{Vec2(-5, -5), Vec2(5, -5)}, Arc2{Vec2(5, 0), 5, -pi / 2, pi},
                                    Line2{Vec2(5, 5), Vec2(-5, 5)}, Arc2{Vec2(-5, 0), 5, pi / 2, pi}});
    const CurveMotionResult made = motionFromCurve(line, {.profile = PolarProfile(slot), .tolerance = 1e-3});
    QVERIFY(made.deviation <= 1e-3);
    const SolidResult solid = makeSolid(productSurface(made.motion).surface);
    const double wanted = (100 + 25 * pi) * 50;
    COMPARE_NEAR(volumeIn(solid), wanted, 2e-4 * wanted);
    // A circle as a drawing is the round section itself, clockwise as well.
    for (const double sweep : {2 * pi, -2 * pi}) {
      const Curve circle = regionCurve({Arc2{Vec2(70, 3), 5, 0.3, sweep}});
      const PolarProfile profile(circle);
      QVERIFY((profile.centre() - Vec3(70, 3, 0)).norm() < 1e-9);
      COMPARE_NEAR(profile.at(1.234).radius, 5, 1e-12);
      COMPARE_NEAR(profile.reach(), 5, 1e-12);  // not where its poles are
      COMPARE_NEAR(profile.at(4).slopeLeft, 0, 1e-9);
      const CurveMotionResult round = motionFromCurve(line, {.profile = profile, .tolerance = 1e-3});
      QVERIFY(round.deviation < 1e-9);
    }
  }

  void slopesAreDerivatives() {
    auto random = seededRandom();
    const PolarProfile profile(regionCurve({Arc2{Vec2(2, 1), 5, 0, 2 * pi}}), Vec3(0, 0, 0));
    for (int k = 0; k < 100; ++k) {
      const double angle = uniform(random, -10, 10), h = 1e-5;
      const double slope = (profile.at(angle + h).radius - profile.at(angle - h).radius) / (2 * h);
      COMPARE_NEAR(profile.at(angle).slopeLeft, slope, 1e-6);
      // On the circle about (2, 1).
      const double r = profile.at(angle).radius;
      COMPARE_NEAR(std::hypot(r * std::cos(angle) - 2, r * std::sin(angle) - 1), 5, 1e-12);
    }
  }

  void outlinesThatCannotBeSectionsAreRefused() {
    // A C, open outlines, one out of its plane, one that runs around twice, a centre outside.
    const Curve c =
        polygon({Vec2(0, 0), Vec2(30, 0), Vec2(30, 5), Vec2(5, 5), Vec2(5, 25), Vec2(30, 25), Vec2(30, 30), Vec2(0, 30)});
    VERIFY_ERROR(PolarProfile{c}, ErrorCode::InvalidInput);
    try {
      PolarProfile{c};
    } catch (const Error& error) {
      QVERIFY2(error.message().find("star-shaped") != std::string::npos, error.what());
      QVERIFY(!error.hint().empty());
    }
    // A saw blade: its teeth lean so far that rays cross three of their sides, although it runs around once.
    std::vector<Vec2> blade;
    for (int i = 0; i < 12; ++i) {
      const double root = 2 * pi * i / 12, tip = root - 0.2;
      blade.emplace_back(8 * std::cos(root), 8 * std::sin(root));
      blade.emplace_back(12 * std::cos(tip + 2 * pi / 12 + 0.5), 12 * std::sin(tip + 2 * pi / 12 + 0.5));
    }
    VERIFY_ERROR(PolarProfile{polygon(blade)}, ErrorCode::InvalidInput);
    Curve open = star(5, 4, 10);
    open.poles.back() = Vec4(9, 1, 0, 1);
    VERIFY_ERROR(PolarProfile{open}, ErrorCode::InvalidInput);
    Curve bent = star(5, 4, 10);
    bent.poles[3].z() = 1;
    VERIFY_ERROR(PolarProfile{bent}, ErrorCode::InvalidInput);
    VERIFY_ERROR(PolarProfile(star(5, 4, 10), Vec3(40, 0, 0)), ErrorCode::InvalidInput);
    VERIFY_ERROR(PolarProfile(star(5, 4, 10), Vec3(10, 0, 0)), ErrorCode::InvalidInput);
    std::vector<Vec2> twice;
    for (int i = 0; i < 7; ++i) twice.emplace_back(10 * std::cos(4 * pi * i / 7), 10 * std::sin(4 * pi * i / 7));
    VERIFY_ERROR(PolarProfile{polygon(twice)}, ErrorCode::InvalidInput);
  }

  /// A factor that all weights have in common changes nothing, nor do weights that come from another parameter.
  void weightsDoNotDecideWhatIsSmooth() {
    for (const double factor : {1e-3, 1e-6, 1e6}) {
      Curve scaled = star(5, 4, 10);
      for (Vec4& pole : scaled.poles) pole *= factor;
      const PolarProfile profile(scaled);
      COMPARE_NEAR(profile.reach(), 10, 1e-9);
    }
    Curve arch{3, {0, 0, 0, 0, 1, 1, 1, 1}, {Vec4(0, 0, 0, 1), Vec4(0, 20, 0, 1), Vec4(30, 20, 5, 1), Vec4(30, 0, 5, 1)}};
    const double length = SmoothCurve(arch).length(0, 1);
    for (const double base : {0.1, 0.01, 100.0}) {
      Curve other = arch;
      for (int i = 0; i < 4; ++i) other.poles[static_cast<std::size_t>(i)] *= std::pow(base, i);
      COMPARE_NEAR(SmoothCurve(other).length(0, 1), length, 1e-8 * length);
    }
    // A cusp stays one: the pole in the middle of a line doubled back.
    const Curve cusp{2, {0, 0, 0, 1, 1, 1}, {Vec4(0, 0, 0, 1), Vec4(0.1, 0, 0, 0.01), Vec4(0, 0, 0, 0.0001)}};
    VERIFY_ERROR(SmoothCurve{cusp}, ErrorCode::Degenerate);
  }

  void outlinesInAnyPlane() {
    auto random = seededRandom();
    Curve tilted = star(6, 5, 10);
    const auto part = [&] { return uniform(random, -1, 1); };
    const Eigen::Quaterniond turn = Eigen::Quaterniond(1.1, part(), part(), part()).normalized();
    const Vec3 shift(uniform(random, -50, 50), uniform(random, -50, 50), 7);
    for (Vec4& pole : tilted.poles) pole.head<3>() = turn * Vec3(pole.head<3>()) + shift;
    const PolarProfile profile(tilted);
    QVERIFY((profile.centre() - shift).norm() < 1e-9);
    double largest = 0;
    for (const auto& joint : profile.joints()) largest = std::max(largest, joint.value.radius);
    COMPARE_NEAR(largest, 10, 1e-12);
    QCOMPARE(profile.joints().size(), std::size_t(12));
  }

  void pathsOfArcsAndLines() {
    // Out, around a half circle, back: bends that jump from 0 to 1/15.
    const Curve path = regionCurve(
        {Line2{Vec2(0, 0), Vec2(40, 0)}, Arc2{Vec2(40, 15), 15, -pi / 2, pi}, Line2{Vec2(40, 30), Vec2(-10, 30)}});
    const CurveMotionResult made = motionFromCurve(path, {.radius = 4, .tolerance = 1e-5});
    QVERIFY(made.deviation <= 1e-5);
    COMPARE_NEAR(made.smallestBend, 15, 1e-6);
    const SolidResult solid = makeSolid(productSurface(made.motion).surface);
    const double wanted = pi * 16 * (40 + 15 * pi + 50);
    COMPARE_NEAR(volumeIn(solid), wanted, 1e-5 * wanted);
  }

  void sizesAndTolerancesThatCannotBeAreRefused() {
    const Curve line{1, {0, 0, 1, 1}, {Vec4(0, 0, 0, 1), Vec4(0, 0, 50, 1)}};
    VERIFY_ERROR(motionFromCurve(line, {.radius = 0}), ErrorCode::InvalidParameter);
    VERIFY_ERROR(motionFromCurve(line, {.tolerance = 0}), ErrorCode::InvalidParameter);
    VERIFY_ERROR(motionFromCurve(line, {.rows = 3}), ErrorCode::InvalidParameter);
    auto random = seededRandom();
    VERIFY_ERROR(motionFromCurve(randomRing(random), {.tolerance = 1e-12, .maximumSpans = 40}), ErrorCode::LimitExceeded);
    COMPARE_NEAR(motionFromCurve(line, {}).smallestBend, 0, 0);
  }
};

BLOSSOM_TEST(SweepAlongTest)
#include "sweep_along_test.moc"
