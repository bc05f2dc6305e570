#include "exchange/mesh/three_mf_read.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <map>
#include <memory>
#include <pugixml.hpp>
#include <set>

#include "core/file.h"
#include "core/zip_archive.h"
#include "exchange/format/mesh_options.h"
#include "exchange/format/text.h"
#include "exchange/mesh/three_mf_rules.h"

namespace blossom {
namespace {

using namespace parse;
using pugi::xml_node;
using three_mf::attribute;
using three_mf::Faults;
using three_mf::localName;
using three_mf::partName;
using Placement = Eigen::Transform<double, 3, Eigen::AffineCompact>;

constexpr int deepest = 64;                        ///< components within components
constexpr std::size_t maximumPlaced = 100'000;     ///< objects, each time they are placed
constexpr std::size_t maximumFaces = 100'000'000;  ///< a small file can place one mesh many times

Error damage(const std::string& sentence) {
  return Error(ErrorCode::FormatDamaged, sentence, "The file is damaged or was not written completely.");
}

xml_node childNamed(const xml_node& parent, std::string_view name) {
  for (const xml_node& child : parent.children())
    if (localName(child) == name) return child;
  return {};
}

double millimetresPerUnit(std::string_view unit) {
  constexpr std::array<std::pair<std::string_view, double>, 6> units{
      {{"micron", 1e-3}, {"millimeter", 1}, {"centimeter", 10}, {"inch", 25.4}, {"foot", 304.8}, {"meter", 1000}}};
  if (unit.empty()) return 1;
  for (const auto& [name, size] : units)
    if (name == unit) return size;
  throw damage(fmt::format("{} is not a unit of 3MF.", shown(unit)));
}

/// Twelve numbers: the rows of a matrix that a row vector is multiplied with (section 3.3). Lengths become mm.
Placement placementOf(const xml_node& node, double unit, Faults& faults) {
  Placement result = Placement::Identity();
  std::string_view rest = attribute(node, "transform");
  if (trimmed(rest).empty()) return result;
  const std::string_view all = rest;
  for (int row = 0; row < 4; ++row)
    for (int column = 0; column < 3; ++column) {
      const auto value = toNumber(takeWord(rest));
      if (!value) throw damage(fmt::format("The transform {} has no twelve numbers.", shown(all)));
      result(column, row) = row == 3 ? *value * unit : *value;
    }
  if (result.linear().determinant() == 0) throw damage(fmt::format("The transform {} leaves no volume.", shown(all)));
  if (result.linear().determinant() < 0) faults.add(fmt::format("the transform {} mirrors", shown(all)));
  return result;
}

/// One .model part of the package.
struct ModelPart {
  pugi::xml_document document;
  xml_node model;
  double unit = 1;
  std::map<std::string, xml_node, std::less<>> objects;  ///< by id
};

class Package {
 public:
  Package(const std::string& bytes, const Progress& progress) : progress_(progress) {
    ZipContent content = readZip(bytes, [this](std::string_view name) {
      const std::string part = partName(name);
      if (!parts_.names.insert(part).second) faults_.add(fmt::format("two parts have the name {}", shown(name)));
      return part.ends_with(".model") || part.ends_with(".rels") || part == "[content_types].xml";
    });
    if (!content.damaged.empty()) throw damage(content.damaged.front());
    for (auto& [name, text] : content.entries) parts_.texts.insert_or_assign(partName(name), std::move(text));
  }

  /// What is wrong with it and with the models read so far.
  [[nodiscard]] Faults& faults() { return faults_; }

  /// The part that the package's relationships name.
  [[nodiscard]] std::string rootPart() {
    std::string root = namedRoot();
    checkPackage(parts_, root, faults_);
    return root;
  }

  const ModelPart& part(const std::string& name) {
    std::unique_ptr<ModelPart>& part = models_[name];
    if (!part) part = load(name);
    return *part;
  }

 private:
  std::string namedRoot() {
    if (const auto relations = parts_.texts.find("_rels/.rels"); relations != parts_.texts.end()) {
      pugi::xml_document document;
      check(document.load_buffer(relations->second.data(), relations->second.size()), relations->first);
      for (const xml_node& each : document.document_element().children())
        if (attribute(each, "Type").ends_with("/3dmodel")) return partName(attribute(each, "Target"));
    }
    faults_.add("it does not say which of its parts is the model");
    if (parts_.texts.contains("3d/3dmodel.model")) return "3d/3dmodel.model";
    throw Error(ErrorCode::FormatDamaged, "It is a zip, but holds no model of 3MF.", "Export it again as 3MF.");
  }

