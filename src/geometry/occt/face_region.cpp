#include "geometry/occt/face_region.h"

#include <fmt/format.h>
#include <BRepAdaptor_Surface.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>

#include <cmath>
#include <optional>

#include "core/error.h"
#include "core/place_text.h"
#include "core/tolerance.h"
#include "geometry/occt/occt.h"
#include "geometry/planar/planar.h"

namespace blossom {
namespace {

constexpr double levelAngle = 1e-7;  // radians; a face of 1 m then rises by 1e-4 mm

std::string placeOf(const gp_Pnt& p) { return placeText({p.X(), p.Y(), p.Z()}); }

/// Where a face lies. @throws Error when it is not level.
double heightOf(const TopoDS_Face& face) {
  const BRepAdaptor_Surface surface(face);
  if (surface.GetType() != GeomAbs_Plane) {
    const gp_Pnt somewhere = surface.Value((surface.FirstUParameter() + surface.LastUParameter()) / 2,
                                           (surface.FirstVParameter() + surface.LastVParameter()) / 2);
    throw Error(ErrorCode::InvalidInput, fmt::format("The face at {} is not flat.", placeOf(somewhere)),
                "Give a drawing, or flat faces that lie level.");
  }
  const gp_Pln plane = surface.Plane();
  if (std::abs(std::abs(plane.Axis().Direction().Z()) - 1) > levelAngle * levelAngle)
    throw Error(ErrorCode::InvalidInput, fmt::format("The face at {} is tilted.", placeOf(plane.Location())),
                "Turn it with transform until it lies level, square to the z axis.");
  return plane.Location().Z();
}

}  // namespace

Region toRegion(const Brep& brep) {
  if (TopExp_Explorer(brep.shape(), TopAbs_SOLID).More())
    throw Error(ErrorCode::InvalidInput, "A solid is no planar region.", "Give a drawing, or flat faces that lie level.");
  std::optional<double> height;
  Curves outlines;
  for (TopExp_Explorer face(brep.shape(), TopAbs_FACE); face.More(); face.Next()) {
    const double here = heightOf(TopoDS::Face(face.Current()));
    if (height && std::abs(*height - here) > Tolerance{}.joining)
      throw Error(ErrorCode::InvalidInput,
                  fmt::format("The faces lie at different heights, z = {:.6g} and z = {:.6g}.", *height, here),
                  "Give the faces of one height alone.");
    height = here;
    for (Path& path : planarCurves(face.Current()).paths) outlines.paths.push_back(std::move(path));
  }
  if (!height)
    throw Error(ErrorCode::InvalidInput, "The shape has no face.", "Give a drawing, or flat faces that lie level.");
  return toRegion(outlines);
}

}  // namespace blossom
