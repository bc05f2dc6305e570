#pragma once
#include <vtkSmartPointer.h>

#include <functional>
#include <memory>
#include <optional>
#include <set>
#include <vector>

#include "ui/plugin/manipulator.h"
#include "ui/session/session.h"
#include "ui/timeline/playback.h"
#include "ui/view/items/view_items.h"

class vtkProp;

namespace blossom::ui {

/// What the view shows of a document: its visible features as far as they are computed, and what is drawn over them.
class PageScene {
 public:
  using Props = std::vector<vtkSmartPointer<vtkProp>>;

  /// Features among which one is chosen, or parts of which are picked, for the time.
  struct Choice {
    std::set<FeatureId> features;
    bool parts = false;  ///< of the inputs of what is selected, which is left out with its results
  };

  PageScene(const Session& session, const Playback& playback, const ManipulatorRegistry& manipulators)
      : session_(session), playback_(playback), manipulators_(manipulators) {}

  void choose(std::optional<Choice> choice) { choice_ = std::move(choice); }

  /// Gives what displays of surfaces need of a shape that is shown, or nullptr.
  using StudyOf = std::function<std::shared_ptr<const SurfaceStudy>(const Shape&)>;
  void setStudies(StudyOf studyOf) { studyOf_ = std::move(studyOf); }

  /// Sequences in the frame of the timeline; selected features and their inputs in colours of their own. What has gone into
  /// the result of another feature is left out, or steps back while that one is selected; when it is selected itself, its
  /// results step back.
  [[nodiscard]] std::vector<ViewItem> items(const std::vector<FeatureId>& selected) const;
  /// When each frame of the longest sequence that is shown begins, as frameBeginnings() tells it; empty: there is none.
  [[nodiscard]] std::vector<double> beginnings(const std::vector<FeatureId>& selected) const;
  /// Corners of the boxes around frames of the sequences that are shown, so that they stay in sight when they are played.
  [[nodiscard]] std::vector<Vec3> reach(const std::vector<FeatureId>& selected) const;
  void showSkins(bool on) { skinsWanted_ = on; }
  /// The other frames of sequences, faintly, when the timeline or a tool asks for them.
  [[nodiscard]] Props skins(const std::vector<FeatureId>& selected, const Look&, double pixelRatio) const;
  /// What the plugin draws over a feature with a result. @throws whatever the plugin throws.
  [[nodiscard]] Props overlayOf(const FeatureId&, const Look&, double pixelRatio) const;

 private:
  struct Parts;
  [[nodiscard]] Parts partsOf(const std::vector<FeatureId>& selected) const;
  [[nodiscard]] std::optional<Presence> presenceOf(const FeatureId&, const Parts&) const;
  [[nodiscard]] ItemRole roleOf(const FeatureId&, const Parts&) const;
  [[nodiscard]] std::shared_ptr<const FeatureView> shownView(const Feature&) const;
  [[nodiscard]] SceneData sceneNow(const FeatureView&) const;
  [[nodiscard]] const Shape& shapeNow(const FeatureView&) const;
  /// Features whose shapes have gone into the results of others.
  [[nodiscard]] std::set<FeatureId> usedUpNow() const;
  /// The visible sequences that are not used up, or selected.
  [[nodiscard]] std::vector<std::shared_ptr<const FeatureView>> sequences(const std::vector<FeatureId>& selected) const;

  std::optional<Choice> choice_;
  StudyOf studyOf_;
  bool skinsWanted_ = false;  ///< by a tool
  const Session& session_;
  const Playback& playback_;
  const ManipulatorRegistry& manipulators_;
};

}  // namespace blossom::ui
