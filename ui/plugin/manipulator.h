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

/// What a selected feature shows on top of its shape: control polygons, frames, handles.
struct OverlayContext {
  const Feature& feature;
  const std::vector<Shape>& inputs;  ///< results of the feature's inputs, in order
  const Shape& result;
  const Look& look;
};
using Overlay = std::function<std::vector<vtkSmartPointer<vtkProp>>(const OverlayContext&)>;

class Tool;
class ToolHost;

/// Makes a tool for one feature; with an empty id, for one that is still to be made.
using MakeTool = std::function<std::unique_ptr<Tool>(ToolHost&, const FeatureId&)>;

/// A tool that creates features of a type by drawing them, and edits those that there are.
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

  /// Handles: a tool that is active while a feature of that type is selected. It takes only what happens on its handles.
  void addHandles(std::string featureType, MakeTool make) { handles_[std::move(featureType)] = std::move(make); }
  [[nodiscard]] const MakeTool* handles(const std::string& featureType) const {
    const auto it = handles_.find(featureType);
    return it == handles_.end() ? nullptr : &it->second;
  }

  /// Takes over everything of another registry.
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

/// See pluginLayout: what the window and a manipulator module hand to one another, on top of that.
inline constexpr std::uint32_t manipulatorLayout =
    pluginLayout ^ layoutNumber<ManipulatorRegistry, OverlayContext, ToolSpec, Feature, Look>();

}  // namespace blossom::ui
