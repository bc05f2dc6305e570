#include "exchange/cad/iges_colors.h"

#include <BRepBndLib.hxx>
#include <BRep_Tool.hxx>
#include <Bnd_Box.hxx>
#include <Geom_Surface.hxx>
#include <IGESCAFControl.hxx>
#include <IGESData_IGESModel.hxx>
#include <IGESGraph_Color.hxx>
#include <Quantity_Color.hxx>
#include <TDF_LabelSequence.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Face.hxx>
#include <TransferBRep.hxx>
#include <Transfer_TransientProcess.hxx>
#include <XCAFDoc_ColorTool.hxx>
#include <XCAFDoc_DocumentTool.hxx>
#include <XCAFDoc_ShapeTool.hxx>
#include <XSControl_TransferReader.hxx>
#include <XSControl_WorkSession.hxx>
#include <algorithm>
#include <limits>
#include <optional>
#include <unordered_map>
#include <vector>

namespace blossom {

namespace {

std::optional<Quantity_Color> colorOf(const IGESData_IGESEntity& entity) {
  if (entity.DefColor() == IGESData_DefValue) return IGESCAFControl::DecodeColor(entity.RankColor());
  if (entity.DefColor() != IGESData_DefReference) return std::nullopt;
  const auto given = Handle(IGESGraph_Color)::DownCast(entity.Color());
  if (given.IsNull()) return std::nullopt;
  double red = 0, green = 0, blue = 0;  // percent
  given->RGBIntensity(red, green, blue);
  const auto share = [](double percent) { return std::clamp(percent / 100, 0.0, 1.0); };
  return Quantity_Color(share(red), share(green), share(blue), Quantity_TOC_sRGB);
}

struct PlacedFace {
  TDF_Label part;
  TopoDS_Face face;
};

Handle(Geom_Surface) surfaceOf(const TopoDS_Face& face) {
  TopLoc_Location ignored;
  return BRep_Tool::Surface(face, ignored);
}

/// The faces of all parts by the surfaces they lie on.
using FacesBySurface = std::unordered_map<const Geom_Surface*, std::vector<PlacedFace>>;

FacesBySurface facesOf(const XCAFDoc_ShapeTool& shapes) {
  TDF_LabelSequence labels;
  shapes.GetShapes(labels);
  FacesBySurface faces;
  for (const TDF_Label& label : labels) {
    if (!XCAFDoc_ShapeTool::IsSimpleShape(label)) continue;
    for (TopExp_Explorer found(XCAFDoc_ShapeTool::GetShape(label), TopAbs_FACE); found.More(); found.Next()) {
      const TopoDS_Face face = TopoDS::Face(found.Current());
      faces[surfaceOf(face).get()].push_back({label, face});
    }
  }
  return faces;
}

/// Largest distance between the corners of the boxes of two faces.
double boxesApart(const TopoDS_Face& a, const TopoDS_Face& b) {
  Bnd_Box boxA, boxB;
  BRepBndLib::Add(a, boxA, Standard_False);
  BRepBndLib::Add(b, boxB, Standard_False);
  if (boxA.IsVoid() || boxB.IsVoid()) return std::numeric_limits<double>::max();
  return std::max(boxA.CornerMin().Distance(boxB.CornerMin()), boxA.CornerMax().Distance(boxB.CornerMax()));
}

/// Of several faces on one surface the one that lies where the lost face does.
const PlacedFace* copyOf(const TopoDS_Face& lost, const FacesBySurface& faces) {
  const auto found = faces.find(surfaceOf(lost).get());
  if (found == faces.end() || !found->first) return nullptr;
  const auto isNearer = [&](const PlacedFace& a, const PlacedFace& b) {
    return boxesApart(lost, a.face) < boxesApart(lost, b.face);
  };
  return &*std::min_element(found->second.begin(), found->second.end(), isNearer);
}

}  // namespace

void addLostFaceColors(const IGESCAFControl_Reader& reader, const Handle(TDocStd_Document) & document) {
  const Handle(XCAFDoc_ShapeTool) shapes = XCAFDoc_DocumentTool::ShapeTool(document->Main());
  const Handle(XCAFDoc_ColorTool) colors = XCAFDoc_DocumentTool::ColorTool(document->Main());
  const auto model = Handle(IGESData_IGESModel)::DownCast(reader.WS()->Model());
  const Handle(Transfer_TransientProcess) transfer = reader.WS()->TransferReader()->TransientProcess();
  std::optional<FacesBySurface> faces;  // seldom needed
  for (int i = 1; i <= model->NbEntities(); ++i) {
    const auto entity = Handle(IGESData_IGESEntity)::DownCast(model->Value(i));
    const auto color = entity.IsNull() ? std::nullopt : colorOf(*entity);
    const Handle(Transfer_Binder) made = color ? transfer->Find(entity) : Handle(Transfer_Binder)();
    const TopoDS_Shape shape = made.IsNull() ? TopoDS_Shape() : TransferBRep::ShapeResult(made);
    TDF_Label known;
    if (shape.IsNull() || shape.ShapeType() != TopAbs_FACE ||
        shapes->SearchUsingMap(shape, known, Standard_False, Standard_True))
      continue;
    if (!faces) faces = facesOf(*shapes);
    if (const PlacedFace* copy = copyOf(TopoDS::Face(shape), *faces))
      colors->SetColor(shapes->AddSubShape(copy->part, copy->face), *color, XCAFDoc_ColorGen);
  }
}

}  // namespace blossom
