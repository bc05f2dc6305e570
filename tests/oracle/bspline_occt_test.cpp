#include <Geom_BSplineCurve.hxx>
#include <Geom_BSplineSurface.hxx>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColStd_Array2OfReal.hxx>
#include <TColgp_Array1OfPnt.hxx>
#include <TColgp_Array2OfPnt.hxx>

#include "geometry/bspline/bspline.h"
#include "support/splines.h"
#include "support/support.h"

using namespace blossom;
using namespace blossom::test;

/// OCCT's B-splines as an independent implementation. They are built here from poles and knots, not by our own conversion.
namespace {

struct Distinct {
  TColStd_Array1OfReal knots;
  TColStd_Array1OfInteger multiplicities;

  explicit Distinct(const std::vector<double>& full) : knots(1, length(full)), multiplicities(1, length(full)) {
    Standard_Integer last = 0;
    for (const double knot : full) {
      if (last > 0 && knots(last) == knot) {
        ++multiplicities(last);
        continue;
      }
      knots(++last) = knot;
      multiplicities(last) = 1;
    }
  }
  static int length(const std::vector<double>& full) {
    int count = 0;
    for (std::size_t i = 0; i < full.size(); ++i) count += i == 0 || full[i] != full[i - 1];
    return count;
  }
};

gp_Pnt place(const Vec4& pole) { return {pole.x() / pole.w(), pole.y() / pole.w(), pole.z() / pole.w()}; }
Vec3 vec(const gp_XYZ& p) { return {p.X(), p.Y(), p.Z()}; }

Handle(Geom_BSplineCurve) occt(const Curve& curve) {
  const int n = static_cast<int>(curve.poles.size());
  TColgp_Array1OfPnt poles(1, n);
  TColStd_Array1OfReal weights(1, n);
  for (int i = 1; i <= n; ++i) {
    poles(i) = place(curve.poles[static_cast<std::size_t>(i) - 1]);
    weights(i) = curve.poles[static_cast<std::size_t>(i) - 1].w();
  }
  const Distinct knots(curve.knots);
  return new Geom_BSplineCurve(poles, weights, knots.knots, knots.multiplicities, curve.degree);
}

Handle(Geom_BSplineSurface) occt(const Surface& surface) {
  const int nu = static_cast<int>(surface.countU()), nv = static_cast<int>(surface.countV());
  TColgp_Array2OfPnt poles(1, nu, 1, nv);
  TColStd_Array2OfReal weights(1, nu, 1, nv);
  for (int i = 1; i <= nu; ++i)
    for (int j = 1; j <= nv; ++j) {
      const Vec4& pole = surface.pole(static_cast<std::size_t>(i) - 1, static_cast<std::size_t>(j) - 1);
      poles(i, j) = place(pole);
      weights(i, j) = pole.w();
    }
  const Distinct u(surface.knotsU), v(surface.knotsV);
  return new Geom_BSplineSurface(poles, weights, u.knots, v.knots, u.multiplicities, v.multiplicities, surface.degreeU,
                                 surface.degreeV);
}

/// Derivatives of the quotient x/w in R^3 up to order 2, from homogeneous ones.
std::array<Vec3, 3> quotient(const std::vector<Vec4>& d) {
  const double w = d[0].w();
  const Vec3 x = d[0].head<3>() / w;
  const Vec3 dx = (d[1].head<3>() - d[1].w() * x) / w;
  return {x, dx, (d[2].head<3>() - 2 * d[1].w() * dx - d[2].w() * x) / w};
}

/// How much a derivative may be larger than the points it subtracts: by the narrowest span.
double steepness(const std::vector<double>& knots) {
  double narrowest = 1;
  for (std::size_t i = 1; i < knots.size(); ++i)
    if (knots[i] > knots[i - 1]) narrowest = std::min(narrowest, knots[i] - knots[i - 1]);
  return 1 / narrowest;
}

/// Multiplicity at most the degree inside, which is OCCT's rule.
KnotChoice tame(bool clamped) { return {.spans = 5, .clamped = clamped}; }

}  // namespace

