#include <Eigen/Geometry>
#include <numbers>

#include "geometry/bspline/bspline.h"
#include "geometry/numeric/gauss.h"
#include "support/bishop.h"
#include "support/smooth_curves.h"
#include "support/support.h"
#include "sweep/kernel/begin/frame_spline.h"
#include "sweep/kernel/begin/rotation_minimizing.h"
#include "sweep/kernel/quaternion.h"

using namespace blossom;
using namespace blossom::test;
using namespace blossom::sweep;
using std::numbers::pi;

namespace {

/// A curve by its first three derivatives.
struct Analytic {
  std::function<std::array<Vec3, 4>(double)> at;
  double from = 0, to = 1;
};

Analytic helix(double radius, double rise, double turns) {
  return {[=](double t) {
            const double c = radius * std::cos(t), s = radius * std::sin(t);
            return std::array<Vec3, 4>{Vec3(c, s, rise * t), Vec3(-s, c, rise), Vec3(-c, -s, 0), Vec3(s, -c, 0)};
          },
          0, 2 * pi * turns};
}

/// (R + cos q t) (cos p t, sin p t), sin q t.
Analytic torusKnot(int p, int q, double radius) {
  return {[=](double t) {
            std::array<Vec3, 4> result;
            for (int order = 0; order < 4; ++order) {
              // Sums of cosines: each derivative multiplies by the frequency and turns by a quarter.
              const auto wave = [&](double frequency, double quarters) {
                return std::pow(frequency, order) * std::cos(frequency * t + (order - quarters) * pi / 2);
              };
              const double x = radius * wave(p, 0) + (wave(p + q, 0) + wave(p - q, 0)) / 2;
              const double y = radius * wave(p, 1) + (wave(p + q, 1) + wave(p - q, 1)) / 2;
              result[static_cast<std::size_t>(order)] = Vec3(x, y, wave(q, 1));
            }
            return result;
          },
          0, 2 * pi};
}

CurvePoint pointOf(const Analytic& curve, double t) {
  const auto d = curve.at(t);
  return {d[0], d[1], d[2]};
}

/// Angle that a rotation-minimising frame turns against Frenet's: minus the integral of the torsion along the arc length.
double turnAgainstFrenet(const Analytic& curve) {
  return -integrate(
      [&](double t) {
        const auto d = curve.at(t);
        const Vec3 c = d[1].cross(d[2]);
        return c.dot(d[3]) / c.squaredNorm() * d[1].norm();
      },
      curve.from, curve.to, 1e-13);
}

std::pair<Vec3, Vec3> frenet(const Analytic& curve, double t) {
  const auto d = curve.at(t);
  const Vec3 binormal = d[1].cross(d[2]).normalized();
  return {binormal.cross(d[1].normalized()), binormal};
}

/// Error of the last frame after n even steps, in radians.
double errorAfter(const Analytic& curve, int n) {
  const CurvePoint start = pointOf(curve, curve.from);
  CurveFrame frame{curve.from, start.point, start.tangent(), frenet(curve, curve.from).first};
  for (int k = 1; k <= n; ++k) frame = doubleReflection(frame, pointOf(curve, curve.from + (curve.to - curve.from) * k / n));
  const auto [normal, binormal] = frenet(curve, curve.to);
  const double angle = std::atan2(frame.normal.dot(binormal), frame.normal.dot(normal));
  return std::abs(std::remainder(angle - turnAgainstFrenet(curve), 2 * pi));
}

TangentAt tangentAt(const SmoothCurve& curve, double t) {
  const CurvePoint at = curve.at(t);
  const Vec3 tangent = at.tangent();
  return {tangent, (at.second - at.second.dot(tangent) * tangent) / at.first.norm()};
}

std::vector<double> evenly(int n) {
  std::vector<double> at;
  for (int i = 0; i <= n; ++i) at.push_back(static_cast<double>(i) / n);
  return at;
}

}  // namespace

