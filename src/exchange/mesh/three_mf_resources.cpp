#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <optional>

#include "exchange/format/text.h"
#include "exchange/mesh/three_mf_rules.h"

namespace blossom::three_mf {
namespace {

using parse::shown;
using pugi::xml_node;

xml_node childOf(const xml_node& parent, std::string_view name) {
  for (const xml_node& child : parent.children())
    if (localName(child) == name) return child;
  return {};
}

std::vector<std::string_view> wordsOf(std::string_view text) {
  std::vector<std::string_view> words;
  while (!parse::trimmed(text).empty()) words.push_back(parse::takeWord(text));
  return words;
}

bool isColor(std::string_view text) {
  return (text.size() == 7 || text.size() == 9) && text.front() == '#' &&
         std::all_of(text.begin() + 1, text.end(), [](unsigned char c) { return std::isxdigit(c) != 0; });
}

/// A group of properties that triangles refer to by number.
struct PropertyGroup {
  std::string_view kind;
  std::size_t count = 0;
};

/// Goes through the resources in their order: what is referred to must come before.
class Resources {
 public:
  Resources(const PackageParts& parts, const Progress& progress, Faults& faults)
      : parts_(parts), progress_(progress), faults_(faults) {}

  void check(const xml_node& model) {
    for (const xml_node& each : childOf(model, "resources").children()) {
      if (each.type() != pugi::node_element) continue;
      checkId(each);
      resource(each);
    }
    for (const xml_node& item : childOf(model, "build").children()) buildItem(item);
  }

 private:
  void checkId(const xml_node& node) {
    const std::string_view id = attribute(node, "id");
    const auto number = parse::toInteger(id);
    if (id.empty())
      faults_.add(fmt::format("a resource ({}) has no id", shown(node.name())));
    else if (!number || *number <= 0)
      faults_.add(fmt::format("{} is not an id", shown(id)));
    else if (!ids_.insert(id).second)
      faults_.add(fmt::format("the id {} is given to two resources", shown(id)));
  }

  void resource(const xml_node& node) {
    const std::string_view kind = localName(node), id = attribute(node, "id");
    if (kind == "object") {
      object(node);
      objects_[id] = attribute(node, "type");
    } else if (kind == "texture2d") {
      texture(node);
      textures_.insert(id);
    } else if (kind == "basematerials" || kind == "colorgroup" || kind == "texture2dgroup" || kind == "compositematerials" ||
               kind == "multiproperties") {
      group(node, kind, id);
      groups_[id] = {kind, static_cast<std::size_t>(std::distance(node.begin(), node.end()))};
    }
  }

  void texture(const xml_node& node) {
    const std::string_view path = attribute(node, "path"), content = attribute(node, "contenttype");
    if (path.empty())
      faults_.add("a texture has no path");
    else if (!parts_.names.contains(partName(path)))
      faults_.add(fmt::format("the texture {} is missing", shown(path)));
    if (content != "image/png" && content != "image/jpeg")
      faults_.add(fmt::format("a texture has the content type {}", shown(content)));
  }

  void group(const xml_node& node, std::string_view kind, std::string_view id) {
    const std::string name = fmt::format("the group of properties {}", shown(id));
    if (kind == "basematerials" || kind == "colorgroup") {
      const char* color = kind == "colorgroup" ? "color" : "displaycolor";
      for (const xml_node& each : node.children())
        if (each.type() == pugi::node_element && !isColor(attribute(each, color)))
          return faults_.add(fmt::format("{} has the colour {}", name, shown(attribute(each, color))));
      for (const xml_node& each : node.children())
        if (kind == "basematerials" && attribute(each, "name").empty())
          return faults_.add(fmt::format("{} has a material without a name", name));
    }
    if (kind == "texture2dgroup" && !textures_.contains(attribute(node, "texid")))
      faults_.add(fmt::format("{} refers to the texture {}, which is missing", name, shown(attribute(node, "texid"))));
    if (kind == "compositematerials") composite(node, name);
    if (kind == "multiproperties") multiple(node, name);
  }

  void composite(const xml_node& node, const std::string& name) {
    const std::string_view materials = attribute(node, "matid");
    const auto found = groups_.find(materials);
    if (found == groups_.end() || found->second.kind != "basematerials")
      return faults_.add(fmt::format("{} mixes {}, which are no base materials", name, shown(materials)));
    const auto indices = wordsOf(attribute(node, "matindices"));
    if (indices.empty()) faults_.add(fmt::format("{} does not say which materials it mixes", name));
    for (const std::string_view index : indices) checkIndex(index, found->second, name);
  }

