#pragma once
#include <QAbstractListModel>
#include <map>
#include <memory>
#include <set>
#include <vector>

#include "document/document.h"

namespace blossom::ui {

class Session;

/// The features of the session's document, one row each, with the data shown in the tree.
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
    WarnedRole
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
  void refresh();  ///< the document changed

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
    bool pending = false, failed = false, warned = false;
    bool operator==(const Shown&) const = default;
  };
  [[nodiscard]] bool failed(const Feature&) const;
  [[nodiscard]] bool warned(const Feature&) const;
  [[nodiscard]] bool pending(const Feature&) const;
  void refreshState();
  void refreshRows(const std::set<FeatureId>&);
  [[nodiscard]] bool renew(std::size_t row);
  void tell(const std::vector<int>& rows);
  void removeGone();
  void reorder();

  Session& session_;
  std::vector<std::shared_ptr<const Feature>> rows_;
  std::map<FeatureId, Shown> shown_;
};

}  // namespace blossom::ui
