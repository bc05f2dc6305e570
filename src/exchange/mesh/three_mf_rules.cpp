#include "exchange/mesh/three_mf_rules.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "core/lower_case.h"
#include "exchange/format/text.h"

namespace blossom::three_mf {
namespace {

using parse::shown;
using pugi::xml_node;

constexpr std::size_t maximumReports = 8;
constexpr std::string_view modelContent = "application/vnd.ms-package.3dmanufacturing-3dmodel+xml";
constexpr std::string_view relationContent = "application/vnd.openxmlformats-package.relationships+xml";

/// "3d/3dmodel.model" -> "3d/_rels/3dmodel.model.rels"
std::string relationsOf(const std::string& part) {
  const std::size_t slash = part.rfind('/');
  const std::string folder = slash == std::string::npos ? "" : part.substr(0, slash + 1);
  return folder + "_rels/" + part.substr(folder.size()) + ".rels";
}

/// Targets may be relative to the folder of the part they belong to.
std::string targetPart(const std::string& source, std::string_view target) {
  if (target.starts_with('/')) return partName(target);
  const std::size_t slash = source.rfind('/');
  return partName((slash == std::string::npos ? "" : source.substr(0, slash + 1)) + std::string(target));
}

/// @param source the part that the relationships belong to; empty: the package
void checkRelations(const PackageParts& parts, const std::string& source, Faults& faults) {
  const auto text = parts.texts.find(source.empty() ? "_rels/.rels" : relationsOf(source));
  if (text == parts.texts.end()) return;
  pugi::xml_document document;
  if (!document.load_buffer(text->second.data(), text->second.size())) return;  // the reader reports it
  std::map<std::string, int> models, tickets;
  std::set<std::string_view> ids;
  for (const xml_node& each : document.document_element().children()) {
    const std::string_view type = attribute(each, "Type"), target = attribute(each, "Target");
    const bool outside = attribute(each, "TargetMode") == "External";
    if (!ids.insert(attribute(each, "Id")).second)
      faults.add(fmt::format("two relationships have the id {}", shown(attribute(each, "Id"))));
    if (outside && type.ends_with("/3dmodel")) faults.add("its model is said to lie outside the package");
    if (!outside && !parts.names.contains(targetPart(source, target)))
      faults.add(fmt::format("a relationship names the part {}, which is missing", shown(target)));
    if (type.ends_with("/3dmodel") && source.empty()) ++models["model"];
    if (type.ends_with("/printticket")) ++tickets["ticket"];
  }
  if (models["model"] > 1) faults.add("it names more than one model to begin with");
  if (tickets["ticket"] > 1) faults.add("a part has more than one print ticket");
}

/// The content type of a part; empty when the package declares none.
std::string contentTypeOf(const xml_node& types, const std::string& part) {
  const std::string extension = part.substr(part.rfind('.') + 1);
  std::string byExtension;
  for (const xml_node& each : types.children()) {
    if (localName(each) == "Override" && partName(attribute(each, "PartName")) == part)
      return std::string(attribute(each, "ContentType"));
    if (localName(each) == "Default" && lowerCase(attribute(each, "Extension")) == extension)
      byExtension = attribute(each, "ContentType");
  }
  return byExtension;
}

void checkContentTypes(const PackageParts& parts, const std::string& model, Faults& faults) {
  const auto text = parts.texts.find("[content_types].xml");
  if (text == parts.texts.end()) return faults.add("the list of content types is missing");
  pugi::xml_document document;
  if (!document.load_buffer(text->second.data(), text->second.size()))
    return faults.add("the list of content types is no XML");
  const xml_node types = document.document_element();
  for (const auto& [name, unused] : parts.texts) {
    if (name.starts_with('[')) continue;
    const std::string type = lowerCase(contentTypeOf(types, name));
    if (name.ends_with(".rels") ? type != relationContent : name == model && type != modelContent)
      faults.add(fmt::format("the part {} has the content type {}", shown(name), shown(type)));
  }
}

constexpr std::string_view coreSpace = "http://schemas.microsoft.com/3dmanufacturing/core/2015/02";
constexpr std::string_view instanceSpace = "http://www.w3.org/2001/XMLSchema-instance";

struct ElementRule {
  std::string_view name, attributes, children;  ///< as words between blanks
};

/// What the core specification defines.
constexpr std::array<ElementRule, 16> coreElements{
    {{"model", " unit requiredextensions recommendedextensions thumbnail ", " metadata resources build "},
     {"metadata", " name preserve type ", " "},
     {"metadatagroup", " ", " metadata "},
     {"resources", " ", " basematerials object "},
     {"basematerials", " id ", " base "},
     {"base", " name displaycolor ", " "},
     {"object", " id type thumbnail partnumber name pid pindex ", " metadatagroup mesh components "},
     {"mesh", " ", " vertices triangles "},
     {"vertices", " ", " vertex "},
     {"vertex", " x y z ", " "},
     {"triangles", " ", " triangle "},
     {"triangle", " v1 v2 v3 p1 p2 p3 pid ", " "},
     {"components", " ", " component "},
     {"component", " objectid transform ", " "},
     {"build", " ", " item "},
     {"item", " objectid transform partnumber ", " metadatagroup "}}};

bool holdsWord(std::string_view words, std::string_view word) {
  for (std::size_t at = words.find(word); at != std::string_view::npos && !word.empty(); at = words.find(word, at + 1))
    if (words[at - 1] == ' ' && words[at + word.size()] == ' ') return true;
  return false;
}

std::string_view prefixOf(std::string_view name) {
  const std::size_t colon = name.find(':');
  return colon == std::string_view::npos ? std::string_view() : name.substr(0, colon);
}

/// The namespace of a prefix in an element; empty when it is not declared.
std::string_view spaceOf(const xml_node& element, std::string_view prefix) {
  const std::string declaration = prefix.empty() ? "xmlns" : fmt::format("xmlns:{}", prefix);
  for (xml_node at = element; at; at = at.parent())
    if (const auto found = at.attribute(declaration.c_str())) return found.value();
  return {};
}

class Markup {
 public:
  Markup(const Progress& progress, Faults& faults) : progress_(progress), faults_(faults) {}

