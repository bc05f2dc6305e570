#include "ui/page/page_scene.h"

#include <vtkPolyData.h>
#include <vtkProp.h>

#include <algorithm>
#include <set>

#include "document/shown.h"
#include "geometry/shape/frame_times.h"
#include "scene/onion_skin.h"

namespace blossom::ui {

namespace {

void addCornersOf(const SceneData& scene, std::vector<Vec3>& corners) {
  for (vtkPolyData* data : {scene.faces.Get(), scene.edges.Get(), scene.points.Get()}) {
    if (!data || data->GetNumberOfPoints() == 0) continue;
    const double* b = data->GetBounds();
    for (int corner = 0; corner < 8; ++corner)
      corners.emplace_back(b[corner & 1], b[2 + ((corner >> 1) & 1)], b[4 + ((corner >> 2) & 1)]);
  }
}

}  // namespace

std::shared_ptr<const FeatureView> PageScene::shownView(const Feature& feature) const {
  if (choice_ && choice_->parts && choice_->features.contains(feature.id)) return session_.view(feature.id);
  return feature.visible && !feature.suppressed ? session_.view(feature.id) : nullptr;
}

SceneData PageScene::sceneNow(const FeatureView& view) const {
  if (!view.frames) return view.scene;
  return view.frames->at(static_cast<std::size_t>(playback_.frameOf(static_cast<int>(view.frames->size()))));
}

const Shape& PageScene::shapeNow(const FeatureView& view) const {
  const auto* const sequence = view.frames ? view.shape.get<Sequence>() : nullptr;
  if (!sequence) return view.shape;
  return sequence->frames.at(static_cast<std::size_t>(playback_.frameOf(static_cast<int>(view.frames->size()))));
}

/// The parts that the features of a document play while some are selected.
struct PageScene::Parts {
  std::set<FeatureId> selected, inputs, usedUp, controls;
  std::set<FeatureId> back;     ///< what has gone into the selected ones
  std::set<FeatureId> results;  ///< what the selected ones have gone into
};

PageScene::Parts PageScene::partsOf(const std::vector<FeatureId>& selected) const {
  const Document& document = session_.document();
  const auto shapeOf = [this](const FeatureId& id) { return session_.shape(id); };
  const Registry& registry = *session_.app().registry;
  Parts parts;
  parts.selected.insert(selected.begin(), selected.end());
  parts.usedUp = usedUpNow();
  for (const auto& feature : document.features()) {
    const InputsByUse inputs = inputsByUse(*feature, registry, shapeOf);
    if (feature->visible) parts.controls.insert(inputs.controls.begin(), inputs.controls.end());
    const bool isSelected = parts.selected.contains(feature->id);
    if (isSelected) {
      parts.inputs.insert(feature->inputs.begin(), feature->inputs.end());
      parts.back.insert(inputs.consumed.begin(), inputs.consumed.end());
    }
    // Users come after what they use: those of a selected one that is used up, and theirs.
    const bool follows = std::any_of(inputs.consumed.begin(), inputs.consumed.end(), [&](const FeatureId& id) {
      return parts.selected.contains(id) || parts.results.contains(id);
    });
    if (follows && !isSelected) parts.results.insert(feature->id);
  }
  return parts;
}

std::optional<Presence> PageScene::presenceOf(const FeatureId& id, const Parts& parts) const {
  const bool selected = parts.selected.contains(id);
  if (choice_ && choice_->features.contains(id)) return Presence::Whole;
  if (choice_ && choice_->parts && (selected || parts.results.contains(id))) return std::nullopt;
  if (choice_ && !choice_->parts) return parts.usedUp.contains(id) ? std::nullopt : std::optional(Presence::SteppedBack);
  if (!selected && (parts.back.contains(id) || (parts.results.contains(id) && !parts.usedUp.contains(id))))
    return Presence::SteppedBack;
  if (!selected && parts.usedUp.contains(id)) return std::nullopt;
  if (session_.outdated(id) && !session_.standsIn(id)) return Presence::Outdated;
  if (session_.view(id)->result->error) return Presence::Failed;
  return !selected && parts.controls.contains(id) ? Presence::Beneath : Presence::Whole;
}

ItemRole PageScene::roleOf(const FeatureId& id, const Parts& parts) const {
  if (choice_ && choice_->parts && choice_->features.contains(id)) return ItemRole::Plain;
  if (choice_ && !choice_->parts) return choice_->features.contains(id) ? ItemRole::Control : ItemRole::Plain;
  if (parts.selected.contains(id)) return ItemRole::Made;
  return parts.inputs.contains(id) || parts.controls.contains(id) ? ItemRole::Control : ItemRole::Plain;
}

std::vector<ViewItem> PageScene::items(const std::vector<FeatureId>& selected) const {
  const Parts parts = partsOf(selected);
  std::vector<ViewItem> items;
  for (const auto& feature : session_.document().features()) {
    const auto view = shownView(*feature);
    if (!view || view->scene.empty()) continue;
    const std::optional<Presence> presence = presenceOf(feature->id, parts);
    if (!presence) continue;
    const bool studied = studyOf_ && *presence != Presence::SteppedBack;
    items.push_back({feature->id, sceneNow(*view), roleOf(feature->id, parts), *presence,
                     studied ? studyOf_(shapeNow(*view)) : nullptr});
  }
  return items;
}

std::set<FeatureId> PageScene::usedUpNow() const {
  const auto shapeOf = [this](const FeatureId& id) { return session_.shape(id); };
  return usedUp(session_.document(), *session_.app().registry, shapeOf);
}

std::vector<std::shared_ptr<const FeatureView>> PageScene::sequences(const std::vector<FeatureId>& selected) const {
  std::set<FeatureId> used = usedUpNow();
  for (const FeatureId& id : selected) used.erase(id);
  std::vector<std::shared_ptr<const FeatureView>> found;
  for (const auto& feature : session_.document().features())
    if (const auto view = shownView(*feature); view && view->frames && !used.contains(feature->id)) found.push_back(view);
  return found;
}

std::vector<double> PageScene::beginnings(const std::vector<FeatureId>& selected) const {
  const Sequence* longest = nullptr;
  for (const auto& view : sequences(selected))
    if (const auto* sequence = view->shape.get<Sequence>(); !longest || sequence->frames.size() > longest->frames.size())
      longest = sequence;
  return longest ? frameBeginnings(*longest) : std::vector<double>();
}

std::vector<Vec3> PageScene::reach(const std::vector<FeatureId>& selected) const {
  constexpr std::size_t most = 48;  // of long sequences some, and the last
  std::vector<Vec3> corners;
  for (const auto& view : sequences(selected)) {
    const std::vector<SceneData>& all = *view->frames;
    for (std::size_t k = 0; k < std::min(most, all.size()); ++k)
      addCornersOf(all[(all.size() - 1) * k / std::max<std::size_t>(1, std::min(most, all.size()) - 1)], corners);
  }
  return corners;
}

PageScene::Props PageScene::skins(const std::vector<FeatureId>& selected, const Look& look, double pixelRatio) const {
  Props all;
  if (!playback_.onionSkin() && !skinsWanted_) return all;
  for (const auto& view : sequences(selected)) {
    const auto skins = onionSkin(*view->frames, look, pixelRatio);
    all.insert(all.end(), skins.begin(), skins.end());
  }
  return all;
}

PageScene::Props PageScene::overlayOf(const FeatureId& id, const Look& look, double pixelRatio) const {
  const auto view = session_.view(id);
  if (!session_.document().contains(id) || !view || view->result->error) return {};
  const Feature& feature = session_.document().at(id);
  const Overlay* overlay = feature.visible ? manipulators_.overlay(feature.type) : nullptr;
  if (!overlay) return {};
  std::vector<Shape> inputs;
  for (const FeatureId& input : feature.inputs) {
    const auto shown = session_.view(input);
    if (!shown) return {};
    inputs.push_back(shown->result->evaluated.shape);
  }
  const Evaluated& made = view->result->evaluated;
  return (*overlay)({feature, inputs, made.shape, look, made.stats, pixelRatio});
}

}  // namespace blossom::ui
