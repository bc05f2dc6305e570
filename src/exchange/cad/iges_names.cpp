#include "exchange/cad/iges_names.h"

#include <IGESBasic_Name.hxx>
#include <IGESData_IGESEntity.hxx>
#include <NCollection_IndexedDataMap.hxx>
#include <TCollection_HAsciiString.hxx>
#include <TDF_LabelSequence.hxx>
#include <TDataStd_Name.hxx>
#include <TopTools_ShapeMapHasher.hxx>
#include <TransferBRep.hxx>
#include <TransferBRep_ShapeMapper.hxx>
#include <Transfer_FinderProcess.hxx>
#include <XCAFDoc_DocumentTool.hxx>
#include <XCAFDoc_ShapeTool.hxx>

namespace blossom {

namespace {

using Name = Handle(TDataStd_Name);

Name nameAt(const TDF_Label& label) {
  Name name;
  label.FindAttribute(TDataStd_Name::GetID(), name);
  return name;
}

/// Shapes as they are placed, each with the name of its use, or where that has none, of its part.
class NamedShapes {
 public:
  explicit NamedShapes(const Handle(TDocStd_Document) & document) {
    TDF_LabelSequence roots;
    XCAFDoc_DocumentTool::ShapeTool(document->Main())->GetFreeShapes(roots);
    for (const TDF_Label& root : roots) {
      give(XCAFDoc_ShapeTool::GetShape(root), nameAt(root));
      collect(root, TopLoc_Location(), nameAt(root));
    }
  }

  template <class Visit>
  void each(const Visit& visit) const {
    for (int i = 1; i <= names_.Extent(); ++i) visit(names_.FindKey(i), names_.FindFromIndex(i)->Get());
  }

 private:
  void collect(const TDF_Label& label, const TopLoc_Location& place, const Name& ofUse) {
    TDF_LabelSequence components;
    XCAFDoc_ShapeTool::GetComponents(label, components);
    for (const TDF_Label& component : components) {
      TDF_Label part;
      if (!XCAFDoc_ShapeTool::GetReferredShape(component, part)) continue;
      const Name own = nameAt(component);
      collect(part, place.Multiplied(XCAFDoc_ShapeTool::GetLocation(component)), own.IsNull() ? nameAt(part) : own);
    }
    if (components.IsEmpty())
      give(XCAFDoc_ShapeTool::GetShape(label).Moved(place, Standard_False), ofUse.IsNull() ? nameAt(label) : ofUse);
  }

  void give(const TopoDS_Shape& shape, const Name& name) {
    if (shape.IsNull() || name.IsNull()) return;
    if (names_.Contains(shape))
      names_.ChangeFromKey(shape) = name;
    else
      names_.Add(shape, name);
  }

  NCollection_IndexedDataMap<TopoDS_Shape, Name, TopTools_ShapeMapHasher> names_;
};

/// The label of an entity has eight characters, the last ones those of the name.
Handle(TCollection_HAsciiString) labelOf(const TCollection_ExtendedString& name) {
  constexpr int width = 8;
  const int length = std::min(name.Length(), width);
  std::string label(static_cast<std::size_t>(width - length), ' ');
  for (int i = 1; i <= length; ++i) label += IsAnAscii(name.Value(i)) ? static_cast<char>(name.Value(i)) : '?';
  return new TCollection_HAsciiString(label.c_str());
}

}  // namespace

void writeIgesNames(IGESCAFControl_Writer& writer, const Handle(TDocStd_Document) & document) {
  const Handle(Transfer_FinderProcess) process = writer.TransferProcess();
  NamedShapes(document).each([&](const TopoDS_Shape& shape, const TCollection_ExtendedString& name) {
    Handle(IGESData_IGESEntity) entity;
    const Handle(TransferBRep_ShapeMapper) mapper = TransferBRep::ShapeMapper(process, shape);
    if (!process->FindTypedTransient(mapper, STANDARD_TYPE(IGESData_IGESEntity), entity)) return;
    entity->SetLabel(labelOf(name));
    const Handle(IGESBasic_Name) whole = new IGESBasic_Name;  // form 15 of entity 406
    whole->Init(1, new TCollection_HAsciiString(TCollection_AsciiString(name, '_')));
    entity->AddProperty(whole);
    writer.AddEntity(whole);
  });
}

}  // namespace blossom