  void check(const xml_node& element, int depth = 0) {
    if (++count_ % 8192 == 0) progress_.check();
    if (depth > deepest) return once("its elements are nested too deeply");
    const std::string_view prefix = prefixOf(element.name());
    if (!prefix.empty() && knownSpace(element, prefix).empty())
      return once(fmt::format("the prefix of the element {} stands for no namespace", shown(element.name())));
    const bool core = isCore(element);
    const ElementRule* rule = core ? ruleOf(localName(element)) : nullptr;
    if (core && !rule) once(fmt::format("there is no element {} in 3MF", shown(element.name())));
    for (const pugi::xml_attribute& each : element.attributes()) checkAttribute(element, each.name(), rule);
    if (core && !rule) return;
    const bool before = coreByDefault_;
    if (declaresSpace(element)) coreByDefault_ = std::string_view(element.attribute("xmlns").value()) == coreSpace;
    for (const xml_node& child : element.children()) {
      if (child.type() != pugi::node_element) continue;
      if (rule && isCore(child) && !holdsWord(rule->children, localName(child)) && ruleOf(localName(child)))
        once(fmt::format("the element {} stands where it may not", shown(child.name())));
      check(child, depth + 1);
    }
    coreByDefault_ = before;
  }

 private:
  static constexpr int deepest = 64;

  static bool declaresSpace(const xml_node& element) { return !element.attribute("xmlns").empty(); }
  bool isCore(const xml_node& element) {
    const std::string_view prefix = prefixOf(element.name());
    if (!prefix.empty()) return knownSpace(element, prefix) == coreSpace;
    return declaresSpace(element) ? std::string_view(element.attribute("xmlns").value()) == coreSpace : coreByDefault_;
  }

  static const ElementRule* ruleOf(std::string_view name) {
    const auto found =
        std::find_if(coreElements.begin(), coreElements.end(), [&](const ElementRule& rule) { return rule.name == name; });
    return found == coreElements.end() ? nullptr : &*found;
  }

  /// Declarations mostly stand at the root: looked up once a prefix.
  std::string_view knownSpace(const xml_node& element, std::string_view prefix) {
    auto [found, fresh] = spaces_.try_emplace(std::string(prefix));
    if (fresh || found->second.empty()) found->second = spaceOf(element, prefix);
    return found->second;
  }

  void checkAttribute(const xml_node& element, std::string_view name, const ElementRule* rule) {
    const std::string_view prefix = prefixOf(name);
    if (name == "xmlns" || prefix == "xmlns") return;
    if (prefix == "xml") {
      if (name != "xml:lang") once(fmt::format("the attribute {} is not allowed", shown(name)));
    } else if (prefix.empty()) {
      if (rule && !holdsWord(rule->attributes, name))
        once(fmt::format("the element {} has no attribute {}", shown(element.name()), shown(name)));
    } else if (const std::string_view space = knownSpace(element, prefix); space.empty()) {
      once(fmt::format("the prefix of the attribute {} stands for no namespace", shown(name)));
    } else if (space == instanceSpace) {
      once(fmt::format("the attribute {} is not allowed", shown(name)));
    }
  }