class BsplineOcctTest : public QObject {
  Q_OBJECT

 private slots:
  void initTestCase() { random_ = seededRandom(); }

  void points() {
    for (int repeat = 0; repeat < 300; ++repeat) {
      const Curve curve = randomCurve(random_, uniformInt(random_, 1, 25), tame(repeat % 2 == 0));
      const auto peer = occt(curve);
      COMPARE_NEAR(peer->FirstParameter(), curve.domain().first, 0);
      COMPARE_NEAR(peer->LastParameter(), curve.domain().second, 0);
      const double t = randomParameter(random_, {0, 1});
      COMPARE_NEAR((point(curve, t) - vec(peer->Value(t).XYZ())).norm(), 0, 1e-12);

      const Surface surface = randomSurface(random_, uniformInt(random_, 1, 9), uniformInt(random_, 1, 12),
                                            tame(repeat % 2 == 0), tame(repeat % 2 == 0));
      const double u = randomParameter(random_, {0, 1}), v = randomParameter(random_, {0, 1});
      COMPARE_NEAR((point(surface, u, v) - vec(occt(surface)->Value(u, v).XYZ())).norm(), 0, 1e-12);
    }
  }

  // OCCT's D1 and D2 lose a digit every second degree (1e-4 at degree 25, even in the point), so the comparison stays at low
  // ones.
  void derivativesOfCurves() {
    for (int repeat = 0; repeat < 300; ++repeat) {
      const Curve curve = randomCurve(random_, uniformInt(random_, 1, 6), tame(repeat % 2 == 0));
      const double t = uniform(random_, 0, 1);
      gp_Pnt p;
      gp_Vec d1, d2;
      occt(curve)->D2(t, p, d1, d2);
      const auto ours = quotient(derivatives(curve, t, 2));
      const double steep = steepness(curve.knots);
      COMPARE_NEAR((ours[0] - vec(p.XYZ())).norm(), 0, 1e-11);
      COMPARE_NEAR((ours[1] - vec(d1.XYZ())).norm(), 0, 1e-10 * steep);
      COMPARE_NEAR((ours[2] - vec(d2.XYZ())).norm(), 0, 1e-9 * steep * steep);
    }
  }

  void derivativesOfSurfaces() {
    for (int repeat = 0; repeat < 200; ++repeat) {
      const Surface surface = randomSurface(random_, uniformInt(random_, 1, 5), uniformInt(random_, 1, 5),
                                            tame(repeat % 2 == 0), tame(repeat % 2 == 0));
      const double u = uniform(random_, 0, 1), v = uniform(random_, 0, 1);
      gp_Pnt p;
      gp_Vec du, dv;
      occt(surface)->D1(u, v, p, du, dv);
      const SurfaceFrame ours = frame(surface, u, v);
      COMPARE_NEAR((ours.point - vec(p.XYZ())).norm(), 0, 1e-11);
      COMPARE_NEAR((ours.du - vec(du.XYZ())).norm(), 0, 1e-10 * steepness(surface.knotsU));
      COMPARE_NEAR((ours.dv - vec(dv.XYZ())).norm(), 0, 1e-10 * steepness(surface.knotsV));
    }
  }

  void knotInsertionGivesTheSamePoles() {
    for (int repeat = 0; repeat < 200; ++repeat) {
      const Curve curve = randomCurve(random_, uniformInt(random_, 1, 15), tame(true));
      const auto peer = occt(curve);
      std::vector<double> knots;
      for (int i = uniformInt(random_, 1, 5); i > 0; --i) knots.push_back(uniform(random_, 0.01, 0.99));
      std::sort(knots.begin(), knots.end());
      for (const double knot : knots) peer->InsertKnot(knot, 1, 0, Standard_True);
      compare(insertKnots(curve, knots), peer, 1e-12);
    }
  }

