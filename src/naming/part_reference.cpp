#include "naming/part_reference.h"

#include <algorithm>

#include "naming/former_labels.h"
#include "naming/likeness.h"
#include "naming/namer.h"
#include "naming/source_part.h"

namespace blossom {

namespace {

Value toJson(const std::vector<FaceName>& names) {
  Value json = Value::array();
  for (const FaceName& name : names) json.push_back(name);
  return json;
}

std::vector<FaceName> namesFrom(const Value& json) {
  std::vector<FaceName> names;
  for (const Value& name : json) names.push_back(name.get<FaceName>());
  return names;
}

bool isKnown(const std::vector<FaceName>& names) {
  return !names.empty() && std::none_of(names.begin(), names.end(), [](const FaceName& name) { return name.empty(); });
}

/// The parts of sources whose labels occur in names.
Value describedSources(const std::vector<FaceName>& names,
                       const std::map<std::string, std::pair<SourcePart, Shape>>& labels) {
  Value sources = Value::object();
  for (const auto& [label, source] : labels) {
    const auto mentions = [&label = label](const FaceName& name) {
      return std::any_of(name.begin(), name.end(),
                         [&](const std::string& part) { return part.find(label) != std::string::npos; });
    };
    if (std::none_of(names.begin(), names.end(), mentions)) continue;
    const SourcePart& part = source.first;
    Value described = describedSourcePart(source.second, part.kind, part.index);
    described["feature"] = part.feature;
    described["kind"] = subShapeKindName(part.kind);
    sources[label] = std::move(described);
  }
  return sources;
}

std::optional<int> only(const std::vector<int>& numbers) {
  return numbers.size() == 1 ? std::optional(numbers.front()) : std::nullopt;
}

/// Whether one face came from all that the other came from, as a face that grew or lost a part of itself. What has got a
/// label of its own ("new") was not at the part before.
bool related(const FaceName& a, const FaceName& b) {
  if (a.empty() || b.empty()) return false;
  return std::includes(a.begin(), a.end(), b.begin(), b.end()) || std::includes(b.begin(), b.end(), a.begin(), a.end());
}

/// Whether each name of one list is related to one of the other, one to one as they stand or the other way round.
bool related(const std::vector<FaceName>& a, const std::vector<FaceName>& b) {
  if (a.size() != b.size()) return false;
  std::vector<std::size_t> order(b.size());
  for (std::size_t k = 0; k < order.size(); ++k) order[k] = k;
  do {
    bool all = true;
    for (std::size_t k = 0; all && k < a.size(); ++k) all = related(a[k], b[order[k]]);
    if (all) return true;
  } while (a.size() <= 4 && std::next_permutation(order.begin(), order.end()));
  return false;
}

/// Of several parts between the same faces, as the two straight edges of a slot: the one that is where it was, or, in a
/// shape of the same structure, the one with its number. Nothing when these are two.
std::optional<int> amongNamesakes(const std::vector<int>& same, const Shape& shape, SubShapeKind kind, int index,
                                  const Value& signature) {
  const Likeness likeness = likenessFrom(signature.at("likeness"));
  std::vector<int> alike;
  for (const int k : same)
    if (likenessOf(shape, kind, k).isLike(likeness, samePlace(shape))) alike.push_back(k);
  const bool numbered =
      signature.at("structure") == structureOf(shape) && std::find(same.begin(), same.end(), index) != same.end();
  if (alike.size() > 1) return std::nullopt;
  if (alike.empty()) return numbered ? std::optional(index) : std::nullopt;
  return numbered && alike.front() != index ? std::nullopt : std::optional(alike.front());
}

std::optional<int> foundByNames(const std::vector<std::vector<FaceName>>& all, const std::vector<FaceName>& wanted,
                                const Shape& shape, SubShapeKind kind, int index, const Value& signature) {
  std::vector<int> same;
  for (std::size_t k = 0; k < all.size(); ++k)
    if (all[k] == wanted) same.push_back(static_cast<int>(k));
  // The only one left of several may be another one.
  const auto namesakes = signature.value("namesakes", std::size_t{1});
  if (same.size() == 1 && namesakes == 1) return same.front();
  if (!same.empty()) return amongNamesakes(same, shape, kind, index, signature);
  if (namesakes > 1) return std::nullopt;
  for (std::size_t k = 0; k < all.size(); ++k)
    if (related(all[k], wanted)) same.push_back(static_cast<int>(k));
  return only(same);
}

/// At the ends of segments that were divided: only what lies exactly where it lay, between the same faces as before.
std::optional<int> foundWhereItLay(const std::vector<std::vector<FaceName>>& all, const std::vector<FaceName>& wanted,
                                   const Shape& shape, SubShapeKind kind, const Value& signature) {
  const Likeness likeness = likenessFrom(signature.at("likeness"));
  const double tolerance = samePlace(shape);
  std::vector<int> alike;
  std::size_t same = 0;
  for (std::size_t k = 0; k < all.size(); ++k) {
    if (all[k] != wanted) continue;
    ++same;
    const int number = static_cast<int>(k);
    if (likenessOf(shape, kind, number).isLike(likeness, tolerance)) alike.push_back(number);
  }
  return same == signature.value("namesakes", std::size_t{1}) ? only(alike) : std::nullopt;
}

}  // namespace

Value appearanceOf(const Shape& shape, SubShapeKind kind, int index) {
  Value appearance{{"likeness", toJson(likenessOf(shape, kind, index))}, {"structure", structureOf(shape)}};
  if (!shape.get<Brep>()) appearance["source"] = describedSourcePart(shape, kind, index);
  return appearance;
}

Value signatureOf(Construction& construction, const std::string& feature, SubShapeKind kind, int index,
                  const Progress& progress) {
  const Shape shape = construction.step(feature).result;
  Value signature = appearanceOf(shape, kind, index);
  const Brep* brep = shape.get<Brep>();
  if (!brep) return signature;
  std::map<std::string, std::pair<SourcePart, Shape>> labels;
  Namer namer(construction, [&](const SourcePart& part, const Shape& source) {
    std::string label = sourceLabel(part);
    labels.try_emplace(label, part, source);
    return label;
  });
  const auto all = facesAtAll(*brep, kind, namer.faces(feature, progress));
  const std::vector<FaceName>& names = all.at(static_cast<std::size_t>(index));
  if (!isKnown(names)) return signature;
  signature["faces"] = toJson(names);
  signature["namesakes"] = std::count(all.begin(), all.end(), names);
  signature["sources"] = describedSources(names, labels);
  return signature;
}

std::optional<int> foundPart(Construction& construction, const std::string& feature, SubShapeKind kind, int index,
                             const Value& signature, const Progress& progress) {
  const Shape shape = construction.step(feature).result;
  if (const auto source = signature.find("source"); source != signature.end()) return foundSourcePart(*source, shape, kind);
  const Brep* brep = shape.get<Brep>();
  if (!brep) return std::nullopt;
  if (!signature.contains("faces")) {
    Value described = signature;
    described["index"] = index;
    return foundSourcePart(described, shape, kind);
  }
  const std::vector<FaceName> wanted = namesFrom(signature.at("faces"));
  const auto namesNow = [&](FormerLabels& labels) {
    Namer namer(construction, [&](const SourcePart& part, const Shape& source) { return labels.of(part, source); });
    return facesAtAll(*brep, kind, namer.faces(feature, progress));
  };
  FormerLabels whole(signature.at("sources"), FormerLabels::Pieces::No);
  const auto found = foundByNames(namesNow(whole), wanted, shape, kind, index, signature);
  if (found || !whole.someAreGone()) return found;
  FormerLabels inPieces(signature.at("sources"), FormerLabels::Pieces::Yes);
  return foundWhereItLay(namesNow(inPieces), wanted, shape, kind, signature);
}

}  // namespace blossom
