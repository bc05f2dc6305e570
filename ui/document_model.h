#pragma once
#include <QAbstractListModel>
#include <vector>

#include "document/document.h"

namespace blossom::ui {

class Session;

/// The features of the session's document, one row each, with what the tree shows of them.
class DocumentModel : public QAbstractListModel {
  Q_OBJECT
 public:
  enum Role { IdRole = Qt::UserRole, StateRole, FailedRole, IconRole, VisibleRole, PendingRole, WarnedRole };

  explicit DocumentModel(Session&, QObject* parent = nullptr);
  int rowCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex&, int role) const override;
  bool setData(const QModelIndex&, const QVariant&, int role) override;  ///< renames
  Qt::ItemFlags flags(const QModelIndex&) const override;

  [[nodiscard]] FeatureId idAt(const QModelIndex&) const;
  [[nodiscard]] QModelIndex indexOf(const FeatureId&) const;
  void refresh();  ///< the document changed

 private:
  [[nodiscard]] QString stateOf(const Feature&) const;
  [[nodiscard]] QString iconOf(const Feature&) const;
  Session& session_;
  std::vector<std::shared_ptr<const Feature>> rows_;
};

}  // namespace blossom::ui