  void knotInsertionInSurfacesGivesTheSamePoles() {
    for (int repeat = 0; repeat < 50; ++repeat) {
      const Surface surface =
          randomSurface(random_, uniformInt(random_, 1, 5), uniformInt(random_, 1, 5), tame(true), tame(true));
      const auto peer = occt(surface);
      const std::vector<double> u = {uniform(random_, 0.01, 0.99)}, v = {uniform(random_, 0.01, 0.99)};
      peer->InsertUKnot(u[0], 1, 0, Standard_True);
      peer->InsertVKnot(v[0], 1, 0, Standard_True);
      compare(insertKnotsV(insertKnotsU(surface, u), v), peer, 1e-12);
    }
  }

  void degreeElevationGivesTheSamePoles() {
    for (int repeat = 0; repeat < 200; ++repeat) {
      const int degree = uniformInt(random_, 1, 12), times = uniformInt(random_, 1, 8);
      const Curve curve = randomCurve(random_, degree, tame(true));
      const auto peer = occt(curve);
      peer->IncreaseDegree(degree + times);
      compare(elevateDegree(curve, times), peer, 1e-11);
    }
  }

  void degreeElevationOfSurfacesGivesTheSamePoles() {
    for (int repeat = 0; repeat < 50; ++repeat) {
      const int p = uniformInt(random_, 1, 5), q = uniformInt(random_, 1, 5);
      const Surface surface = randomSurface(random_, p, q, tame(true), tame(true));
      const auto peer = occt(surface);
      peer->IncreaseDegree(p + 2, q + 3);
      compare(elevateDegree(surface, 2, 3), peer, 1e-11);
    }
  }

  void isoCurvesLieOnTheSurface() {
    for (int repeat = 0; repeat < 50; ++repeat) {
      const Surface surface =
          randomSurface(random_, uniformInt(random_, 1, 6), uniformInt(random_, 1, 6), tame(true), tame(true));
      const auto peer = occt(surface);
      const double u = uniform(random_, 0, 1), v = uniform(random_, 0, 1);
      COMPARE_NEAR((point(isoU(surface, u), v) - vec(peer->UIso(u)->Value(v).XYZ())).norm(), 0, 1e-12);
      COMPARE_NEAR((point(isoV(surface, v), u) - vec(peer->VIso(v)->Value(u).XYZ())).norm(), 0, 1e-12);
    }
  }

 private:
  static void compare(const Curve& ours, const Handle(Geom_BSplineCurve) & peer, double tolerance) {
    QCOMPARE(static_cast<int>(ours.poles.size()), peer->NbPoles());
    QCOMPARE(ours.degree, peer->Degree());
    for (std::size_t i = 0; i < ours.poles.size(); ++i) {
      const int k = static_cast<int>(i) + 1;
      COMPARE_NEAR((vec(place(ours.poles[i]).XYZ()) - vec(peer->Pole(k).XYZ())).norm(), 0, tolerance);
      COMPARE_NEAR(ours.poles[i].w(), peer->Weight(k), tolerance);
    }
  }

  static void compare(const Surface& ours, const Handle(Geom_BSplineSurface) & peer, double tolerance) {
    QCOMPARE(static_cast<int>(ours.countU()), peer->NbUPoles());
    QCOMPARE(static_cast<int>(ours.countV()), peer->NbVPoles());
    for (std::size_t i = 0; i < ours.countU(); ++i)
      for (std::size_t j = 0; j < ours.countV(); ++j) {
        const int k = static_cast<int>(i) + 1, l = static_cast<int>(j) + 1;
        COMPARE_NEAR((vec(place(ours.pole(i, j)).XYZ()) - vec(peer->Pole(k, l).XYZ())).norm(), 0, tolerance);
        COMPARE_NEAR(ours.pole(i, j).w(), peer->Weight(k, l), tolerance);
      }
  }

  Random random_;
};

BLOSSOM_TEST(BsplineOcctTest)
#include "bspline_occt_test.moc"
