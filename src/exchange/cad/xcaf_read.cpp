#include "exchange/cad/xcaf_read.h"

#include <Quantity_Color.hxx>
#include <TCollection_AsciiString.hxx>
#include <TDF_LabelIndexedMap.hxx>
#include <TDF_LabelSequence.hxx>
#include <TDataStd_Name.hxx>
#include <XCAFDoc_ColorTool.hxx>
#include <XCAFDoc_DocumentTool.hxx>
#include <XCAFDoc_ShapeTool.hxx>

namespace blossom {

namespace {

std::string nameOf(const TDF_Label& label) {
  Handle(TDataStd_Name) name;
  if (!label.FindAttribute(TDataStd_Name::GetID(), name)) return {};
  const TCollection_AsciiString utf8(name->Get());
  return utf8.ToCString();
}

class DocumentReader {
 public:
  explicit DocumentReader(const Handle(TDocStd_Document) & document)
      : shapes_(XCAFDoc_DocumentTool::ShapeTool(document->Main())),
        colors_(XCAFDoc_DocumentTool::ColorTool(document->Main())) {}

  std::vector<BrepInstance> roots() {
    TDF_LabelSequence labels;
    shapes_->GetFreeShapes(labels);
    std::vector<BrepInstance> all;
    for (const TDF_Label& label : labels) {
      if (XCAFDoc_ShapeTool::IsReference(label)) {
        all.push_back(instance(label));
      } else if (auto made = part(label)) {
        all.push_back({made->name, {}, gp_Trsf(), made});
      }
    }
    return all;
  }

 private:
  BrepInstance instance(const TDF_Label& label) {
    TDF_Label referred;
    XCAFDoc_ShapeTool::GetReferredShape(label, referred);
    return {nameOf(label), colorOf(label), XCAFDoc_ShapeTool::GetLocation(label).Transformation(), part(referred)};
  }

  /// nullptr for a part without geometry.
  std::shared_ptr<const BrepPart> part(const TDF_Label& label) {
    if (const int index = labels_.FindIndex(label)) return parts_.at(static_cast<std::size_t>(index - 1));
    auto made = std::make_shared<BrepPart>();
    made->name = nameOf(label);
    made->color = colorOf(label);
    if (XCAFDoc_ShapeTool::IsAssembly(label)) {
      TDF_LabelSequence components;
      XCAFDoc_ShapeTool::GetComponents(label, components);
      for (const TDF_Label& component : components)
        if (BrepInstance child = instance(component); child.part) made->children.push_back(std::move(child));
    } else {
      made->shape = XCAFDoc_ShapeTool::GetShape(label);
      collectSubShapes(label, *made);
    }
    const bool empty = made->children.empty() && made->shape.IsNull();
    labels_.Add(label);
    return parts_.emplace_back(empty ? nullptr : made);
  }

  void collectSubShapes(const TDF_Label& label, BrepPart& made) {
    TDF_LabelSequence labels;
    XCAFDoc_ShapeTool::GetSubShapes(label, labels);
    for (const TDF_Label& sub : labels)
      if (const auto color = colorOf(sub)) made.subShapeColors.emplace_back(XCAFDoc_ShapeTool::GetShape(sub), *color);
  }

  std::optional<Color> colorOf(const TDF_Label& label) {
    for (const XCAFDoc_ColorType type : {XCAFDoc_ColorSurf, XCAFDoc_ColorGen, XCAFDoc_ColorCurv}) {
      Quantity_Color found;
      if (!colors_->GetColor(label, type, found)) continue;
      Color color;
      found.Values(color.red, color.green, color.blue, Quantity_TOC_sRGB);
      return color;
    }
    return {};
  }

  Handle(XCAFDoc_ShapeTool) shapes_;
  Handle(XCAFDoc_ColorTool) colors_;
  TDF_LabelIndexedMap labels_;  ///< of the parts that are read, in their order
  std::vector<std::shared_ptr<const BrepPart>> parts_;
};

}  // namespace

Brep fromDocument(const Handle(TDocStd_Document) & document) { return Brep(DocumentReader(document).roots()); }

Handle(TDocStd_Document) newDocument() {
  XCAFDoc_ShapeTool::SetAutoNaming(Standard_False);
  Handle(TDocStd_Document) document = new TDocStd_Document("BinXCAF");
  XCAFDoc_DocumentTool::Set(document->Main(), Standard_False);
  XCAFDoc_DocumentTool::SetLengthUnit(document, 1, UnitsMethods_LengthUnit_Millimeter);
  return document;
}

}  // namespace blossom
