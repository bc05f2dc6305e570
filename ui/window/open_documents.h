#pragma once
#include <QObject>
#include <memory>
#include <vector>

#include "app/app.h"

class QStackedWidget;
class QWidget;

namespace blossom::ui {

class DocumentPage;
class DocumentTabs;
class ManipulatorRegistry;
class StartPage;

/// The documents that are open, each a page with a side and a canvas, and the tabs that choose among them. There always is
/// one; the start page lies over an empty one.
class OpenDocuments : public QObject {
  Q_OBJECT
 public:
  OpenDocuments(App, const ManipulatorRegistry&, QObject* parent = nullptr);
  ~OpenDocuments() override;
  void begin();  ///< with an empty document under the start page
  void end();    ///< nothing is shown and told any more

  // For the layout of the window, which owns them then.
  [[nodiscard]] DocumentTabs* tabs() { return tabs_; }
  [[nodiscard]] QStackedWidget* sides() { return sides_; }
  [[nodiscard]] QStackedWidget* canvases() { return canvases_; }

  [[nodiscard]] DocumentPage& shown() const { return *pages_.at(current_); }
  [[nodiscard]] std::size_t current() const { return current_; }
  [[nodiscard]] std::size_t count() const { return pages_.size(); }
  [[nodiscard]] DocumentPage& at(std::size_t index) const { return *pages_.at(index); }
  [[nodiscard]] std::vector<DocumentPage*> all() const;
  [[nodiscard]] std::size_t indexOf(const DocumentPage&) const;  ///< count() when it is closed

  DocumentPage& add();          ///< an empty document in a new tab, which is shown
  DocumentPage& placeToOpen();  ///< the one that is shown while it is untouched, else a new one
  void show(std::size_t index);
  void remove(std::size_t index);  ///< without a question; the last one becomes an empty document
  void startNew();
  void showStartPage();
  void refreshStart();

 signals:
  void added(blossom::ui::DocumentPage*);
  void removing(blossom::ui::DocumentPage*);
  void shownChanged();
  // What the user wants of tabs and start page.
  void closeWanted(std::size_t index);
  void closeOthersWanted(std::size_t index);
  void saveWanted(blossom::ui::DocumentPage*);
  void openWanted();
  void importWanted();
  void fileChosen(const QString& file);

 private:
  void connectTabs();
  void refreshTabs();
  [[nodiscard]] bool has(int index) const { return index >= 0 && static_cast<std::size_t>(index) < pages_.size(); }

  App app_;
  const ManipulatorRegistry& manipulators_;
  DocumentTabs* tabs_;
  QStackedWidget *sides_, *canvases_;
  StartPage* start_;
  std::vector<std::unique_ptr<DocumentPage>> pages_;
  std::size_t current_ = 0;
  DocumentPage* startFor_ = nullptr;  // the page that the start page lies over while it is untouched
};

}  // namespace blossom::ui
