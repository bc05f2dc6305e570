#pragma once
#include <QAbstractListModel>
#include <map>
#include <memory>
#include <set>
#include <vector>

#include "document/document.h"
#include "ui/tree/nested_rows.h"

namespace blossom::ui {

class Session;

/// The features of the session's document, one row each, with the data shown in the tree, in the order of nestedRows.
class DocumentModel : public QAbstractListModel {
  Q_OBJECT
 public:
  enum Role {
    IdRole = Qt::UserRole,
    StateRole,   ///< one line: kind and main measure, the error, "suppressed" or "computing…"
    RemedyRole,  ///< what to do about the error; empty when there is none
    TypeRole,    ///< title of the feature type
    FailedRole,
    IconRole,
    VisibleRole,
    SuppressedRole,
    PendingRole,
    WarnedRole,  ///< itself, or a step that is folded away under it
    DepthRole,   ///< of a step, how far it is indented
    StepsRole,   ///< rows of its own steps follow
    FoldedRole   ///< which are not shown
  };

  explicit DocumentModel(Session&, QObject* parent = nullptr);
  int rowCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex&, int role) const override;
  bool setData(const QModelIndex&, const QVariant&, int role) override;  ///< renames
  Qt::ItemFlags flags(const QModelIndex&) const override;
  QStringList mimeTypes() const override;
  QMimeData* mimeData(const QModelIndexList&) const override;  ///< the rows, for dropping them elsewhere in the document
  Qt::DropActions supportedDropActions() const override { return Qt::MoveAction; }

  [[nodiscard]] FeatureId idAt(const QModelIndex&) const;
  [[nodiscard]] QModelIndex indexOf(const FeatureId&) const;
  [[nodiscard]] FeatureId parentOf(const FeatureId&) const;              ///< the row that it is a step of; empty: none
  [[nodiscard]] std::vector<FeatureId> stepsOf(const FeatureId&) const;  ///< all that have gone into it
  void refresh();                                                        ///< the document changed
  /// Shows the steps of a feature, or folds them away.
  void setFolded(const FeatureId&, bool);
  /// Shows a step with all that it is a step of.
  void unfoldTo(const FeatureId&);
  [[nodiscard]] bool isFoldedAway(const FeatureId& id) const { return foldedAway_.contains(id); }

 signals:
  void foldsChanged();

 private:
  [[nodiscard]] const Feature& at(const QModelIndex&) const;
  [[nodiscard]] bool computing(const Feature&) const;
  [[nodiscard]] QString stateOf(const Feature&) const;
  [[nodiscard]] QString remedyOf(const Feature&) const;
  [[nodiscard]] QString tipOf(const Feature&) const;
  [[nodiscard]] QString typeOf(const Feature&) const;
  [[nodiscard]] QString iconOf(const Feature&) const;
  /// What the row of a feature shows beside what is read off the document.
  struct Shown {
    std::shared_ptr<const Feature> feature;
    QString state, remedy, icon;
    bool pending = false, failed = false, warned = false, steps = false;
    int depth = 0;
    bool operator==(const Shown&) const = default;
  };
  [[nodiscard]] bool failed(const Feature&) const;
  [[nodiscard]] bool warned(const Feature&) const;
  /// Whether a step that is folded away under it fails or warns.
  [[nodiscard]] bool hidesTrouble(const Feature&) const;
  [[nodiscard]] std::set<FeatureId> rowsAboveTrouble() const;
  [[nodiscard]] QString ownStateOf(const Feature&) const;
  [[nodiscard]] bool pending(const Feature&) const;
  void refreshState();
  void refreshRows(const std::set<FeatureId>&);
  [[nodiscard]] bool renew(std::size_t row);
  void tell(const std::vector<int>& rows);
  void removeGone(const std::vector<NestedRow>& wanted);
  void reorder(const std::vector<NestedRow>& wanted);
  [[nodiscard]] std::vector<NestedRow> wantedRows() const;
  void renewFolds();

  Session& session_;
  std::vector<NestedRow> rows_;
  std::map<FeatureId, Shown> shown_;
  std::set<FeatureId> unfolded_, foldedAway_;
  std::set<FeatureId> aboveTrouble_;  ///< rows with a step that fails or warns, however deep
};

}  // namespace blossom::ui
