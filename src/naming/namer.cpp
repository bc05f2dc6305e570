#include "naming/namer.h"

#include <TopExp.hxx>
#include <TopTools_IndexedDataMapOfShapeListOfShape.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <algorithm>

namespace blossom {

namespace {

std::string joined(const std::vector<std::string>& parts, const char* joint) {
  std::string text;
  for (const std::string& part : parts) text += (text.empty() ? "" : joint) + part;
  return text;
}

void sortOut(FaceName& name) {
  std::sort(name.begin(), name.end());
  name.erase(std::unique(name.begin(), name.end()), name.end());
}

/// The numbers of the faces at each sub-shape of a kind.
std::vector<std::vector<std::size_t>> faceNumbersAt(const TopoDS_Shape& shape, TopAbs_ShapeEnum type) {
  TopTools_IndexedMapOfShape faces, parts;
  TopTools_IndexedDataMapOfShapeListOfShape around;
  TopExp::MapShapes(shape, TopAbs_FACE, faces);
  TopExp::MapShapes(shape, type, parts);
  TopExp::MapShapesAndAncestors(shape, type, TopAbs_FACE, around);
  std::vector<std::vector<std::size_t>> all(static_cast<std::size_t>(parts.Extent()));
  for (int k = 1; k <= parts.Extent(); ++k) {
    auto& numbers = all[static_cast<std::size_t>(k - 1)];
    if (type == TopAbs_FACE) {
      numbers.push_back(static_cast<std::size_t>(k - 1));
    } else if (around.Contains(parts(k))) {
      for (const TopoDS_Shape& face : around.FindFromKey(parts(k)))
        numbers.push_back(static_cast<std::size_t>(faces.FindIndex(face) - 1));
      std::sort(numbers.begin(), numbers.end());
      numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
    }
  }
  return all;
}

/// Faces without a name are called after those beside them: "beside" and their names.
void nameByNeighbours(const TopoDS_Shape& shape, std::vector<FaceName>& names) {
  std::vector<FaceName> beside(names.size());
  for (const auto& faces : faceNumbersAt(shape, TopAbs_EDGE))
    for (const std::size_t face : faces)
      for (const std::size_t other : faces)
        if (names[face].empty() && !names[other].empty()) beside[face].push_back("beside " + joined(names[other], "+"));
  for (std::size_t k = 0; k < names.size(); ++k) {
    if (!names[k].empty()) continue;
    sortOut(beside[k]);
    names[k] = std::move(beside[k]);
  }
}

}  // namespace

const std::vector<FaceName>& Namer::faces(const std::string& id, const Progress& progress) {
  if (const auto known = named_.find(id); known != named_.end()) return known->second;
  std::vector<FaceName> names = made(construction_.step(id), progress);
  return named_.insert_or_assign(id, std::move(names)).first->second;
}

std::vector<FaceName> Namer::made(const ConstructionStep& step, const Progress& progress) {
  const Brep* brep = step.result.get<Brep>();
  const auto own = [&](std::size_t count) {
    std::vector<FaceName> names(count);
    for (std::size_t k = 0; k < count; ++k)
      names[k] = {labelOf_({step.id, SubShapeKind::Face, static_cast<int>(k)}, step.result)};
    return names;
  };
  if (!brep || brep->shape().IsNull()) return own(step.result.get<Region>() ? 1 : 0);
  const std::size_t count = subShapesOf(brep->shape(), TopAbs_FACE).size();
  if (step.inputs.empty()) return own(count);
  const auto& origins = construction_.origins(step.id, progress);
  const bool traced = std::any_of(origins.begin(), origins.end(), [](const auto& each) { return !each.empty(); });
  if (!traced) return own(count);
  std::vector<FaceName> names(count);
  for (std::size_t k = 0; k < count; ++k) {
    for (const FaceOrigin& origin : origins[k]) {
      const std::string label = labelOf(step, origin.input, origin.kind, origin.index, progress);
      if (!label.empty()) names[k].push_back(origin.tag.empty() ? label : label + "@" + step.id + " " + origin.tag);
    }
    sortOut(names[k]);
  }
  nameByNeighbours(brep->shape(), names);
  return names;
}

/// The name of a part of an input: its own where the input is a source, else that of the faces it belongs to.
std::string Namer::labelOf(const ConstructionStep& step, std::size_t input, SubShapeKind kind, int index,
                           const Progress& progress) {
  const Shape& shape = step.inputs.at(input);
  const Brep* brep = shape.get<Brep>();
  if (!brep) return labelOf_({step.sources.at(input), kind, index}, shape);
  std::vector<std::string> parts;
  for (const FaceName& face : facesAt(*brep, kind, index, faces(step.sources.at(input), progress))) {
    if (face.empty()) return {};
    parts.push_back(joined(face, "+"));
  }
  if (parts.empty()) return labelOf_({step.sources.at(input), kind, index}, shape);  // a wire without faces
  return kind == SubShapeKind::Face ? parts.front() : "(" + joined(parts, "|") + ")";
}

std::vector<std::vector<FaceName>> facesAtAll(const Brep& brep, SubShapeKind kind, const std::vector<FaceName>& names) {
  std::vector<std::vector<FaceName>> all;
  for (const auto& numbers : faceNumbersAt(brep.shape(), shapeTypeOf(kind))) {
    auto& at = all.emplace_back();
    for (const std::size_t number : numbers) at.push_back(names.at(number));
    std::sort(at.begin(), at.end());
  }
  return all;
}

std::vector<FaceName> facesAt(const Brep& brep, SubShapeKind kind, int index, const std::vector<FaceName>& names) {
  if (kind == SubShapeKind::Face) return {names.at(static_cast<std::size_t>(index))};
  return facesAtAll(brep, kind, names).at(static_cast<std::size_t>(index));
}

}  // namespace blossom
