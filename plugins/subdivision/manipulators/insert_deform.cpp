#include "manipulators/insert_deform.h"

#include "document/edits.h"
#include "geometry/mesh/mesh.h"
#include "pulls.h"
#include "ui/look/registry_text.h"

namespace blossom::subdivision {
namespace {

constexpr const char* deformType = "subdivision.deform";
constexpr const char* subdivideType = "subdivision.subdivide";

bool isCage(const ui::ToolHost& host, const FeatureId& id) {
  const auto result = host.result(id);
  if (!result || result->error) return false;
  const ShapeKind kind = result->evaluated.shape.kind();
  return kind == ShapeKind::Mesh || kind == ShapeKind::Curve || kind == ShapeKind::Curves || kind == ShapeKind::Region;
}

Value parameter(const ui::ToolHost& host, const Feature& feature, const char* name) {
  return completed(host.registry().at(feature.type)->parameters, feature.parameters).at(name);
}

/// Whether its result is a cage that can be deformed further.
bool producesCage(const ui::ToolHost& host, const Feature& feature) {
  return feature.type == deformType && parameter(host, feature, "as") == "cage";
}

void takeDeform(const ui::ToolHost& host, const FeatureId& id, DeformPlace& place) {
  const Feature& feature = host.document().at(id);
  if (producesCage(host, feature) && feature.inputs.size() == 1) {
    place.existing = id;
    place.base = feature.inputs.front();
  } else {
    place.base = id;
  }
  if (feature.type == deformType) place.scheme = parameter(host, feature, "scheme");
}

Feature fresh(const ui::ToolHost& host, const Document& document, const char* type) {
  return ui::namedFeature(document, *host.registry().at(type));
}

/// How often a cage is refined for its smooth surface to be drawn at every movement of the mouse, even without a graphics
/// card.
int levelsFor(const ui::ToolHost& host, const FeatureId& cage) {
  constexpr std::size_t maximumFaces = 50'000;
  const auto result = host.result(cage);
  const Mesh* mesh = result ? result->evaluated.shape.get<Mesh>() : nullptr;
  int levels = mesh ? 1 : 3;
  if (mesh)
    for (std::size_t faces = 16 * mesh->faceCount(); levels < 3 && faces <= maximumFaces; faces *= 4) ++levels;
  return levels;
}

Document hidden(const Document& document, const FeatureId& id) {
  Feature feature = document.at(id);
  if (!feature.visible) return document;
  feature.visible = false;
  return document.with(std::move(feature));
}

}  // namespace

std::optional<DeformPlace> deformPlace(const ui::ToolHost& host, const FeatureId& selected) {
  const Document& document = host.document();
  if (selected.empty() || !document.contains(selected)) return std::nullopt;
  const Feature& feature = document.at(selected);
  DeformPlace place;
  place.scheme = "catmull-clark";
  if (feature.type == subdivideType && feature.inputs.size() == 1) {
    place.smooth = selected;
    takeDeform(host, feature.inputs.front(), place);
    place.scheme = parameter(host, feature, "scheme");
  } else if (feature.type == deformType && !producesCage(host, feature)) {
    return std::nullopt;  // its result is no cage any more
  } else {
    takeDeform(host, selected, place);
    for (const FeatureId& user : document.usersOf(selected))
      if (document.at(user).type == subdivideType) place.smooth = user;
  }
  if (!isCage(host, place.base)) return std::nullopt;
  return place;
}

Document withDeform(const ui::ToolHost& host, Document document, const DeformPlace& place, const Value& parameters,
                    const std::vector<FeatureId>& targets, FeatureId& id) {
  const bool changed = !place.existing.empty();
  Feature deform = changed ? document.at(place.existing) : fresh(host, document, deformType);
  for (const auto& [name, value] : parameters.items()) deform.parameters[name] = value;
  if (!changed) {
    deform.parameters["scheme"] = place.scheme;
    deform.inputs = {place.base};
    deform.inputs.insert(deform.inputs.end(), targets.begin(), targets.end());
  }
  deform.visible = false;
  id = deform.id;
  document = hidden(document, place.base).with(std::move(deform));
  Feature smooth = place.smooth.empty() ? fresh(host, document, subdivideType) : document.at(place.smooth);
  if (place.smooth.empty()) {
    smooth.name = freeName(document, ui::registryText("Smooth").toStdString());
    smooth.parameters = {{"scheme", place.scheme}, {"levels", levelsFor(host, place.base)}, {"as", "limit"}};
  }
  smooth.inputs = {id};
  return document.with(std::move(smooth));
}

Document withPulls(const ui::ToolHost& host, const DeformPlace& place, const std::vector<Pull>& pulls) {
  Value records = Value::array();
  for (const Pull& pull : pulls) records.push_back(recordOf(pull));
  FeatureId id;
  return withDeform(host, host.document(), place, {{"pulls", records}}, {}, id);
}

}  // namespace blossom::subdivision
