#pragma once
#include <QObject>
#include <QPointer>
#include <functional>
#include <memory>
#include <utility>

#include "ui/page/first_look.h"
#include "ui/page/page_scene.h"
#include "ui/page/page_tools.h"
#include "ui/plugin/manipulator.h"
#include "ui/plugin/tool.h"
#include "ui/session/session.h"
#include "ui/session/surface_studies.h"
#include "ui/timeline/playback.h"
#include "ui/tools/measurements.h"

class QWidget;

namespace blossom::ui {

class DocumentTree;
class DocumentTreePanel;
class ErrorBar;
class FaultBar;
class OverlaidBars;
class PropertyPanel;
class TimelineBar;
class ViewWidget;

/// One open document in the window: its session, its side (tree and properties) and its canvas (what went wrong, and the
/// view). Also what a tool sees of the workbench.
class DocumentPage : public QObject, public ToolHost {
  Q_OBJECT
 public:
  DocumentPage(App app, const ManipulatorRegistry& manipulators, QObject* parent = nullptr);
  ~DocumentPage() override;

  [[nodiscard]] Session& session() { return session_; }
  [[nodiscard]] const Session& session() const { return session_; }
  [[nodiscard]] ViewWidget& view() { return *view_; }
  [[nodiscard]] DocumentTree& tree() { return *tree_; }
  [[nodiscard]] DocumentTreePanel& treePanel() { return *treePanel_; }
  [[nodiscard]] PropertyPanel& properties() { return *properties_; }
  [[nodiscard]] ErrorBar& errors() { return *errors_; }
  [[nodiscard]] FaultBar& faults() { return *faults_; }
  [[nodiscard]] OverlaidBars& notes() { return *notes_; }   ///< both, over the view
  [[nodiscard]] Playback& playback() { return playback_; }  ///< of the sequences that are shown
  [[nodiscard]] QWidget* side() { return side_; }           ///< owned by the page until a window takes it in
  [[nodiscard]] QWidget* canvas() { return canvas_; }       ///< likewise
  /// What the view shows, made anew.
  [[nodiscard]] std::vector<ViewItem> shownItems() const;
  /// Nothing in it, never saved, nothing under way: may be used for what is opened next.
  [[nodiscard]] bool untouched() const;

  /// The tool gets mouse and keys until it has finished; the one before is reverted.
  void start(std::unique_ptr<Tool> tool) { tools_->start(std::move(tool)); }
  /// Draws a new feature of a type, or edits one; false when the type has no tool of its own.
  bool startDrawing(const std::string& featureType, const FeatureId& edited = {}) {
    return tools_->startDrawing(featureType, edited);
  }
  [[nodiscard]] Tool* tool() const { return tools_->tool(); }
  [[nodiscard]] bool toolStarted() const { return tools_->started() != nullptr; }  ///< by the user; handles do not count
  void endTool() { tools_->end(); }
  /// Asks in the view for one of these features, which light up; Esc or another tool ends it without an answer.
  void choose(const QString& question, const std::vector<FeatureId>& features, std::function<void(const FeatureId&)> then);
  /// Ends such a question, or a drawing that is not finished, as another command begins; what is drawn stays.
  void endQuestion();
  /// Undo and redo of what the tool has begun, where it has steps of its own, else of the document.
  void undo();
  void redo();
  [[nodiscard]] std::string undoText() const;
  [[nodiscard]] std::string redoText() const;
  void startMeasuring();
  void startSection();
  [[nodiscard]] bool measuring() const;
  /// What was cancelled or failed before is tried again.
  void setDisplayMode(DisplayMode);
  /// What the display needs is being computed.
  [[nodiscard]] bool studying() const { return studies_.running(); }
  void cancelStudies() { studies_.cancel(); }
  /// They stay in the view until they are deleted.
  [[nodiscard]] Measurements& measurements() { return measurements_; }

  void showError(const Error&, const QString& file = {});

