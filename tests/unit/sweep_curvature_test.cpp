#include <Eigen/Geometry>

#include "geometry/bspline/bspline.h"
#include "support/motions.h"
#include "support/support.h"
#include "sweep/kernel/grid/grid_curvature.h"
#include "sweep/kernel/grid/motion_grid.h"
#include "sweep/kernel/grid/motion_point.h"
#include "sweep/kernel/product_surface.h"
#include "sweep/kernel/validity.h"

using namespace blossom;
using namespace blossom::test;
using namespace blossom::sweep;

namespace {

const std::vector<double> line{0, 0, 1, 1}, parabola{0, 0, 0, 1, 1, 1};

/// The quaternion 1 + angle * axis turns about an axis by 2 atan(angle).
Vec4 about(const Vec3& axis, double angle) { return {1, angle * axis.x(), angle * axis.y(), angle * axis.z()}; }

Vec4 quaternionProduct(const Vec4& a, const Vec4& b) {
  const Vec3 x = a.tail<3>(), y = b.tail<3>(), z = a[0] * y + b[0] * x + x.cross(y);
  return {a[0] * b[0] - x.dot(y), z.x(), z.y(), z.z()};
}

/// Bilinear orientation (1 + a u k)(1 + b v axis): about z with u, before that about another axis with v.
Surface turns(double a, double b, const Vec3& axis) {
  Surface r{1, 1, line, line, {}};
  for (const double u : {0.0, 1.0})
    for (const double v : {0.0, 1.0}) r.poles.push_back(quaternionProduct(about(Vec3::UnitZ(), a * u), about(axis, b * v)));
  return r;
}

/// Poles of a0 + a1 v + a2 v^2 on [0, 1].
std::vector<Vec4> polesOf(const Vec4& a0, const Vec4& a1, const Vec4& a2) { return {a0, a0 + a1 / 2, a0 + a1 + a2}; }

/// A scaling that depends on v alone.
Surface scalingInV(const std::vector<Vec4>& poles) {
  Surface s{1, 2, line, parabola, poles};
  s.poles.insert(s.poles.end(), poles.begin(), poles.end());
  return s;
}
Surface noScaling() { return scalingInV(std::vector<Vec4>(3, Vec4::Ones())); }

Curve trajectoryAlongZ(double from, double slope, double bend) {
  return {2, parabola, polesOf({0, 0, from, 1}, {0, 0, slope, 0}, {0, 0, bend, 0})};
}
Curve atRest() { return trajectoryAlongZ(0, 0, 0); }

/// 1 where x_u cross x_v points away from a place, -1 where it points to it.
double outwards(const Motion& motion, double u, double v, const Vec3& from) {
  const MotionPoint at = evaluate(motion, u, v);
  return at.du.cross(at.dv).dot(at.point - from) > 0 ? 1 : -1;
}

struct Curvatures {
  double gaussian, mean;
  double gaussianScale = 1, meanScale = 1;  ///< sizes of the terms that make them up: what rounding errors go with
};

Curvatures curvatureAt(const Motion& motion, double u, double v) {
  GridCurvature grid;
  evaluateCurvature(motion, {&u, 1}, {&v, 1}, grid);
  return {grid.gaussian[0], grid.mean[0]};
}

/// From the homogeneous derivatives of the product surface and the quotient rule in space: shares nothing with the kernel.
Curvatures curvatureOfProduct(const Surface& surface, double u, double v) {
  const std::vector<Vec4> d = derivatives(surface, u, v, 2);  // [i * 3 + j]
  const auto part = [&](int i, int j) { return d[static_cast<std::size_t>(i * 3 + j)]; };
  const double w = part(0, 0)[3];
  const Vec3 x = part(0, 0).head<3>() / w;
  const Vec3 xu = (part(1, 0).head<3>() - part(1, 0)[3] * x) / w, xv = (part(0, 1).head<3>() - part(0, 1)[3] * x) / w;
  const Vec3 xuu = (part(2, 0).head<3>() - 2 * part(1, 0)[3] * xu - part(2, 0)[3] * x) / w;
  const Vec3 xvv = (part(0, 2).head<3>() - 2 * part(0, 1)[3] * xv - part(0, 2)[3] * x) / w;
  const Vec3 xuv = (part(1, 1).head<3>() - part(1, 0)[3] * xv - part(0, 1)[3] * xu - part(1, 1)[3] * x) / w;
  const Vec3 n = xu.cross(xv).normalized();
  const double e = xu.dot(xu), f = xu.dot(xv), g = xv.dot(xv), area = e * g - f * f;
  const double l = xuu.dot(n), m = xuv.dot(n), k = xvv.dot(n);
  const double bend = std::max({xuu.norm() / e, xuv.norm() / std::sqrt(e * g), xvv.norm() / g}), slant = e * g / area;
  return {(l * k - m * m) / area, (e * k - 2 * f * m + g * l) / (2 * area), bend * bend * slant * slant,
          bend * slant * slant};
}

}  // namespace

