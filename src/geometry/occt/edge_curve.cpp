#include "geometry/occt/edge_curve.h"

#include <BRep_Tool.hxx>
#include <GeomConvert.hxx>
#include <Geom_TrimmedCurve.hxx>
#include <Standard_Failure.hxx>
#include <algorithm>

#include "core/error.h"

namespace blossom {

Handle(Geom_BSplineCurve) edgeSpline(const TopoDS_Edge& edge) {
  double first = 0, last = 0;
  const Handle(Geom_Curve) curve = BRep_Tool::Curve(edge, first, last);
  if (curve.IsNull()) return {};
  if (!curve->IsPeriodic()) {
    first = std::max(first, curve->FirstParameter());
    last = std::min(last, curve->LastParameter());
  }
  try {
    return GeomConvert::CurveToBSplineCurve(new Geom_TrimmedCurve(curve, first, last));
  } catch (const Standard_Failure&) {
    throw Error(ErrorCode::InvalidInput, "An edge has a curve that does not reach over it.",
                "Repair the file in the program that it comes from, or choose another edge.");
  }
}

}  // namespace blossom
