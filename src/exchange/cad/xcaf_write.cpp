#include "exchange/cad/xcaf_write.h"

#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRep_Builder.hxx>
#include <Quantity_Color.hxx>
#include <TCollection_ExtendedString.hxx>
#include <TDataStd_Name.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS_Compound.hxx>
#include <XCAFDoc_ColorTool.hxx>
#include <XCAFDoc_DocumentTool.hxx>
#include <XCAFDoc_ShapeTool.hxx>
#include <algorithm>
#include <map>

#include "core/error.h"
#include "exchange/cad/xcaf_read.h"
#include "exchange/format/axis_curves.h"
#include "geometry/occt/occt.h"

namespace blossom {

namespace {

constexpr std::size_t largestMesh = 100'000;

TopoDS_Shape meshShape(const Mesh& mesh) {
  if (mesh.faceCount() > largestMesh)
    throw Error(ErrorCode::LimitExceeded,
                "A mesh of " + std::to_string(mesh.faceCount()) + " faces is too large for this format; the limit is " +
                    std::to_string(largestMesh) + ".",
                "Write it as STL, OBJ or PLY, or simplify it first.");
  return toShape(mesh);
}

using PartsWithGeometry = std::map<const BrepPart*, std::shared_ptr<const BrepPart>>;

bool hasGeometry(const TopoDS_Shape& shape) {
  if (shape.IsNull()) return false;
  for (const TopAbs_ShapeEnum kind : {TopAbs_FACE, TopAbs_EDGE, TopAbs_VERTEX})
    if (TopExp_Explorer(shape, kind).More()) return true;
  return false;
}

class DocumentWriter {
 public:
  DocumentWriter()
      : document_(newDocument()),
        shapes_(XCAFDoc_DocumentTool::ShapeTool(document_->Main())),
        colors_(XCAFDoc_DocumentTool::ColorTool(document_->Main())) {}

  Handle(TDocStd_Document) write(const std::vector<BrepInstance>& roots) {
    // A free shape of a document has no place of its own; roots that have one, or share a part, need an assembly around
    // them.
    const bool plain = std::all_of(roots.begin(), roots.end(), [this](const BrepInstance& root) {
      return root.location.Form() == gp_Identity && (!root.color || root.part->color) && ++uses_[root.part.get()] == 1;
    });
    if (plain) {
      for (const BrepInstance& root : roots) part(*root.part, root.name);
    } else {
      const TDF_Label assembly = shapes_->NewShape();
      setName(assembly, "Assembly");
      assemble(assembly, roots);
    }
    shapes_->UpdateAssemblies();
    return document_;
  }

 private:
  TDF_Label part(const BrepPart& source, const std::string& nameOfUse) {
    if (const auto known = labels_.find(&source); known != labels_.end()) return known->second;
    const TDF_Label label = shapes_->NewShape();
    labels_.emplace(&source, label);
    // OCCT would number unnamed products by all it has written since the program started.
    const std::string fallback = nameOfUse.empty() ? (source.children.empty() ? "Part" : "Assembly") : nameOfUse;
    setName(label, source.name.empty() ? fallback : source.name);
    if (source.children.empty()) {
      shapes_->SetShape(label, source.shape);
      for (const auto& [shape, color] : source.subShapeColors) setColor(shapes_->AddSubShape(label, shape), color);
    } else {
      assemble(label, source.children);
    }
    setColor(label, source.color);
    return label;
  }

  void assemble(const TDF_Label& assembly, const std::vector<BrepInstance>& children) {
    for (const BrepInstance& child : children) {
      const TDF_Label component =
          shapes_->AddComponent(assembly, part(*child.part, child.name), TopLoc_Location(child.location));
      setName(component, child.name);
      setColor(component, child.color);
    }
  }

  static void setName(const TDF_Label& label, const std::string& name) {
    if (!name.empty()) TDataStd_Name::Set(label, TCollection_ExtendedString(name.c_str(), Standard_True));
  }