  void once(const std::string& fault) {
    if (told_.size() < 1000 && told_.insert(fault).second) faults_.add(fault);
  }

  const Progress& progress_;
  Faults& faults_;
  std::size_t count_ = 0;
  bool coreByDefault_ = false;  ///< whether elements without a prefix are those of the core
  std::map<std::string, std::string, std::less<>> spaces_;
  std::set<std::string> told_;
};

void checkMetadata(const xml_node& model, Faults& faults) {
  constexpr std::string_view known =
      " Title Designer Description Copyright LicenseTerms Rating CreationDate ModificationDate Application ";
  std::set<std::string_view> names;
  for (const xml_node& each : model.children()) {
    if (localName(each) != "metadata") continue;
    const std::string_view name = each.attribute("name").value(), prefix = prefixOf(name);
    if (name.empty())
      faults.add("metadata have no name");
    else if (!names.insert(name).second)
      faults.add(fmt::format("the metadata {} are given twice", shown(name)));
    else if (prefix.empty() && !holdsWord(known, name))
      faults.add(fmt::format("the metadata {} are none of 3MF's and have no namespace", shown(name)));
    else if (!prefix.empty() && spaceOf(each, prefix).empty())
      faults.add(fmt::format("the prefix of the metadata {} stands for no namespace", shown(name)));
  }
}

}  // namespace

void Faults::add(std::string what) {
  if (told_.size() < maximumReports)
    told_.push_back(std::move(what));
  else
    ++more_;
}

std::vector<std::string> Faults::sentences() const {
  std::vector<std::string> all;
  for (const std::string& what : told_) all.push_back(fmt::format("The file breaks the rules of 3MF: {}.", what));
  if (more_ > 0) all.push_back(fmt::format("The file breaks the rules of 3MF in {} more places.", more_));
  return all;
}

std::string partName(std::string_view name) { return lowerCase(name.substr(name.starts_with('/') ? 1 : 0)); }

std::string_view localName(const xml_node& node) {
  const std::string_view name = node.name();
  return name.substr(name.find(':') + 1);
}

std::string_view attribute(const xml_node& node, std::string_view name) {
  for (const pugi::xml_attribute& each : node.attributes()) {
    const std::string_view full = each.name();
    if (full.substr(full.find(':') + 1) == name) return each.value();
  }
  return {};
}

void checkPackage(const PackageParts& parts, const std::string& model, Faults& faults) {
  checkRelations(parts, "", faults);
  checkRelations(parts, model, faults);
  checkContentTypes(parts, model, faults);
}

void checkText(std::string_view text, Faults& faults) {
  const std::string_view head = text.substr(0, std::min(text.find("<model"), std::min<std::size_t>(text.size(), 1 << 16)));
  if (head.find("<!DOCTYPE") != std::string_view::npos) faults.add("its XML defines a document type");
  const std::size_t declared = head.find("encoding=");
  if (declared == std::string_view::npos || declared + 10 > head.size()) return;
  const std::string_view rest = head.substr(declared + 10);
  const std::string encoding = lowerCase(rest.substr(0, rest.find(head[declared + 9])));
  if (encoding != "utf-8" && encoding != "utf-16") faults.add(fmt::format("its XML is encoded as {}", shown(encoding)));
}

void checkMarkup(const pugi::xml_document& document, const Progress& progress, Faults& faults) {
  const xml_node model = document.document_element();
  const auto isModel = [](const xml_node& each) { return localName(each) == "model"; };
  if (std::count_if(document.begin(), document.end(), isModel) > 1) faults.add("it holds more than one model");
  if (std::string_view(model.attribute("xmlns").value()) != coreSpace && prefixOf(model.name()).empty())
    faults.add(fmt::format("its model has the namespace {}", shown(model.attribute("xmlns").value())));
  const std::string_view space = spaceOf(model, prefixOf(model.name()));
  for (const std::string_view part : {"resources", "build"}) {
    const auto count = std::count_if(model.begin(), model.end(), [&](const xml_node& each) {
      return localName(each) == part && spaceOf(each, prefixOf(each.name())) == space;
    });
    if (count == 0) faults.add(fmt::format("its model has no {}", part));
    if (count > 1) faults.add(fmt::format("its model has {} times {}", count, part));
  }
  checkMetadata(model, faults);
  Markup(progress, faults).check(model);
}

}  // namespace blossom::three_mf
