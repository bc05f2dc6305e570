#pragma once
#include <QElapsedTimer>
#include <QScrollArea>
#include <QTimer>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <vector>

#include "document/document.h"
#include "feature/feature_type.h"
#include "ui/fields/marked_parts.h"
#include "ui/panel/panel_picking.h"
#include "ui/panel/sequence_time.h"

class QLabel;
class QVBoxLayout;

namespace blossom::ui {

class FeatureHeader;
class InputEditor;
class ParameterField;
class ResultTable;
class Session;
struct FieldContext;

/// Inputs, parameters and result of the selected feature: a form made from the declaration, and the measures. During a drag
/// at most one evaluation runs, and the newest value waits for it.
class PropertyPanel : public QScrollArea {
  Q_OBJECT
 public:
  explicit PropertyPanel(Session&, QWidget* parent = nullptr);
  ~PropertyPanel() override;
  /// Shows a feature; an empty id shows that nothing is selected.
  void show(const FeatureId&);
  [[nodiscard]] const FeatureId& shown() const { return shown_; }
  [[nodiscard]] ParameterField* field(const QString& parameter) const;
  [[nodiscard]] InputEditor* input(const QString& name) const;

  /// What is wanted from the view now.
  [[nodiscard]] const std::optional<PickRequest>& wanted() const { return picking_.wanted(); }
  /// Something was picked in the view. Does nothing while nothing is wanted.
  void offerPick(const Pick& pick) { picking_.offer(pick); }
  /// The view does not pick any more (Esc, another tool).
  void endPick() { picking_.end(); }
  /// The current place of the timeline. The t of a feature that makes a sequence is the time of the frame that is seen.
  void setTimeline(int frame, int frames);
  /// @param setKey as that of FieldContext
  void setKeying(std::function<bool()> setKey);

 signals:
  void hint(const QString&);
  /// Asks the view to pick until pickEnded; picks are passed to offerPick.
  void pickWanted(const blossom::ui::PickRequest&);
  void pickEnded();
  /// Parts to be marked in the view until the next signal.
  void partsMarked(const blossom::ui::MarkedParts&);
  /// Asks the timeline to go to a frame, because the t of a feature that makes a sequence was changed.
  void frameWanted(int frame);
  void manualWanted(const QString& page);

 private:
  void leave();
  void buildColumn();
  void rebuild();
  void muteEditors();
  void addFeature(const Feature&);
  void addInputs();
  void addParameters();
  void connectField(ParameterField*);
  void refreshContext();
  void provideParts();
  void forgetParts();
  void refreshLost();
  void mark(MarkedParts);
  void refreshFields();
  void refreshField(ParameterField&, const Value& given);
  void showOrHide(ParameterField&);
  void refreshResult();
  void followViews(const std::set<FeatureId>&);
  void showFault();
  [[nodiscard]] ParameterField* faultyField(const QString& message) const;
  void showNotice(const std::vector<std::string>& warnings);
  void preview(ParameterField*, const Value&);
  void sendPreview();
  void sendWhole(Document);
  void lookForQuick();
  void endPreviews();
  void commit(ParameterField*, const Value&);
  void takeFiles(ParameterField*, const Document&);
  [[nodiscard]] bool refreshTime(ParameterField&);
  void refreshTimes();
  [[nodiscard]] bool wantTime(ParameterField&, const Value& time, bool preview = false);
  void revert();
  void rename(const QString&);
  void wantPick(ParameterField*, InputEditor*, PickRequest);
  [[nodiscard]] Feature changed(const std::string& parameter, const Value&) const;
  void tellWhatGaveWay(const ParameterSpec& set, const Value& before);

  Session& session_;
  FeatureId shown_;
  std::string shownType_;
  std::shared_ptr<const FeatureType> type_;
  std::shared_ptr<FieldContext> context_;
  std::vector<ParameterField*> fields_;
  std::map<const ParameterField*, QString> unshowable_;  ///< of those that show the default: what is wrong with the value
  std::vector<InputEditor*> inputs_;
  FeatureHeader* header_ = nullptr;
  QWidget* form_ = nullptr;        // what is made anew for each feature
  QVBoxLayout* column_ = nullptr;  // of the form
  QWidget* resultTitle_ = nullptr;
  ResultTable* result_;
  FeatureId told_;         // whose result is in it
  bool heldBack_ = false;  // something of the result was not told during a preview

  ParameterField* previewed_ = nullptr;               // the field that is dragged
  std::optional<Value> waiting_;                      // its newest value, not yet sent off
  QElapsedTimer sent_;                                // since the last whole document
  bool sentWhole_ = false;                            // its results are awaited
  bool isQuick_ = false;                              // what was sent last is a quick preview
  FeatureId quick_;                                   // of the features previewed quickly, the last, whose result is awaited
  std::shared_ptr<const FeatureResult> beforeQuick_;  // its result when that was sent
  bool isSlow_ = false;                               // they took long
  QTimer rest_;                                       // after which the whole follows a quick preview that has come
  QLabel* notice_ = nullptr;                          // the first warning of the result
  ParameterField* faulty_ = nullptr;                  // the field that the evaluation complains of
  QString fault_;

  SequenceTime time_;
  PanelPicking picking_;
  MarkedParts marked_;
};

}  // namespace blossom::ui