  void setColor(const TDF_Label& label, const std::optional<Color>& color) {
    if (!color || label.IsNull()) return;
    const auto inRange = [](double channel) { return std::clamp(channel, 0.0, 1.0); };
    const Quantity_Color value(inRange(color->red), inRange(color->green), inRange(color->blue), Quantity_TOC_sRGB);
    colors_->SetColor(label, value, XCAFDoc_ColorGen);
  }

  Handle(TDocStd_Document) document_;
  Handle(XCAFDoc_ShapeTool) shapes_;
  Handle(XCAFDoc_ColorTool) colors_;
  std::map<const BrepPart*, TDF_Label> labels_;
  std::map<const BrepPart*, int> uses_;
};

/// Instances of parts that are not empty, because OCCT's translators access the shape of every part.
std::vector<BrepInstance> withGeometry(const std::vector<BrepInstance>& uses, PartsWithGeometry& known);

std::shared_ptr<const BrepPart> withGeometry(const std::shared_ptr<const BrepPart>& part, PartsWithGeometry& known) {
  if (!part) return nullptr;
  if (const auto found = known.find(part.get()); found != known.end()) return found->second;
  auto kept = std::make_shared<BrepPart>(*part);
  kept->children = withGeometry(part->children, known);
  const bool empty = part->children.empty() ? !hasGeometry(part->shape) : kept->children.empty();
  return known[part.get()] = empty ? nullptr : kept;
}

std::vector<BrepInstance> withGeometry(const std::vector<BrepInstance>& uses, PartsWithGeometry& known) {
  std::vector<BrepInstance> kept;
  for (const BrepInstance& use : uses)
    if (auto part = withGeometry(use.part, known)) kept.push_back({use.name, use.color, use.location, std::move(part)});
  return kept;
}

struct ToBrep {
  bool heights = false;  ///< of a medial axis
  Brep operator()(const Brep& brep) const { return brep; }
  Brep operator()(const Surface& surface) const { return Brep(toFace(surface), "Surface"); }
  Brep operator()(const Curve& curve) const { return Brep(BRepBuilderAPI_MakeEdge(toOcct(curve)).Shape(), "Curve"); }
  Brep operator()(const Curves& curves) const { return Brep(toWires(curves), "Curves"); }
  Brep operator()(const Region& region) const { return Brep(toFaces(region), "Region"); }
  Brep operator()(const MedialAxis& axis) const {
    if (!heights) return Brep(toWires(drawingOf(axis)), "Medial axis");
    const BRep_Builder builder;
    TopoDS_Compound edges;
    builder.MakeCompound(edges);
    for (const Curve& curve : spaceCurvesOf(axis)) builder.Add(edges, BRepBuilderAPI_MakeEdge(toOcct(curve)).Shape());
    return Brep(edges, "Medial axis");
  }
  Brep operator()(const Mesh& mesh) const {
    return Brep(meshShape(mesh), mesh.name.empty() ? "Mesh" : mesh.name, mesh.color);
  }
  template <class Other>
  Brep operator()(const Other&) const {
    throw Error(ErrorCode::OutputNotSupported, "This kind of shape has no boundary representation.");
  }
};

}  // namespace

Brep toBrep(const Shape& shape, const Value& options) { return shape.visit(ToBrep{options.value("heights", false)}); }

std::vector<ShapeKind> brepKinds() {
  return {ShapeKind::Brep,   ShapeKind::Surface, ShapeKind::Curve,     ShapeKind::Curves,
          ShapeKind::Region, ShapeKind::Mesh,    ShapeKind::MedialAxis};
}

Handle(TDocStd_Document) toDocument(const Brep& brep) {
  PartsWithGeometry known;
  const std::vector<BrepInstance> roots = withGeometry(brep.roots(), known);
  if (roots.empty()) throw Error(ErrorCode::InvalidInput, "The shape is empty; there is nothing to write.");
  return DocumentWriter().write(roots);
}

}  // namespace blossom
