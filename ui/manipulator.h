#pragma once
#include <vtkSmartPointer.h>

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "core/version.h"
#include "document/evaluator.h"
#include "feature/plugin.h"
#include "scene/scene.h"

class vtkProp;

/// The manipulator half of a plugin exports these; write BLOSSOM_MANIPULATORS(registry) { registry.addOverlay(..); }.
#define BLOSSOM_MANIPULATORS(registry)                                                                                  \
  extern "C" __attribute__((visibility("default"))) int blossomManipulatorApi() { return ::blossom::pluginApiVersion; } \
  extern "C" __attribute__((visibility("default"))) void blossomRegisterManipulators(                                   \
      ::blossom::ui::ManipulatorRegistry& registry)

namespace blossom::ui {

/// What a selected feature shows on top of its shape: control polygons, frames, handles.
struct OverlayContext {
  const Feature& feature;
  const std::vector<Shape>& inputs;  ///< results of the feature's inputs, in order
  const Shape& result;
  const Look& look;
};
using Overlay = std::function<std::vector<vtkSmartPointer<vtkProp>>(const OverlayContext&)>;

class ManipulatorRegistry {
 public:
  void addOverlay(std::string featureType, Overlay overlay) { overlays_[std::move(featureType)] = std::move(overlay); }
  [[nodiscard]] const Overlay* overlay(const std::string& featureType) const {
    const auto it = overlays_.find(featureType);
    return it == overlays_.end() ? nullptr : &it->second;
  }
  /// Takes over everything of another registry.
  void add(const ManipulatorRegistry& other) {
    for (const auto& [type, made] : other.overlays_) overlays_[type] = made;
  }

 private:
  std::map<std::string, Overlay> overlays_;
};

}  // namespace blossom::ui