class SweepCurvatureTest : public QObject {
  Q_OBJECT
 private slots:
  void sphere() {
    Motion motion{atRest(), turns(1.3, 0.8, Vec3::UnitY()), noScaling(), ClosedU::No, Vec3(3, 0, 0)};
    for (const double u : {0.0, 0.3, 1.0})
      for (const double v : {0.1, 0.6, 1.0}) {
        const Curvatures at = curvatureAt(motion, u, v);
        COMPARE_NEAR(at.gaussian, 1.0 / 9, 1e-13);
        COMPARE_NEAR(at.mean, -outwards(motion, u, v, Vec3::Zero()) / 3, 1e-13);
      }
  }

  void cylinder() {
    Motion motion{trajectoryAlongZ(0, 5, 2), turns(1.3, 0, Vec3::UnitY()), noScaling(), ClosedU::No, Vec3(0, 4, 0)};
    for (const double v : {0.0, 0.4, 1.0}) {
      const Curvatures at = curvatureAt(motion, 0.7, v);
      COMPARE_NEAR(at.gaussian, 0, 1e-14);
      COMPARE_NEAR(at.mean, -outwards(motion, 0.7, v, point(motion.trajectory, v)) / 8, 1e-13);
    }
  }

  /// A circle of radius a by a rational scaling, turned at the distance b about z.
  void torus() {
    const double a = 2, b = 5;
    Motion motion{atRest(), turns(1.3, 0, Vec3::UnitY()),
                  scalingInV(polesOf({b + a, 1, 0, 1}, {0, 0, 2 * a, 0}, {b - a, 1, 0, 1})), ClosedU::No, Vec3(1, 0, 1)};
    for (const double v : {0.0, 0.35, 0.9, 1.0}) {
      const double cosine = (1 - v * v) / (1 + v * v), sine = 2 * v / (1 + v * v), away = b + a * cosine;
      QVERIFY((evaluate(motion, 0, v).point - Vec3(away, 0, a * sine)).norm() < 1e-12);
      const Curvatures at = curvatureAt(motion, 0, v);
      COMPARE_NEAR(at.gaussian, cosine / (a * away), 1e-13);
      COMPARE_NEAR(at.mean, -outwards(motion, 0, v, Vec3(b, 0, 0)) * (b + 2 * a * cosine) / (2 * a * away), 1e-13);
    }
  }

  /// A profile that agrees with the catenary cosh(z) up to its second derivative at v = 1/2: minimal there.
  void catenoid() {
    const double at = 0.5, z = 0.8, c = std::cosh(z), s = std::sinh(z);
    // cosh(z) + sinh(z) (v - at) + cosh(z) (v - at)^2 / 2 in powers of v
    const std::vector<Vec4> radii =
        polesOf({c - s * at + c * at * at / 2, 1, 1, 1}, {s - c * at, 0, 0, 0}, {c / 2, 0, 0, 0});
    Motion motion{trajectoryAlongZ(z - at, 1, 0), turns(1.3, 0, Vec3::UnitY()), scalingInV(radii), ClosedU::No,
                  Vec3(1, 0, 0)};
    for (const double u : {0.0, 0.2, 0.9}) {
      const Curvatures found = curvatureAt(motion, u, at);
      COMPARE_NEAR(found.gaussian, -1 / std::pow(c, 4), 1e-13);
      COMPARE_NEAR(found.mean, 0, 1e-13);
    }
  }

  /// A line of length 1 to 4 that turns by the angle f = 2 atan(v) and climbs as 3 f does up to the second derivative at
  /// v = 0.4: a helicoid there.
  void helicoid() {
    const double at = 0.4, pitch = 3, slope = 2 / (1 + at * at), bend = -4 * at / std::pow(1 + at * at, 2);
    Surface s{1, 1, line, line, {Vec4(1, 1, 1, 1), Vec4(1, 1, 1, 1), Vec4(4, 1, 1, 1), Vec4(4, 1, 1, 1)}};
    Motion motion{trajectoryAlongZ(0, pitch * (slope - bend * at), pitch * bend / 2), turns(0, 1, Vec3::UnitZ()), s,
                  ClosedU::No, Vec3(1, 0, 0)};
    for (const double u : {0.0, 0.5, 1.0}) {
      const double radius = 1 + 3 * u;
      const Curvatures found = curvatureAt(motion, u, at);
      COMPARE_NEAR(found.gaussian, -pitch * pitch / std::pow(pitch * pitch + radius * radius, 2), 1e-13);
      COMPARE_NEAR(found.mean, 0, 1e-13);
    }
  }

