#pragma once
#include <QWidget>

class QLineEdit;
class QToolButton;

namespace blossom::ui {

class DocumentTree;

/// The document tree under its heading, with a search field that is shown on request.
class DocumentTreePanel : public QWidget {
  Q_OBJECT
 public:
  explicit DocumentTreePanel(DocumentTree*, QWidget* parent = nullptr);
  void startSearch();
  void endSearch();
  [[nodiscard]] QLineEdit* searchField() { return search_; }

 protected:
  bool eventFilter(QObject*, QEvent*) override;

 private:
  QWidget* heading();
  DocumentTree* tree_;
  QLineEdit* search_;
  QToolButton* open_;
};

}  // namespace blossom::ui
