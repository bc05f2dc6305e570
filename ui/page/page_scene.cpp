#include "ui/page/page_scene.h"

#include <vtkProp.h>

#include <algorithm>
#include <set>

#include "scene/onion_skin.h"

namespace blossom::ui {

std::shared_ptr<const FeatureView> PageScene::shownView(const Feature& feature) const {
  return feature.visible && !feature.suppressed ? session_.view(feature.id) : nullptr;
}

SceneData PageScene::sceneNow(const FeatureView& view) const {
  if (!view.frames) return view.scene;
  return view.frames->at(static_cast<std::size_t>(playback_.frameOf(static_cast<int>(view.frames->size()))));
}

std::vector<ViewItem> PageScene::items(const std::vector<FeatureId>& selected) const {
  const Document& document = session_.document();
  const std::set<FeatureId> made(selected.begin(), selected.end());
  std::set<FeatureId> controls;
  for (const FeatureId& id : selected)
    if (document.contains(id)) controls.insert(document.at(id).inputs.begin(), document.at(id).inputs.end());
  std::vector<ViewItem> items;
  for (const auto& feature : document.features()) {
    const auto view = shownView(*feature);
    if (!view || view->scene.empty()) continue;
    const ItemRole role = made.contains(feature->id)       ? ItemRole::Made
                          : controls.contains(feature->id) ? ItemRole::Control
                                                           : ItemRole::Plain;
    items.push_back({feature->id, sceneNow(*view), role, session_.outdated(feature->id)});
  }
  return items;
}

std::size_t PageScene::frames() const {
  std::size_t count = 0;
  for (const auto& feature : session_.document().features())
    if (const auto view = shownView(*feature); view && view->frames) count = std::max(count, view->frames->size());
  return count;
}

PageScene::Props PageScene::skins(const Look& look, double pixelRatio) const {
  Props all;
  if (!playback_.onionSkin()) return all;
  for (const auto& feature : session_.document().features()) {
    const auto view = shownView(*feature);
    if (!view || !view->frames) continue;
    const auto skins = onionSkin(*view->frames, look, pixelRatio);
    all.insert(all.end(), skins.begin(), skins.end());
  }
  return all;
}

PageScene::Props PageScene::overlayOf(const FeatureId& id, const Look& look) const {
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
  return (*overlay)({feature, inputs, view->result->evaluated.shape, look});
}

}  // namespace blossom::ui