  static void check(const pugi::xml_parse_result& result, const std::string& name) {
    if (!result) throw damage(fmt::format("The XML of its part {} is damaged: {}.", shown(name), result.description()));
  }

  std::unique_ptr<ModelPart> load(const std::string& name) {
    const auto text = parts_.texts.find(name);
    if (text == parts_.texts.end()) throw damage(fmt::format("Its part {} is missing.", shown(name)));
    auto part = std::make_unique<ModelPart>();
    three_mf::checkText(text->second, faults_);
    check(part->document.load_buffer_inplace(text->second.data(), text->second.size()), name);
    part->model = part->document.document_element();
    if (localName(part->model) != "model") throw damage(fmt::format("Its part {} is not a model.", shown(name)));
    part->unit = millimetresPerUnit(attribute(part->model, "unit"));
    for (const xml_node& each : childNamed(part->model, "resources").children())
      if (localName(each) == "object" && !part->objects.emplace(attribute(each, "id"), each).second)
        throw damage(fmt::format("The id {} is given to two objects.", shown(attribute(each, "id"))));
    three_mf::checkMarkup(part->document, progress_, faults_);
    three_mf::checkResources(part->model, parts_, progress_, faults_);
    return part;
  }

  const Progress& progress_;
  Faults faults_;
  three_mf::PackageParts parts_;  ///< models are parsed in place: their texts live as long as the nodes
  std::map<std::string, std::unique_ptr<ModelPart>> models_;
};

/// Puts what is built into one mesh.
class Builder {
 public:
  Builder(Package& package, const Progress& progress) : package_(package), progress_(progress) {}

  Imported build() {
    const std::string root = package_.rootPart();
    const ModelPart& part = package_.part(root);
    tellExtensions(part);
    for (const xml_node& each : childNamed(part.model, "resources").children())
      if (localName(each) != "object") skipped_.add(localName(each));
    const xml_node items = childNamed(part.model, "build");
    if (items.first_child())
      for (const xml_node& item : items.children()) placeReferred(root, item, Placement::Identity(), part.unit, 0);
    else
      placeUnused(root, part);
    return finished();
  }

 private:
  /// Extensions that a reader must know (section 2.3), except those that leave the shape as it is.
  void tellExtensions(const ModelPart& part) {
    std::string_view rest = attribute(part.model, "requiredextensions");
    while (!trimmed(rest).empty()) {
      const std::string_view prefix = takeWord(rest);
      std::string space = part.model.attribute(fmt::format("xmlns:{}", prefix).c_str()).value();
      space.erase(
          0, space.find("/3dmanufacturing") + 1);  // the common prefix carries no information; not found: nothing erased
      const auto isHarmless = [&](std::string_view name) { return space.find(name) != std::string::npos; };
      if (!isHarmless("/production/") && !isHarmless("/material/") && !isHarmless("/trianglesets/"))
        warnings_.push_back(
            fmt::format("It uses an extension of 3MF that Blossom does not read ({}); what that adds is left out.",
                        shown(space.empty() ? prefix : std::string_view(space))));
    }
  }

  /// What a build item or a component refers to, perhaps in another part.
  void placeReferred(const std::string& from, const xml_node& reference, const Placement& outer, double unit, int depth) {
    const std::string_view path = attribute(reference, "path");
    place(path.empty() ? from : partName(path), attribute(reference, "objectid"),
          outer * placementOf(reference, unit, package_.faults()), depth);
  }

  void place(const std::string& partName, std::string_view id, const Placement& placement, int depth) {
    if (depth > deepest) throw damage(fmt::format("The object {} is a component of itself.", shown(id)));
    if (++placed_ > maximumPlaced)
      throw Error(ErrorCode::LimitExceeded, fmt::format("It places more than {} objects.", maximumPlaced));
    progress_.check();
    const ModelPart& part = package_.part(partName);
    const auto object = part.objects.find(id);
    if (object == part.objects.end())
      throw damage(fmt::format("The object {}, which is to be built, is missing.", shown(id)));
    if (const std::string_view type = attribute(object->second, "type"); type == "support" || type == "solidsupport")
      return skipped_.add(type);
    for (const xml_node& each : childNamed(object->second, "components").children())
      placeReferred(partName, each, placement, part.unit, depth + 1);
    if (const xml_node mesh = childNamed(object->second, "mesh")) addMesh(object->second, mesh, placement, part.unit);
  }