  void randomMotionsEqualTheProductSurface() {
    auto random = seededRandom();
    double worst = 0;
    for (int k = 0; k < 60; ++k) {
      Motion motion = randomMotion(random, static_cast<ClosedU>(k % 3));
      if (k % 5 == 0) motion.point = Vec3(0, 1.5, 0);
      const Surface surface = productSurface(motion).surface;
      std::vector<double> us, vs;
      for (int i = 0; i < 5; ++i) us.push_back(randomIn(random, motion.domainU()));
      for (int i = 0; i < 41; ++i) vs.push_back(randomIn(random, motion.domainV()));
      GridCurvature grid;
      evaluateCurvature(motion, us, vs, grid);
      for (std::size_t i = 0; i < us.size(); ++i)
        for (std::size_t l = 0; l < vs.size(); ++l) {
          const Curvatures wanted = curvatureOfProduct(surface, us[i], vs[l]);
          const double offK = std::abs(wanted.gaussian - grid.gaussian[i * vs.size() + l]) / wanted.gaussianScale,
                       offH = std::abs(wanted.mean - grid.mean[i * vs.size() + l]) / wanted.meanScale;
          worst = std::max({worst, offK, offH});
        }
    }
    // Second derivatives of the product surface lose digits in the square of its spans, some of which are 1/100 long.
    qInfo("figure curvature_share %g", worst);
    QVERIFY2(worst < 1e-8, qPrintable(QString::number(worst)));
  }

  void whereTheNormalVanishesBothAreZero() {
    Motion motion{trajectoryAlongZ(0, 1, 0), turns(1.3, 0, Vec3::UnitY()), noScaling(), ClosedU::No, Vec3(0, 0, 1)};
    const Curvatures at = curvatureAt(motion, 0.5, 0.5);
    COMPARE_NEAR(at.gaussian, 0, 0);
    COMPARE_NEAR(at.mean, 0, 0);
  }

  /// W alone has the coefficients of the product surface, as long as that needs no more knots.
  void smallestWeightIsThatOfTheProduct() {
    auto random = seededRandom();
    int compared = 0;
    for (int k = 0; k < 60; ++k) {
      const Motion motion = randomMotion(random, static_cast<ClosedU>(k % 3));
      const ProductResult product = productSurface(motion);
      const SmallestWeight found = smallestProductWeight(motion);
      QVERIFY(found.weight > 0 || product.refinements > 0);
      QCOMPARE(smallestWeightOf(product.surface, motion).weight, product.smallestWeight);
      QVERIFY((evaluate(motion, found.u, found.v).point - found.place).norm() == 0);
      if (product.refinements > 0) continue;
      COMPARE_NEAR(found.weight, product.smallestWeight, 1e-13);
      ++compared;
    }
    QVERIFY(compared > 0);
  }

  /// One weight of the trajectory is far smaller than the others: the coefficient lies at its end of the domain.
  void smallestWeightHasItsPlace() {
    Motion motion{trajectoryAlongZ(0, 5, 0), turns(1.3, 0, Vec3::UnitY()), noScaling(), ClosedU::No, Vec3(4, 0, 0)};
    motion.trajectory.poles.back() *= 0.01;
    const SmallestWeight found = smallestProductWeight(motion);
    COMPARE_NEAR(found.v, 1, 1e-15);
    QVERIFY((found.place - evaluate(motion, found.u, 1).point).norm() < 1e-12);
  }

  /// The radius runs to zero at one end: so does the normal, on the axis.
  void smallestNormalHasItsPlace() {
    Motion motion{trajectoryAlongZ(1, 5, 0), turns(1.3, 0, Vec3::UnitY()),
                  scalingInV(polesOf({2, 1, 1, 1}, {-2, 0, 0, 0}, Vec4::Zero())), ClosedU::No, Vec3(1, 0, 0)};
    const Validity found = examine(motion);
    QVERIFY(found.smallestShare < 1e-12);
    COMPARE_NEAR(found.v, 1, 0);
    COMPARE_NEAR((found.place - Vec3(0, 0, 6)).norm(), 0, 1e-12);
  }
};

BLOSSOM_TEST(SweepCurvatureTest)
#include "sweep_curvature_test.moc"
