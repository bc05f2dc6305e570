#include "exchange/cad/brep_transport.h"

#include <BRep_Builder.hxx>
#include <BinTools.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Iterator.hxx>
#include <fstream>
#include <map>
#include <memory>
#include <set>

#include "core/file.h"
#include "exchange/cad/occt_io.h"

namespace blossom {

namespace {

namespace fs = std::filesystem;

constexpr const char* shapesFile = "shapes.bin";
constexpr const char* structureFile = "structure.json";

Value colorValue(const std::optional<Color>& color) {
  return color ? Value::array({color->red, color->green, color->blue}) : Value();
}

std::optional<Color> toColor(const Value& value) {
  if (value.is_null()) return {};
  return Color{value.at(0), value.at(1), value.at(2)};
}

/// Rows of the 3x4 matrix; null for the identity, which must stay one: a shape moved by a matrix of ones is another shape.
Value locationValue(const gp_Trsf& location) {
  if (location.Form() == gp_Identity) return {};
  Value rows = Value::array();
  for (int row = 1; row <= 3; ++row)
    for (int column = 1; column <= 4; ++column) rows.push_back(location.Value(row, column));
  return rows;
}

gp_Trsf toLocation(const Value& v) {
  gp_Trsf location;
  if (v.is_null()) return location;
  location.SetValues(v.at(0), v.at(1), v.at(2), v.at(3), v.at(4), v.at(5), v.at(6), v.at(7), v.at(8), v.at(9), v.at(10),
                     v.at(11));
  return location;
}

/// Collects the parts, each before its users, and their shapes.
class Saver {
 public:
  Saver() { builder_.MakeCompound(shapes_); }

  Value instances(const std::vector<BrepInstance>& all) {
    Value list = Value::array();
    for (const BrepInstance& instance : all) {
      const Value part = instance.part ? Value(index(instance.part)) : Value();
      list.push_back({{"name", instance.name},
                      {"color", colorValue(instance.color)},
                      {"location", locationValue(instance.location)},
                      {"part", part}});
    }
    return list;
  }
  [[nodiscard]] const Value& parts() const { return parts_; }
  [[nodiscard]] const TopoDS_Compound& shapes() const { return shapes_; }

 private:
  std::size_t index(const std::shared_ptr<const BrepPart>& part) {
    if (const auto known = indices_.find(part.get()); known != indices_.end()) return known->second;
    Value entry{{"name", part->name}, {"color", colorValue(part->color)}};
    if (!part->children.empty()) entry["children"] = instances(part->children);
    if (!part->shape.IsNull()) {
      builder_.Add(shapes_, part->shape);
      entry["shape"] = shapeCount_++;
      if (!part->subShapeColors.empty()) entry["sub_shapes"] = subShapes(*part);
    }
    parts_.push_back(std::move(entry));
    return indices_[part.get()] = parts_.size() - 1;
  }

  static Value subShapes(const BrepPart& part) {
    TopTools_IndexedMapOfShape all;
    TopExp::MapShapes(part.shape, all);
    Value list = Value::array();
    for (const auto& [shape, color] : part.subShapeColors)
      if (const int found = all.FindIndex(shape)) list.push_back({{"index", found}, {"color", colorValue(color)}});
    return list;
  }

  BRep_Builder builder_;
  TopoDS_Compound shapes_;
  int shapeCount_ = 0;
  Value parts_ = Value::array();
  std::map<const BrepPart*, std::size_t> indices_;
};

class Loader {
 public:
  Loader(const TopoDS_Shape& shapes, const Value& parts) {
    for (TopoDS_Iterator each(shapes); each.More(); each.Next()) shapes_.push_back(each.Value());
    for (const Value& entry : parts) parts_.push_back(part(entry));
  }

  [[nodiscard]] std::vector<BrepInstance> instances(const Value& list) const {
    std::vector<BrepInstance> all;
    for (const Value& entry : list) {
      const Value& part = entry.at("part");
      all.push_back({entry.at("name"), toColor(entry.at("color")), toLocation(entry.at("location")),
                     part.is_null() ? nullptr : parts_.at(part.get<std::size_t>())});
    }
    return all;
  }

 private:
  [[nodiscard]] std::shared_ptr<const BrepPart> part(const Value& entry) const {
    auto made = std::make_shared<BrepPart>();
    made->name = entry.at("name");
    made->color = toColor(entry.at("color"));
    if (const auto children = entry.find("children"); children != entry.end()) made->children = instances(*children);
    if (const auto shape = entry.find("shape"); shape != entry.end()) made->shape = shapes_.at(shape->get<std::size_t>());
    if (const auto colors = entry.find("sub_shapes"); colors != entry.end()) {
      TopTools_IndexedMapOfShape all;
      TopExp::MapShapes(made->shape, all);
      for (const Value& each : *colors)
        made->subShapeColors.emplace_back(all.FindKey(each.at("index").get<int>()), *toColor(each.at("color")));
    }
    return made;
  }

  std::vector<TopoDS_Shape> shapes_;
  std::vector<std::shared_ptr<const BrepPart>> parts_;
};

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

void saveBrep(const Brep& brep, const fs::path& folder) {
  Saver saver;
  Value structure{{"roots", saver.instances(brep.roots())}, {"parts", Value()}};
  structure["parts"] = saver.parts();
  std::ofstream shapes(folder / shapesFile, std::ios::binary);
  withOcctErrors(ErrorCode::Internal, "The shapes could not be handed over.",
                 [&] { BinTools::Write(saver.shapes(), shapes); });
  std::ofstream text(folder / structureFile, std::ios::binary);
  text << structure.dump(-1, ' ', false, Value::error_handler_t::replace);
  shapes.close();
  text.close();
  if (!shapes || !text)
    throw Error(ErrorCode::FileUnwritable, "There is no room for temporary files in \"" + folder.string() + "\".",
                "Free some disk space.");
}

Brep loadBrep(const fs::path& folder) {
  const char* broken = "The result of a helper process cannot be read.";
  const Value structure = Value::parse(readFile(folder / structureFile), nullptr, false);
  if (!structure.is_object()) throw Error(ErrorCode::Internal, broken);
  TopoDS_Shape shapes;
  std::ifstream stream(folder / shapesFile, std::ios::binary);
  withOcctErrors(ErrorCode::Internal, broken, [&] { BinTools::Read(shapes, stream); });
  if (shapes.IsNull()) throw Error(ErrorCode::Internal, broken);
  const Loader loader(shapes, structure.at("parts"));
  return Brep(loader.instances(structure.at("roots")));
}

Value countEntities(const Brep& brep) {
  Value counts = Value::object();
  std::set<const BrepPart*> seen;
  countInto(counts, brep.roots(), seen);
  return counts;
}

}  // namespace blossom