  void multiple(const xml_node& node, const std::string& name) {
    const auto layers = wordsOf(attribute(node, "pids"));
    if (layers.empty()) faults_.add(fmt::format("{} has no layers", name));
    std::size_t materials = 0, colors = 0;
    for (const std::string_view layer : layers) {
      const auto found = groups_.find(layer);
      const std::string_view kind = found == groups_.end() ? std::string_view() : found->second.kind;
      if (kind.empty() || kind == "multiproperties")
        faults_.add(fmt::format("{} refers to {}, which may not be one of its layers", name, shown(layer)));
      materials += kind == "basematerials" || kind == "compositematerials" ? 1 : 0;
      colors += kind == "colorgroup" ? 1 : 0;
    }
    if (materials > 1) faults_.add(fmt::format("{} has more than one layer of materials", name));
    if (colors > 1) faults_.add(fmt::format("{} has more than one layer of colours", name));
  }

  void checkIndex(std::string_view index, const PropertyGroup& group, const std::string& name) {
    const auto number = parse::toInteger(index);
    if (!number || *number < 0 || static_cast<std::size_t>(*number) >= group.count)
      faults_.add(fmt::format("{} refers to the property {}; there are {}", name, shown(index), group.count));
  }

  void object(const xml_node& node) {
    const std::string name = fmt::format("the object {}", shown(attribute(node, "id")));
    const std::string_view type = attribute(node, "type"), group = attribute(node, "pid"), index = attribute(node, "pindex");
    if (!type.empty() && type != "model" && type != "solidsupport" && type != "support" && type != "surface" &&
        type != "other")
      faults_.add(fmt::format("{} has the type {}", name, shown(type)));
    const xml_node mesh = childOf(node, "mesh"), components = childOf(node, "components");
    if (mesh && components) faults_.add(fmt::format("{} is a mesh and made of others", name));
    if (group.empty() && !index.empty()) faults_.add(fmt::format("{} has a property of no group", name));
    if (!group.empty() && mesh && index.empty()) faults_.add(fmt::format("{} does not say which property it has", name));
    if (const PropertyGroup* known = groupNamed(group, name); known && !index.empty()) checkIndex(index, *known, name);
    for (const xml_node& each : components.children()) component(each, name);
    for (const xml_node& each : childOf(mesh, "triangles").children()) triangle(each, group, name);
  }

  const PropertyGroup* groupNamed(std::string_view id, const std::string& user) {
    if (id.empty()) return nullptr;
    const auto found = groups_.find(id);
    if (found != groups_.end()) return &found->second;
    if (const std::string fault = fmt::format("{} refers to the properties {}, which are missing", user, shown(id));
        told_.insert(fault).second)
      faults_.add(fault);
    return nullptr;
  }

  void component(const xml_node& node, const std::string& user) {
    const std::string_view id = attribute(node, "objectid");
    if (attribute(node, "path").empty() && !objects_.contains(id))
      faults_.add(fmt::format("{} is made of the object {}, which does not come before it", user, shown(id)));
  }

  void triangle(const xml_node& node, std::string_view ofObject, const std::string& user) {
    if (++triangles_ % 8192 == 0) progress_.check();
    const std::string_view own = attribute(node, "pid"), p1 = attribute(node, "p1"), p2 = attribute(node, "p2"),
                           p3 = attribute(node, "p3");
    if (own.empty() && p1.empty() && p2.empty() && p3.empty()) return;
    std::string fault;
    if (own.empty() && ofObject.empty()) fault = fmt::format("triangles of {} have properties of no group", user);
    if (p1.empty() && (!p2.empty() || !p3.empty())) fault = fmt::format("triangles of {} have only some properties", user);
    if (!fault.empty() && told_.insert(fault).second) faults_.add(fault);
    const PropertyGroup* group = groupNamed(own.empty() ? ofObject : own, user);
    if (!group) return;
    for (const std::string_view index : {p1, p2, p3})
      if (!index.empty()) checkIndex(index, *group, user);
  }

  void buildItem(const xml_node& item) {
    const std::string_view id = attribute(item, "objectid");
    const auto found = objects_.find(id);
    if (found != objects_.end() && found->second == "other")
      faults_.add(fmt::format("the object {} of the type \"other\" is to be built", shown(id)));
  }

  const PackageParts& parts_;
  const Progress& progress_;
  Faults& faults_;
  std::set<std::string_view> ids_, textures_;
  std::map<std::string_view, std::string_view> objects_;  ///< types by id
  std::map<std::string_view, PropertyGroup> groups_;
  std::set<std::string> told_;
  std::size_t triangles_ = 0;
};

}  // namespace

void checkResources(const xml_node& model, const PackageParts& parts, const Progress& progress, Faults& faults) {
  Resources(parts, progress, faults).check(model);
}

}  // namespace blossom::three_mf