class SweepFramesTest : public QObject {
  Q_OBJECT
 private slots:
  void stepsConvergeWithOrderFour() {
    auto random = seededRandom();
    double worst = 10;
    for (int k = 0; k < 12; ++k) {
      const Analytic curve = k % 3 == 0   ? torusKnot(2, 3, uniform(random, 2, 4))
                             : k % 3 == 1 ? torusKnot(3, -5, uniform(random, 2, 4))
                                          : helix(uniform(random, 1, 4), uniform(random, 0.5, 3), uniform(random, 1, 3));
      const int n = k % 3 == 2 ? 128 : 512;
      const double coarse = errorAfter(curve, n), fine = errorAfter(curve, 2 * n);
      if (fine < 1e-11) continue;  // only rounding is left
      worst = std::min(worst, std::log2(coarse / fine));
    }
    std::printf("figure frame_order %.4g\n", worst);
    QVERIFY2(worst > 3.9 && worst < 4.3, qPrintable(QString::number(worst)));
  }

  void accurateFramesSolveTheirEquation() {
    auto random = seededRandom();
    double worst = 0;
    for (int k = 0; k < 20; ++k) {
      const SmoothCurve curve(randomPath(random));
      const FrameResult result = rotationMinimizingFrames(curve, evenly(20), {.accuracy = 1e-9});
      QVERIFY(result.uncertainty <= 2e-9);
      Vec3 normal = result.frames.front().normal;
      double from = 0;
      for (std::size_t b = 1; b < curve.breaks().size(); ++b) {
        const double to = curve.breaks()[b];
        normal = bishopNormal([&](double t) { return tangentAt(curve, t); }, normal, from, to, 4000);
        from = to;
      }
      worst = std::max(worst, (normal - result.frames.back().normal).norm());
      for (const CurveFrame& frame : result.frames) {
        QVERIFY(std::abs(frame.normal.norm() - 1) < 1e-14 && std::abs(frame.normal.dot(frame.tangent)) < 1e-14);
        QVERIFY((frame.point - point(curve.curve(), frame.at)).norm() < 1e-12);
      }
    }
    std::printf("figure frame_error %.3g\n", worst);
    QVERIFY2(worst < 2e-8, qPrintable(QString::number(worst)));
  }

  void closedCurvesClose() {
    auto random = seededRandom();
    for (int k = 0; k < 10; ++k) {
      const SmoothCurve curve(randomRing(random));
      QVERIFY(curve.closed());
      const std::vector<double> at = evenly(40), open = {at.begin(), at.end() - 1};
      const FrameResult closed = rotationMinimizingFrames(curve, at, {.accuracy = 1e-10});
      const FrameResult plain = rotationMinimizingFrames(curve, open, {.accuracy = 1e-10});
      QVERIFY((closed.frames.front().normal - closed.frames.back().normal).norm() < 1e-14);
      COMPARE_NEAR(closed.length, curve.length(0, 1), 1e-10 * closed.length);
      // The closing angle grows with the arc length.
      for (std::size_t i = 0; i < open.size(); ++i) {
        const CurveFrame &a = plain.frames[i], &b = closed.frames[i];
        const double angle = std::atan2(a.tangent.dot(a.normal.cross(b.normal)), a.normal.dot(b.normal));
        const double wanted = closed.closing * (i == 0 ? 0 : curve.length(0, at[i])) / closed.length;
        COMPARE_NEAR(std::remainder(angle - wanted, 2 * pi), 0, 1e-8);
      }
    }
  }

  void straightAndFlatCurvesDoNotSpin() {
    const SmoothCurve line(Curve{1, {0, 0, 1, 1}, {Vec4(1, 2, 3, 1), Vec4(21, 12, -7, 1)}});
    const FrameResult straight = rotationMinimizingFrames(line, evenly(7));
    for (const CurveFrame& frame : straight.frames) QVERIFY((frame.normal - straight.frames[0].normal).norm() < 1e-15);
    // An S in a plane, with an inflection: the normal across the plane stays.
    const SmoothCurve flat(
        Curve{3, {0, 0, 0, 0, 1, 1, 1, 1}, {Vec4(0, 0, 0, 1), Vec4(30, 0, 0, 1), Vec4(-10, 20, 0, 1), Vec4(20, 20, 0, 1)}});
    for (const CurveFrame& frame : rotationMinimizingFrames(flat, evenly(9)).frames)
      QVERIFY((frame.normal - Vec3::UnitZ()).norm() < 1e-14);
    for (const CurveFrame& frame : rotationMinimizingFrames(flat, evenly(2)).frames)
      QVERIFY((frame.normal - Vec3::UnitZ()).norm() < 1e-14);
  }

