#pragma once
#include <vtkSmartPointer.h>

#include <algorithm>
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
/// Tools are declared in ui/plugin/tool.h.
#define BLOSSOM_MANIPULATORS(registry)                                                                                  \
  extern "C" __attribute__((visibility("default"))) std::uint32_t blossomManipulatorLayout() {                          \
    return ::blossom::ui::manipulatorLayout;                                                                            \
  }                                                                                                                     \
  extern "C" __attribute__((visibility("default"))) int blossomManipulatorApi() { return ::blossom::pluginApiVersion; } \
  extern "C" __attribute__((visibility("default"))) void blossomRegisterManipulators(                                   \
      ::blossom::ui::ManipulatorRegistry& registry)

namespace blossom::ui {

/// Data for the overlay of a selected feature: control polygons, frames, handles on top of its shape. What an overlay
/// returns is made anew each time: the view keeps it and may change what it holds.
struct OverlayContext {
  const Feature& feature;
  const std::vector<Shape>& inputs;  ///< results of the feature's inputs, in order
  const Shape& result;
  const Look& look;
  const Value& stats;     ///< of the result's computation
  double pixelRatio = 1;  ///< device pixels per pixel
};
using Overlay = std::function<std::vector<vtkSmartPointer<vtkProp>>(const OverlayContext&)>;

class Tool;
class ToolHost;

/// Makes a tool for one feature, or, with an empty id, for a new feature.
using MakeTool = std::function<std::unique_ptr<Tool>(ToolHost&, const FeatureId&)>;

/// A tool that creates features of a type by drawing them, and edits existing ones.
struct ToolSpec {
  std::string id;       ///< "modeling.draw": the command of the window
  std::string title;    ///< "Draw outline"
  std::string summary;  ///< one sentence
  std::string icon;     ///< name of a file in resources/icons
  std::string featureType;
  MakeTool make;
};

class ManipulatorRegistry {
 public:
  void addOverlay(std::string featureType, Overlay overlay) { overlays_[std::move(featureType)] = std::move(overlay); }
  [[nodiscard]] const Overlay* overlay(const std::string& featureType) const {
    const auto it = overlays_.find(featureType);
    return it == overlays_.end() ? nullptr : &it->second;
  }
  void addTool(ToolSpec tool) { tools_.push_back(std::move(tool)); }
  [[nodiscard]] const std::vector<ToolSpec>& tools() const { return tools_; }
  /// The tool that creates and edits features of a type; nullptr when there is none.
  [[nodiscard]] const ToolSpec* toolFor(const std::string& featureType) const {
    const auto suits = [&](const ToolSpec& tool) { return tool.featureType == featureType; };
    const auto it = std::find_if(tools_.begin(), tools_.end(), suits);
    return it == tools_.end() ? nullptr : &*it;
  }

  /// Adds handles: a tool that is active while a feature of that type is selected. It must accept only events on its
  /// handles.
  void addHandles(std::string featureType, MakeTool make) { handles_[std::move(featureType)] = std::move(make); }
  [[nodiscard]] const MakeTool* handles(const std::string& featureType) const {
    const auto it = handles_.find(featureType);
    return it == handles_.end() ? nullptr : &it->second;
  }

  /// Adds everything of another registry.
  void add(const ManipulatorRegistry& other) {
    for (const auto& [type, made] : other.overlays_) overlays_[type] = made;
    for (const auto& [type, made] : other.handles_) handles_[type] = made;
    tools_.insert(tools_.end(), other.tools_.begin(), other.tools_.end());
  }

 private:
  std::map<std::string, Overlay> overlays_;
  std::map<std::string, MakeTool> handles_;
  std::vector<ToolSpec> tools_;
};

/// Like pluginLayout, with the types that the window and a manipulator module exchange in addition.
inline constexpr std::uint32_t manipulatorLayout =
    pluginLayout ^ layoutNumber<ManipulatorRegistry, OverlayContext, ToolSpec, Feature, Look>();

}  // namespace blossom::ui