  /// A file that builds nothing is still one with objects.
  void placeUnused(const std::string& root, const ModelPart& part) {
    std::set<std::string_view> used;
    for (const auto& [id, object] : part.objects)
      for (const xml_node& each : childNamed(object, "components").children()) used.insert(attribute(each, "objectid"));
    for (const auto& [id, object] : part.objects)
      if (!used.contains(id)) place(root, id, Placement::Identity(), 0);
    if (placed_ > 0) warnings_.emplace_back("It says nothing of what is to be built; all its objects are taken.");
  }

  void addMesh(const xml_node& object, const xml_node& mesh, const Placement& placement, double unit) {
    for (const xml_node& each : mesh.children())
      if (localName(each) != "vertices" && localName(each) != "triangles") skipped_.add(localName(each));
    const std::string name = fmt::format("Object {}", shown(attribute(object, "id")));
    const std::size_t first = mesh_.points.size();
    for (const xml_node& each : childNamed(mesh, "vertices").children()) {
      if (mesh_.points.size() % 8192 == 0) progress_.check();
      Vec3 point;
      constexpr std::array<std::string_view, 3> axes{"x", "y", "z"};
      for (std::size_t i = 0; i < 3; ++i) {
        const auto value = toNumber(attribute(each, axes[i]));
        if (!value)
          throw damage(fmt::format("{}: the {} of vertex {} is no number.", name, axes[i], mesh_.points.size() - first));
        point[static_cast<Eigen::Index>(i)] = *value * unit;
      }
      mesh_.points.push_back(placement * point);
    }
    addTriangles(name, childNamed(mesh, "triangles"), first, placement.linear().determinant() < 0);
    if (mesh_.name.empty()) mesh_.name = utf8(attribute(object, "name"));
    ++objects_;
  }

  void addTriangles(const std::string& name, const xml_node& triangles, std::size_t first, bool mirrored) {
    const std::size_t points = mesh_.points.size() - first;
    std::size_t number = 0;
    for (const xml_node& each : triangles.children()) {
      if (mesh_.faceCount() % 8192 == 0) progress_.check();
      if (mesh_.faceCount() >= maximumFaces)
        throw Error(ErrorCode::LimitExceeded, fmt::format("It places more than {} triangles.", maximumFaces));
      std::array<int, 3> corners{};
      constexpr std::array<std::string_view, 3> names{"v1", "v2", "v3"};
      for (std::size_t i = 0; i < 3; ++i) {
        const auto index = toInteger(attribute(each, names[i]));
        if (!index || *index < 0 || static_cast<std::size_t>(*index) >= points)
          throw damage(fmt::format("{}: triangle {} uses vertex {}; there are {}.", name, number,
                                   shown(attribute(each, names[i])), points));
        corners[i] = static_cast<int>(first) + *index;
      }
      if (mirrored) std::swap(corners[1], corners[2]);
      if (corners[0] == corners[1] || corners[1] == corners[2] || corners[2] == corners[0])
        ++flat_;
      else
        mesh_.addFace(corners);
      ++number;
    }
  }

  Imported finished() {
    const auto& lattices = skipped_.counts();
    if (lattices.contains("beamlattice") && mesh_.faceCount() == 0)
      throw Error(ErrorCode::InvalidInput, "It holds lattices of beams alone, which Blossom does not read.",
                  "Turn them into triangles in the program that made them.");
    if (lattices.contains("beamlattice")) warnings_.emplace_back("Lattices of beams are left out.");
    const auto faults = package_.faults().sentences();
    warnings_.insert(warnings_.end(), faults.begin(), faults.end());
    if (flat_ > 0)
      warnings_.push_back(fmt::format("{} with two equal corners {} left out.",
                                      flat_ == 1 ? "A triangle" : fmt::format("{} triangles", flat_),
                                      flat_ == 1 ? "is" : "are"));
    Imported imported = importedMesh(std::move(mesh_), std::move(warnings_));
    imported.entities["object"] = objects_;
    imported.skipped = skipped_.toValue();
    return imported;
  }

  Package& package_;
  const Progress& progress_;
  Mesh mesh_;
  Counter skipped_;
  std::vector<std::string> warnings_;
  std::size_t placed_ = 0, objects_ = 0, flat_ = 0;
};

}  // namespace

Imported readThreeMf(const std::filesystem::path& path, const Progress& progress) {
  Package package(readFile(path), progress);
  return Builder(package, progress).build();
}

}  // namespace blossom