  void cuspsAreRefusedWithTheirParameter() {
    auto random = seededRandom();
    for (int k = 0; k < 50; ++k) {
      // ((t - c)^2, (t - c)^3, 0), turned a little by its third component.
      const double c = uniform(random, 0.05, 0.95);
      const auto blossom = [&](double a, double b, double d) {
        const double x = a - c, y = b - c, z = d - c;
        return Vec4(10 * (x * y + y * z + z * x) / 3, 10 * x * y * z, 3 * (x * y + y * z + z * x), 1);
      };
      const Curve curve{
          3, {0, 0, 0, 0, 1, 1, 1, 1}, {blossom(0, 0, 0), blossom(0, 0, 1), blossom(0, 1, 1), blossom(1, 1, 1)}};
      try {
        const SmoothCurve smooth(curve);
        QFAIL("accepted");
      } catch (const Error& error) {
        QCOMPARE(error.code(), ErrorCode::Degenerate);
        double found = -1;
        const auto at = error.message().find("v = ");
        QVERIFY2(at != std::string::npos, error.what());
        QCOMPARE(std::sscanf(error.message().c_str() + at, "v = %lf", &found), 1);
        COMPARE_NEAR(found, c, 1e-5);
      }
    }
    VERIFY_ERROR(SmoothCurve(Curve{2, {0, 0, 0, 1, 1, 1}, {Vec4(0, 0, 0, 1), Vec4(0, 0, 0, 1), Vec4(1, 0, 0, 1)}}),
                 ErrorCode::Degenerate);
    VERIFY_ERROR(SmoothCurve(Curve{1, {0, 0, 1, 1}, {Vec4(2, 0, 0, 1), Vec4(2, 0, 0, 1)}}), ErrorCode::Degenerate);
  }

  void cornersAndWeightsAreRefused() {
    const Curve corner{1, {0, 0, 0.5, 1, 1}, {Vec4(0, 0, 0, 1), Vec4(5, 0, 0, 1), Vec4(5, 5, 0, 1)}};
    VERIFY_ERROR(SmoothCurve(corner), ErrorCode::InvalidInput);
    const Curve negative{2, {0, 0, 0, 1, 1, 1}, {Vec4(0, 0, 0, 1), Vec4(-1, 0, 0, -0.1), Vec4(1, 5, 0, 1)}};
    VERIFY_ERROR(SmoothCurve(negative), ErrorCode::InvalidInput);
    const SmoothCurve line(Curve{1, {0, 0, 1, 1}, {Vec4(0, 0, 0, 1), Vec4(1, 0, 0, 1)}});
    VERIFY_ERROR(rotationMinimizingFrames(line, evenly(2), {.normal = Vec3(2, 0, 0)}), ErrorCode::InvalidParameter);
    const std::vector<double> backwards{1, 0};
    VERIFY_ERROR(rotationMinimizingFrames(line, backwards), ErrorCode::InvalidParameter);
  }

  void splinesOfFramesKeepTheirTolerance() {
    auto random = seededRandom();
    for (int k = 0; k < 12; ++k) {
      const SmoothCurve curve(k % 2 == 0 ? randomPath(random) : randomRing(random));
      const double tolerance = std::pow(10.0, -uniformInt(random, 2, 6));
      const FrameSpline fitted = fitFrames(curve, {.tolerance = tolerance, .spans = 6, .maximumSpans = 2048});
      QVERIFY(fitted.deviation <= tolerance);
      // Elsewhere than where it was measured.
      const std::vector<double> at = evenly(1777);
      const FrameResult truth = rotationMinimizingFrames(curve, at, {.accuracy = tolerance / 100});
      double worst = 0;
      for (const CurveFrame& frame : truth.frames)
        worst = std::max(worst, angleBetween(evaluate(fitted.quaternions, frame.at),
                                             rotationOfAxes(frame.normal, frame.binormal(), frame.tangent)));
      QVERIFY2(worst <= 1.1 * tolerance, qPrintable(QString("%1 > %2").arg(worst).arg(tolerance)));
      const Vec4 &first = fitted.quaternions.poles.front(), &last = fitted.quaternions.poles.back();
      if (curve.closed()) QVERIFY(first == last || first == -last);
    }
  }

  void framesAreCancelled() {
    auto random = seededRandom();
    CancelToken token;
    token.cancel();
    VERIFY_ERROR(fitFrames(SmoothCurve(randomPath(random)), {}, Progress(token)), ErrorCode::Cancelled);
  }
};

BLOSSOM_TEST(SweepFramesTest)
#include "sweep_frames_test.moc"
