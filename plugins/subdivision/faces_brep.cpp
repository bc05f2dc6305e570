#include "faces_brep.h"

#include <BRepBuilderAPI_MakeSolid.hxx>
#include <BRepBuilderAPI_Sewing.hxx>
#include <BRepLib.hxx>
#include <BRep_Builder.hxx>
#include <Standard_Failure.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Shell.hxx>

#include "core/error.h"
#include "geometry/occt.h"
#include "geometry/occt_progress.h"

namespace blossom::subdivision {
namespace {

/// Faces meet in the same curves up to rounding; this is far above and far below what matters, in mm.
constexpr double sewingTolerance = 1e-6;

TopoDS_Shape sewn(const std::vector<Surface>& faces, const Progress& progress) {
  BRepBuilderAPI_Sewing sewing(sewingTolerance);
  for (std::size_t f = 0; f < faces.size(); ++f) {
    progress.report(0.4 * static_cast<double>(f) / static_cast<double>(faces.size()), "Sewing faces");
    sewing.Add(toFace(faces[f]));
  }
  const Handle(OcctProgress) indicator = new OcctProgress(progress.part(0.4, 1), "Sewing faces");
  sewing.Perform(indicator->Start());
  progress.check();
  return sewing.SewedShape();
}

/// Shells that close become solids.
TopoDS_Shape withSolids(const TopoDS_Shape& sewn) {
  TopoDS_Compound all;
  BRep_Builder builder;
  builder.MakeCompound(all);
  int parts = 0;
  TopoDS_Shape last;
  for (TopExp_Explorer shells(sewn, TopAbs_SHELL); shells.More(); shells.Next(), ++parts) {
    const TopoDS_Shell shell = TopoDS::Shell(shells.Current());
    last = shell;
    if (shell.Closed()) {
      TopoDS_Solid solid = BRepBuilderAPI_MakeSolid(shell).Solid();
      BRepLib::OrientClosedSolid(solid);
      last = solid;
    }
    builder.Add(all, last);
  }
  for (TopExp_Explorer loose(sewn, TopAbs_FACE, TopAbs_SHELL); loose.More(); loose.Next(), ++parts)
    builder.Add(all, last = loose.Current());
  return parts == 1 ? last : all;
}

}  // namespace

Brep brepOf(const std::vector<Surface>& faces, const std::string& name, const Progress& progress) {
  try {
    return Brep(withSolids(sewn(faces, progress)), name);
  } catch (const Standard_Failure& failure) {
    throw Error(ErrorCode::Degenerate, std::string("The faces cannot be joined: ") + failure.GetMessageString(),
                "Look for faces of the cage that are squeezed to a line or a point.");
  }
}

}  // namespace blossom::subdivision
