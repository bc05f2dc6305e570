#include "transport/brep_transport.h"

#include <BRep_Builder.hxx>
#include <BinTools.hxx>
#include <Standard_Failure.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Iterator.hxx>
#include <fstream>
#include <map>
#include <memory>

#include "core/error.h"
#include "transport/bulk_file.h"
#include "transport/numbers.h"

namespace blossom {

// The identity must stay one: a shape moved by a matrix of ones is another shape.
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

namespace {

namespace fs = std::filesystem;

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

void writeShapes(const TopoDS_Shape& shapes, const fs::path& file) {
  std::ofstream stream(file, std::ios::binary);
  try {
    BinTools::Write(shapes, stream);
  } catch (const Standard_Failure&) {
    throw Error(ErrorCode::InvalidInput, "The shape cannot be handed over to a helper process.");
  }
  finishBulkFile(stream, file);
}

TopoDS_Shape readShapes(const fs::path& file) {
  TopoDS_Shape shapes;
  std::ifstream stream(file, std::ios::binary);
  try {
    BinTools::Read(shapes, stream);
  } catch (const Standard_Failure&) {
    throwUnreadableShapes();
  }
  if (shapes.IsNull()) throwUnreadableShapes();
  return shapes;
}

}  // namespace

Value saveBrep(const Brep& brep, const fs::path& folder, const std::string& name) {
  if (brep.shape().IsNull()) throw Error(ErrorCode::InvalidInput, "The input is empty.");
  const fs::path file = folder / (name + ".brep");
  Saver saver;
  Value roots = saver.instances(brep.roots());
  writeShapes(saver.shapes(), file);
  return {{"file", file.filename().string()}, {"roots", std::move(roots)}, {"parts", saver.parts()}};
}

Brep loadBrep(const Value& value, const fs::path& folder) {
  const Loader loader(readShapes(folder / value.at("file").get<std::string>()), value.at("parts"));
  return Brep(loader.instances(value.at("roots")));
}

}  // namespace blossom
