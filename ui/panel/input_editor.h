#pragma once
#include <QWidget>
#include <optional>

#include "feature/feature_type.h"
#include "ui/fields/pick_request.h"
#include "ui/panel/input_slots.h"

class QGridLayout;
class QHBoxLayout;
class QLabel;
class QMenu;
class QToolButton;
class QVBoxLayout;

namespace blossom::ui {

class Session;
struct Pick;

/// The features of one input as chips, which can be replaced, added, removed and reordered, from a menu of suitable features
/// or by a pick in the view.
class InputEditor final : public QWidget {
  Q_OBJECT
 public:
  InputEditor(Session&, FeatureId, std::shared_ptr<const FeatureType>, std::size_t spec, QWidget* parent = nullptr);
  /// Call it after an edit of the document or a new result.
  void refresh();
  bool takePick(const Pick&);
  void pickEnded();
  /// Replaces the feature at `place`, or adds one when `place` is their number. Refusals are shown below.
  void take(std::size_t place, const FeatureId&);
  [[nodiscard]] QString problem() const;

 signals:
  void hint(const QString&);
  void pickWanted(blossom::ui::InputEditor*, const blossom::ui::PickRequest&);
  void pickUnwanted(blossom::ui::InputEditor*);

 protected:
  void enterEvent(QEnterEvent*) override;
  void resizeEvent(QResizeEvent*) override;

 private:
  [[nodiscard]] const InputSpec& input() const { return type_->inputs.at(spec_); }
  [[nodiscard]] std::optional<InputSlots> inputSlots() const;
  void rebuild(const std::vector<FeatureId>&);
  void placeLine();
  void addChip(const FeatureId&, std::size_t place, std::size_t count);
  void addCandidates(QMenu&, std::size_t place);
  void showChipMenu(std::size_t place, const QPoint& at);
  void showAddMenu();
  void commit(const std::vector<FeatureId>&);
  void wantPick(std::size_t place);
  void showProblem(const QString&);

  Session& session_;
  FeatureId feature_;
  std::shared_ptr<const FeatureType> type_;
  std::size_t spec_;
  std::size_t pickPlace_ = 0;
  QStringList shown_;  // ids and names of the chips
  QGridLayout* grid_;
  QHBoxLayout* line_ = nullptr;  // chip and buttons of an input that takes one feature
  int chipWidth_ = 0;            // of the widest one, with its whole name
  bool below_ = false;           // the line stands below the caption
  QVBoxLayout* chips_;
  QToolButton* add_;
  QToolButton* pick_;
  QLabel* problem_;
};

}  // namespace blossom::ui
