#include "exchange/cad/entity_count.h"

#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <set>
#include <utility>
#include <vector>

namespace blossom {

namespace {

void countInto(Value& counts, const TopoDS_Shape& shape) {
  static constexpr std::pair<TopAbs_ShapeEnum, const char*> kinds[] = {{TopAbs_SOLID, "solid"},
                                                                       {TopAbs_SHELL, "shell"},
                                                                       {TopAbs_FACE, "face"},
                                                                       {TopAbs_EDGE, "edge"},
                                                                       {TopAbs_VERTEX, "vertex"}};
  TopTools_IndexedMapOfShape all;
  TopExp::MapShapes(shape, all);
  for (const auto& [kind, name] : kinds) {
    int count = 0;
    for (int i = 1; i <= all.Extent(); ++i) count += all(i).ShapeType() == kind;
    if (count > 0) counts[name] = counts.value(name, 0) + count;
  }
}

void countInto(Value& counts, const std::vector<BrepInstance>& instances, std::set<const BrepPart*>& seen) {
  for (const BrepInstance& instance : instances) {
    const BrepPart* part = instance.part.get();
    if (!part || !seen.insert(part).second) continue;
    const char* kind = part->children.empty() ? "part" : "assembly";
    counts[kind] = counts.value(kind, 0) + 1;
    if (!part->shape.IsNull()) countInto(counts, part->shape);
    countInto(counts, part->children, seen);
  }
}

}  // namespace

Value countEntities(const Brep& brep) {
  Value counts = Value::object();
  std::set<const BrepPart*> seen;
  countInto(counts, brep.roots(), seen);
  return counts;
}

}  // namespace blossom
