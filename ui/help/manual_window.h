#pragma once
#include <QWidget>
#include <memory>

#include "ui/help/manual_pages.h"

class QLineEdit;
class QListWidget;
class QStackedWidget;
class QToolButton;

namespace blossom::ui {

class ManualContents;
class ManualText;

/// The manual in a separate window: pages and headings on the left, text on the right, and a search in everything.
class ManualWindow : public QWidget {
  Q_OBJECT
 public:
  explicit ManualWindow(QWidget* workbench);
  ~ManualWindow() override;

  void setPages(std::unique_ptr<ManualPages>);
  /// Shows the window with this page.
  void open(const QString& page, const QString& anchor = {});
  [[nodiscard]] ManualText& text() { return *text_; }
  [[nodiscard]] QLineEdit& searchField() { return *search_; }
  [[nodiscard]] QListWidget& hits() { return *hits_; }

 protected:
  void keyPressEvent(QKeyEvent*) override;
  bool eventFilter(QObject*, QEvent*) override;

 private:
  QWidget* buildSide();
  QWidget* buildMain();
  QToolButton* button(const QString& icon, const QString& help, const QKeySequence&);
  void find(const QString& words);
  void openHit();

  std::unique_ptr<ManualPages> pages_;
  QLineEdit* search_;
  QStackedWidget* left_;
  ManualContents* contents_;
  QListWidget* hits_;
  ManualText* text_;
};

}  // namespace blossom::ui