  // ToolHost
  [[nodiscard]] const Document& document() const override { return session_.document(); }
  [[nodiscard]] std::shared_ptr<const FeatureResult> result(const FeatureId&) const override;
  [[nodiscard]] const Registry& registry() const override { return *session_.app().registry; }
  [[nodiscard]] const Look& look() const override { return look_; }
  [[nodiscard]] double gridSpacing() const override;
  [[nodiscard]] LengthUnit lengthUnit() const override;
  [[nodiscard]] Value typed(const ParameterSpec&, const QString& text) const override;
  [[nodiscard]] std::vector<FeatureId> selection() const override;
  void select(const FeatureId&) override;
  [[nodiscard]] std::optional<CutPlane> section() const override;
  void setSection(const std::optional<CutPlane>&) override;
  [[nodiscard]] Bounds extent() const override;
  [[nodiscard]] std::optional<QPointF> onScreen(const Vec3&) const override;
  [[nodiscard]] double pixelRatio() const override;
  [[nodiscard]] QWidget* viewWidget() const override;
  [[nodiscard]] int shownFrame(int frames) const override { return playback_.frameOf(frames); }
  void showOtherFrames(bool on) override;
  void preview(Document document) override { session_.preview(std::move(document)); }
  void previewCoarsely(const Document& document, const Document& coarser) override { session_.preview(document, coarser); }
  void endPreview() override { session_.endPreview(); }
  void commit(Document document, const QString& what) override { session_.commit(std::move(document), what); }
  void commitCoarselyFirst(Document document, const QString& what, const Document& coarser) override {
    session_.commit(std::move(document), what, coarser);
  }

 signals:
  void hint(const QString&);
  void whereabouts(const QString&);
  void announced(const QString&);
  void selectionChanged();
  void stateChanged();  ///< document, file name, modified mark, work under way: whatever menus and tabs show
  void opened();        ///< a document of another file is shown
  void workChanged(const QString& key, const QString& what, double fraction);
  void workEnded(const QString& key);
  void salvageWanted(const QString& file);
  void manualWanted(const QString& page);
  void toolChanged();
  void contextMenuWanted(const QPoint& global);  ///< about what is selected

 private:
  void buildWidgets();
  void connectSession();
  void connectNotes();
  void connectStudies();
  [[nodiscard]] std::shared_ptr<const SurfaceStudy> studyOf(const Shape&);
  void connectWidgets();
  void followPreference(const QString& name);
  void refreshFrames();
  void refreshTimeline();
  [[nodiscard]] std::optional<Feature> offeredSequence() const;
  void makeSequence();

  // Keys of the timeline.
  struct KeyedSequence {
    FeatureId feature;
    std::string parameter;  ///< that holds the keys
    Value keys;
    int frames = 0;
  };
  [[nodiscard]] std::optional<KeyedSequence> keyedSequence() const;
  [[nodiscard]] Document withKeys(const KeyedSequence&, const Value& keys) const;
  void connectKeys();
  void refreshKeys();
  void moveKey(int key, int frame, bool placed);
  void setKey(int frame);
  bool setAnotherKey();
  void removeKey(int key);
  void removeKeyAt(int frame);

  void followViews(const std::set<FeatureId>&);
  [[nodiscard]] std::vector<vtkSmartPointer<vtkProp>> overlayNow();
  [[nodiscard]] std::vector<vtkSmartPointer<vtkProp>> overlayOfSelected();
  void showProperties();
  void selectLast();
  void lookAtFirstShapes();
  [[nodiscard]] bool showsSolid() const;
  void connectPicking();
  void showChoice(std::optional<PageScene::Choice>);

  const ManipulatorRegistry& manipulators_;
  Session session_;
  SurfaceStudies studies_;
  Look look_;
  Measurements measurements_{*this};
  DocumentTree* tree_;
  DocumentTreePanel* treePanel_;
  PropertyPanel* properties_;
  ViewWidget* view_;
  ErrorBar* errors_;
  FaultBar* faults_;  // features that fail
  OverlaidBars* notes_ = nullptr;
  Playback playback_;
  PageScene scene_{session_, playback_, manipulators_};
  TimelineBar* timeline_;
  QPointer<QWidget> side_, canvas_;
  std::unique_ptr<PageTools> tools_;
  FirstLook firstLook_;
  bool fillPanelLater_ = false;
};

}  // namespace blossom::ui
