#pragma once
#include <QListView>
#include <map>
#include <vector>

#include "core/error.h"
#include "document/document.h"
#include "ui/panel/error_bar.h"

namespace blossom::ui {

class DocumentModel;
class Session;

/// The document as a list: icon, name, one line of state, and an eye that hides; beneath each result, folded, the steps that
/// have gone into it. The selection is shared with the view. Every change is one step of undo; impossible ones are refused
/// with a message.
class DocumentTree : public QListView {
  Q_OBJECT
 public:
  explicit DocumentTree(Session&, QWidget* parent = nullptr);
  [[nodiscard]] Session& session() { return session_; }
  [[nodiscard]] std::vector<FeatureId> selected() const;  ///< in document order; `current()` is the current one
  /// As they were selected by hand, one after the other; in document order where one was not selected by hand, as a new
  /// feature is.
  [[nodiscard]] std::vector<FeatureId> selectedInTurn() const;
  [[nodiscard]] FeatureId current() const;
  void select(const FeatureId&, bool extend = false);  ///< empty id: nothing
  void selectThese(const std::vector<FeatureId>&);
  void selectAdded(const FeatureId&);  ///< not by hand
  void selectLast();                   ///< in document order
  void selectFirstShown();
  void selectAll() override;  ///< what the filter shows
  /// Shows only rows whose name, type or state contains all words of the text.
  void setFilter(const QString& text);

  void renameCurrent();
  void toggleSelected();
  void toggleVisible(const FeatureId&);
  void showAll();
  /// Shows only the selection; called again, restores the previous visibility.
  void isolateSelected();
  void setFolded(const FeatureId&, bool);  ///< the steps that have gone into it
  void toggleSuppressed();                 ///< toggles the first selected feature, and sets all others to the same state
  void removeSelected();
  void stepSelected(int by);                 ///< one place up (-1) or down (+1)
  void moveSelectedBefore(std::size_t row);  ///< row == number of rows: to the end
  void copySelected() const;
  void cutSelected();
  void paste();
  void duplicateSelected();

 signals:
  void selectionChangedTo();
  void hint(const QString&);
  void refused(const blossom::Error&, const std::vector<blossom::ui::Offer>&);
  void contextMenuWanted(const QPoint& global);

 protected:
  void mousePressEvent(QMouseEvent*) override;
  void mouseMoveEvent(QMouseEvent*) override;
  void leaveEvent(QEvent*) override;
  void keyPressEvent(QKeyEvent*) override;
  void contextMenuEvent(QContextMenuEvent*) override;
  void dragMoveEvent(QDragMoveEvent*) override;
  void dropEvent(QDropEvent*) override;
  void selectionChanged(const QItemSelection&, const QItemSelection&) override;

 private:
  template <class Make>
  bool attempt(const QString& what, const Make&);
  [[nodiscard]] QString nameOf(const FeatureId&) const;
  [[nodiscard]] QString titled(const std::vector<FeatureId>&, const QString& one, const QString& several) const;
  [[nodiscard]] std::size_t rowAt(QPoint) const;
  void refuseRemoval(const std::vector<FeatureId>& ids, const std::vector<FeatureId>& users);
  void remove(const std::vector<FeatureId>&);
  void removeAlone(const std::vector<FeatureId>&);
  /// The document where what was made of them is made of what they were made from, or of what else it takes.
  [[nodiscard]] std::optional<Document> withoutAlone(const std::vector<FeatureId>&) const;
  void suppress(const std::vector<FeatureId>&, bool);
  void addCopies(const Document& clip, const std::vector<FeatureId>& wanted, const QString& one, const QString& several);
  void applyFilter();
  void applyFilter(int first, int last);
  [[nodiscard]] bool passesFilter(const QModelIndex&) const;
  [[nodiscard]] std::vector<FeatureId> withSteps(const std::vector<FeatureId>&) const;
  [[nodiscard]] std::size_t placeOf(const FeatureId&) const;
  [[nodiscard]] std::size_t placeBefore(std::size_t row) const;

  Session& session_;
  DocumentModel* model_;
  QStringList filter_;
  std::map<FeatureId, bool> beforeIsolation_;
  std::vector<FeatureId> turn_;  ///< of what is selected that which was selected by hand, first to last
  bool byHand_ = true;           ///< what is being selected
};

}  // namespace blossom::ui
