// Closing documents and the main window without losing what is unsaved.
#include <QCloseEvent>
#include <QMessageBox>
#include <algorithm>

#include "ui/files/unsaved_dialog.h"
#include "ui/window/main_window.h"

namespace blossom::ui {

void MainWindow::guarded(DocumentPage& page, std::function<void()> go) {
  if (!page.session().modified()) return go();
  QMessageBox question(this);
  question.setIcon(QMessageBox::NoIcon);
  question.setText(tr("Save the changes of %1?").arg(page.session().title()));
  question.setInformativeText(tr("Without saving, they are lost."));
  question.setStandardButtons(QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel);
  question.setDefaultButton(QMessageBox::Save);
  const int answer = question.exec();
  if (answer == QMessageBox::Save)
    save(page, std::move(go));
  else if (answer == QMessageBox::Discard)
    go();
}

// One after the other, since each may have to be asked for a name; the first that is not saved ends it.
void MainWindow::saveInTurn(std::vector<DocumentPage*> pages, std::function<void()> then) {
  if (pages.empty()) return then();
  DocumentPage* const first = pages.front();
  pages.erase(pages.begin());
  showPage(indexOf(*first));
  save(*first, [this, pages = std::move(pages), then = std::move(then)] { saveInTurn(pages, then); });
}

void MainWindow::guardedAll(const std::vector<DocumentPage*>& pages, std::function<void()> go) {
  std::vector<DocumentPage*> modified;
  for (DocumentPage* each : pages)
    if (each->session().modified()) modified.push_back(each);
  if (modified.empty()) return go();
  if (modified.size() == 1) {
    showPage(indexOf(*modified.front()));  // the question is about what is seen
    return guarded(*modified.front(), std::move(go));
  }
  QStringList titles;
  for (const DocumentPage* each : modified) titles << each->session().title();
  UnsavedDialog question(titles, this);
  question.exec();
  if (question.answer() == UnsavedDialog::Answer::Cancel) return;
  std::vector<DocumentPage*> chosen;
  if (question.answer() == UnsavedDialog::Answer::Save)
    for (const std::size_t place : question.chosen()) chosen.push_back(modified[place]);
  saveInTurn(std::move(chosen), std::move(go));
}

void MainWindow::closePage(std::size_t index) {
  if (index >= pages_.size()) return;
  DocumentPage* const closing = pages_[index].get();
  guardedAll({closing}, [this, closing] { removePage(indexOf(*closing)); });
}

void MainWindow::closeOthers(std::size_t index) {
  if (index >= pages_.size()) return;
  DocumentPage* const kept = pages_[index].get();
  std::vector<DocumentPage*> others;
  for (const auto& each : pages_)
    if (each.get() != kept) others.push_back(each.get());
  guardedAll(others, [this, others, kept] {
    for (const DocumentPage* each : others) removePage(indexOf(*each));
    showPage(indexOf(*kept));
  });
}

void MainWindow::closeEvent(QCloseEvent* event) {
  if (closing_) return event->accept();
  std::vector<DocumentPage*> all;
  all.reserve(pages_.size());
  for (const auto& each : pages_) all.push_back(each.get());
  const bool modified = std::any_of(all.begin(), all.end(), [](const auto* each) { return each->session().modified(); });
  if (!modified) return event->accept();
  // Saving ends later, when this event is long forgotten.
  event->ignore();
  guardedAll(all, [this] {
    closing_ = true;
    QMetaObject::invokeMethod(this, &QWidget::close, Qt::QueuedConnection);
  });
}

}  // namespace blossom::ui
