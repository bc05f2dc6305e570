#pragma once
#include <QListView>
#include <vector>

#include "document/document.h"

namespace blossom::ui {

class DocumentModel;
class Session;

/// The document as a list: icon, name, one line of state, and an eye that hides. Selecting here selects in the view.
class DocumentTree : public QListView {
  Q_OBJECT
 public:
  explicit DocumentTree(Session&, QWidget* parent = nullptr);
  [[nodiscard]] std::vector<FeatureId> selected() const;  ///< in document order; the current one is `current()`
  [[nodiscard]] FeatureId current() const;
  void select(const FeatureId&, bool extend = false);  ///< empty id: nothing
  void selectLast();
  void renameCurrent();
  void toggleSelected();
  void toggleVisible(const FeatureId&);
  void removeSelected();

 signals:
  void selectionChangedTo();
  void hint(const QString&);

 protected:
  void mousePressEvent(QMouseEvent*) override;
  void mouseMoveEvent(QMouseEvent*) override;
  void leaveEvent(QEvent*) override;
  void keyPressEvent(QKeyEvent*) override;
  void contextMenuEvent(QContextMenuEvent*) override;
  void selectionChanged(const QItemSelection&, const QItemSelection&) override;

 private:
  Session& session_;
  DocumentModel* model_;
};

}  // namespace blossom::ui
