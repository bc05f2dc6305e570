#include "faces_brep.h"

#include <fmt/format.h>
#include <BRepBuilderAPI_MakeSolid.hxx>
#include <BRepBuilderAPI_Sewing.hxx>
#include <BRepLib.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Standard_Failure.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Shell.hxx>

#include <vector>

#include "core/error.h"
#include "geometry/occt/occt.h"
#include "geometry/occt/occt_progress.h"
#include "geometry/shape/compound.h"

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

TopoDS_Shell shellOf(const TopoDS_Face& face) {
  TopoDS_Shell shell;
  const BRep_Builder builder;
  builder.MakeShell(shell);
  builder.Add(shell, face);
  return shell;
}

/// A solid when the shell is closed, else the shape unchanged.
TopoDS_Shape solidOr(const TopoDS_Shell& shell, const TopoDS_Shape& given) {
  if (!BRep_Tool::IsClosed(shell)) return given;
  TopoDS_Solid solid = BRepBuilderAPI_MakeSolid(shell).Solid();
  BRepLib::OrientClosedSolid(solid);
  return solid;
}

int faceCount(const TopoDS_Shape& shape) {
  int count = 0;
  for (TopExp_Explorer faces(shape, TopAbs_FACE); faces.More(); faces.Next()) ++count;
  return count;
}

void checkNoneIsLost(const TopoDS_Shape& sewn, std::size_t faces) {
  const auto left = static_cast<std::size_t>(faceCount(sewn));
  if (left < faces)
    throw Error(ErrorCode::Degenerate,
                fmt::format("{} of the {} B-spline faces are squeezed to a line or a point.", faces - left, faces),
                "Look for vertices of the cage that lie on each other.");
}

/// Shells that close become solids, and so do faces that close by themselves, as that of a torus.
TopoDS_Shape withSolids(const TopoDS_Shape& sewn) {
  std::vector<TopoDS_Shape> parts;
  for (TopExp_Explorer shells(sewn, TopAbs_SHELL); shells.More(); shells.Next())
    parts.push_back(solidOr(TopoDS::Shell(shells.Current()), shells.Current()));
  for (TopExp_Explorer loose(sewn, TopAbs_FACE, TopAbs_SHELL); loose.More(); loose.Next())
    parts.push_back(solidOr(shellOf(TopoDS::Face(loose.Current())), loose.Current()));
  return compoundOf(parts);
}

}  // namespace

Brep brepOf(const std::vector<Surface>& faces, const std::string& name, const std::optional<Color>& color,
            const Progress& progress) {
  try {
    const TopoDS_Shape joined = sewn(faces, progress);
    checkNoneIsLost(joined, faces.size());
    return Brep(withSolids(joined), name, color);
  } catch (const Standard_Failure& failure) {
    throw Error(ErrorCode::Degenerate, std::string("The faces cannot be joined: ") + failure.GetMessageString(),
                "Look for faces of the cage that are squeezed to a line or a point.");
  }
}

}  // namespace blossom::subdivision
