#include "geometry/occt/occt.h"

#include <fmt/format.h>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <Precision.hxx>
#include <Standard_Failure.hxx>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColgp_Array1OfPnt.hxx>
#include <TColgp_Array2OfPnt.hxx>

#include "core/error.h"
#include "geometry/bspline/bspline.h"
#include "geometry/occt/occt_reason.h"

namespace blossom {
namespace {

constexpr int highestDegree = 25;

/// A full knot vector as OCCT wants it: distinct values with multiplicities.
struct DistinctKnots {
  TColStd_Array1OfReal values;
  TColStd_Array1OfInteger multiplicities;
};

std::vector<std::pair<double, int>> runs(const std::vector<double>& knots) {
  std::vector<std::pair<double, int>> result;
  for (const double knot : knots) {
    if (result.empty() || knot != result.back().first) result.emplace_back(knot, 0);
    ++result.back().second;
  }
  return result;
}

DistinctKnots distinct(const std::vector<double>& knots, int degree) {
  const auto distinctRuns = runs(knots);
  const int count = static_cast<int>(distinctRuns.size());
  DistinctKnots result{TColStd_Array1OfReal(1, count), TColStd_Array1OfInteger(1, count)};
  for (int i = 1; i <= count; ++i) {
    const auto& [value, multiplicity] = distinctRuns[static_cast<std::size_t>(i - 1)];
    if (i > 1 && i < count && multiplicity > degree)
      throw Error(ErrorCode::InvalidInput, fmt::format("The B-spline is torn apart at the knot {}.", value),
                  "Split it there, or lower the knot's multiplicity to the degree.");
    result.values.SetValue(i, value);
    result.multiplicities.SetValue(i, multiplicity);
  }
  return result;
}

std::vector<double> fullKnots(const TColStd_Array1OfReal& values, const TColStd_Array1OfInteger& multiplicities) {
  std::vector<double> knots;
  for (int i = values.Lower(); i <= values.Upper(); ++i)
    knots.insert(knots.end(), static_cast<std::size_t>(multiplicities(i)), values(i));
  return knots;
}

bool isClamped(const std::vector<double>& knots, int degree) {
  const auto all = runs(knots);
  return all.size() >= 2 && all.front().second == degree + 1 && all.back().second == degree + 1;
}

void checkDegree(int degree) {
  if (degree < 1 || degree > highestDegree)
    throw Error(ErrorCode::InvalidInput,
                fmt::format("A B-spline of degree {} cannot be exchanged; the limit is {}.", degree, highestDegree),
                "Approximate it by a cubic one.");
}

void checkWeights(const std::vector<Vec4>& poles) {
  for (const Vec4& pole : poles) {
    if (!pole.allFinite()) throw Error(ErrorCode::InvalidInput, "A pole of the B-spline is not a finite number.");
    if (pole.w() <= 0)
      throw Error(ErrorCode::InvalidInput,
                  fmt::format("A pole of the B-spline has the weight {}; it must be positive.", pole.w()),
                  "Insert knots: the weights then approach the values of the weight function.");
  }
}

gp_Pnt polePoint(const Vec4& pole) { return {pole.x() / pole.w(), pole.y() / pole.w(), pole.z() / pole.w()}; }
Vec4 homogeneous(const gp_Pnt& p, double w) { return {p.X() * w, p.Y() * w, p.Z() * w, w}; }

[[noreturn]] void refused(const Standard_Failure& failure) {
  throw Error(ErrorCode::Degenerate, fmt::format("The geometry kernel refuses the B-spline: {}.", reasonOf(failure)),
              "Look for knots that nearly coincide and for poles that coincide.");
}

}  // namespace

Handle(Geom_BSplineCurve) toOcct(const Curve& given) {
  checkDegree(given.degree);
  const Curve curve = isClamped(given.knots, given.degree) ? given : clamped(given);
  checkWeights(curve.poles);
  const int count = static_cast<int>(curve.poles.size());
  TColgp_Array1OfPnt poles(1, count);
  TColStd_Array1OfReal weights(1, count);
  for (int i = 1; i <= count; ++i) {
    const Vec4& pole = curve.poles[static_cast<std::size_t>(i - 1)];
    poles.SetValue(i, polePoint(pole));
    weights.SetValue(i, pole.w());
  }
  const DistinctKnots knots = distinct(curve.knots, curve.degree);
  try {
    return new Geom_BSplineCurve(poles, weights, knots.values, knots.multiplicities, curve.degree);
  } catch (const Standard_Failure& failure) {
    refused(failure);
  }
}

Handle(Geom_BSplineSurface) toOcct(const Surface& given) {
  checkDegree(given.degreeU);
  checkDegree(given.degreeV);
  const bool ready = isClamped(given.knotsU, given.degreeU) && isClamped(given.knotsV, given.degreeV);
  const Surface surface = ready ? given : clamped(given);
  checkWeights(surface.poles);
  const int countU = static_cast<int>(surface.countU());
  const int countV = static_cast<int>(surface.countV());
  TColgp_Array2OfPnt poles(1, countU, 1, countV);
  TColStd_Array2OfReal weights(1, countU, 1, countV);
  for (int i = 1; i <= countU; ++i) {
    for (int j = 1; j <= countV; ++j) {
      const Vec4& pole = surface.pole(static_cast<std::size_t>(i - 1), static_cast<std::size_t>(j - 1));
      poles.SetValue(i, j, polePoint(pole));
      weights.SetValue(i, j, pole.w());
    }
  }
  const DistinctKnots knotsU = distinct(surface.knotsU, surface.degreeU);
  const DistinctKnots knotsV = distinct(surface.knotsV, surface.degreeV);
  try {
    return new Geom_BSplineSurface(poles, weights, knotsU.values, knotsV.values, knotsU.multiplicities,
                                   knotsV.multiplicities, surface.degreeU, surface.degreeV);
  } catch (const Standard_Failure& failure) {
    refused(failure);
  }
}

Curve fromOcct(const Handle(Geom_BSplineCurve) & given) {
  Handle(Geom_BSplineCurve) curve = given;
  if (curve->IsPeriodic()) {
    curve = Handle(Geom_BSplineCurve)::DownCast(given->Copy());
    curve->SetNotPeriodic();
  }
  Curve result{curve->Degree(), fullKnots(curve->Knots(), curve->Multiplicities()), {}};
  result.poles.reserve(static_cast<std::size_t>(curve->NbPoles()));
  for (int i = 1; i <= curve->NbPoles(); ++i) result.poles.push_back(homogeneous(curve->Pole(i), curve->Weight(i)));
  return result;
}

Surface fromOcct(const Handle(Geom_BSplineSurface) & given) {
  Handle(Geom_BSplineSurface) surface = given;
  if (surface->IsUPeriodic() || surface->IsVPeriodic()) {
    surface = Handle(Geom_BSplineSurface)::DownCast(given->Copy());
    if (surface->IsUPeriodic()) surface->SetUNotPeriodic();
    if (surface->IsVPeriodic()) surface->SetVNotPeriodic();
  }
  Surface result{surface->UDegree(),
                 surface->VDegree(),
                 fullKnots(surface->UKnots(), surface->UMultiplicities()),
                 fullKnots(surface->VKnots(), surface->VMultiplicities()),
                 {}};
  // Asked of the given one: after SetUNotPeriodic OCCT holds weights of 0 for surfaces without weights.
  const bool rational = given->IsURational() || given->IsVRational();
  result.poles.reserve(static_cast<std::size_t>(surface->NbUPoles()) * static_cast<std::size_t>(surface->NbVPoles()));
  for (int i = 1; i <= surface->NbUPoles(); ++i)
    for (int j = 1; j <= surface->NbVPoles(); ++j)
      result.poles.push_back(homogeneous(surface->Pole(i, j), rational ? surface->Weight(i, j) : 1));
  return result;
}

TopoDS_Face toFace(const Surface& surface) {
  const Handle(Geom_BSplineSurface) geometry = toOcct(surface);
  try {
    BRepBuilderAPI_MakeFace maker(geometry, Precision::Confusion());
    if (maker.IsDone()) return maker.Face();
    throw Error(ErrorCode::Degenerate, "No face can be made over the surface.",
                "Check that the surface does not collapse into a curve or a point.");
  } catch (const Standard_Failure& failure) {
    refused(failure);
  }
}

}  // namespace blossom
