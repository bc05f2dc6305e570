// Closing documents and the main window without losing what is unsaved.
#include <QCloseEvent>
#include <QMessageBox>
#include <QPointer>
#include <algorithm>
#include <map>

#include "ui/files/unsaved_dialog.h"
#include "ui/window/main_window.h"
#include "ui/window/status_line.h"

namespace blossom::ui {

namespace {

QString listedName(const Session& session) {
  if (session.fromSample()) return MainWindow::tr("%1 (sample, untitled)").arg(session.title());
  if (session.file().empty() && !session.suggestedName().isEmpty())
    return MainWindow::tr("%1 (untitled)").arg(session.title());
  return session.title();
}

}  // namespace

void MainWindow::guarded(DocumentPage& page, const AfterQuestion& go) {
  if (!page.session().modified()) return go({});
  QMessageBox question(this);
  question.setIcon(QMessageBox::NoIcon);
  question.setText(tr("Save the changes of %1?").arg(page.session().title()));
  question.setInformativeText(tr("Without saving, they are lost."));
  question.setStandardButtons(QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel);
  question.setDefaultButton(QMessageBox::Save);
  const int answer = question.exec();
  if (answer == QMessageBox::Save)
    save(page, [go] { go({}); });
  else if (answer == QMessageBox::Discard)
    go({{&page, page.session().edits()}});
}

// One after the other, since each may have to be asked for a name; the first that is not saved ends it.
void MainWindow::saveInTurn(std::vector<DocumentPage*> pages, std::function<void()> then) {
  std::erase_if(pages, [this](const DocumentPage* each) { return indexOf(*each) == pages_.size(); });  // closed meanwhile
  if (pages.empty()) return then();
  DocumentPage* const first = pages.front();
  pages.erase(pages.begin());
  showPage(indexOf(*first));
  save(*first, [this, pages = std::move(pages), then = std::move(then)] { saveInTurn(pages, then); });
}

// What was tried out on a sample is seldom meant to stay; it is saved only when asked for.
std::vector<UnsavedDocument> MainWindow::unsaved(const std::vector<DocumentPage*>& pages) const {
  std::vector<UnsavedDocument> all;
  std::map<QString, int> count;
  for (const DocumentPage* each : pages) {
    all.push_back({listedName(each->session()), !each->session().fromSample()});
    ++count[all.back().name];
  }
  for (std::size_t i = 0; i < all.size(); ++i)
    if (count[all[i].name] > 1) all[i].name = tr("%1, tab %2").arg(all[i].name).arg(indexOf(*pages[i]) + 1);
  return all;
}

void MainWindow::guardedAll(const std::vector<DocumentPage*>& pages, const AfterQuestion& go) {
  std::vector<DocumentPage*> modified;
  for (DocumentPage* each : pages)
    if (each->session().modified()) modified.push_back(each);
  if (modified.empty()) return go({});
  if (modified.size() == 1) {
    showPage(indexOf(*modified.front()));  // the question is about what is seen
    return guarded(*modified.front(), go);
  }
  UnsavedDialog question(unsaved(modified), this);
  question.exec();
  if (question.answer() == UnsavedDialog::Answer::Cancel) return;
  std::vector<DocumentPage*> chosen;
  if (question.answer() == UnsavedDialog::Answer::Save)
    for (const std::size_t place : question.chosen()) chosen.push_back(modified[place]);
  Discarded discarded;
  for (const DocumentPage* each : modified)
    if (std::find(chosen.begin(), chosen.end(), each) == chosen.end()) discarded[each] = each->session().edits();
  saveInTurn(std::move(chosen), [go, discarded] { go(discarded); });
}

void MainWindow::closePage(std::size_t index) {
  if (index >= pages_.size()) return;
  takeTyping();
  DocumentPage* const closing = pages_[index].get();
  if (waitsForWriting({closing}, [this, closing] { closePage(indexOf(*closing)); })) return;
  guardedAll({closing}, [this, closing](const Discarded&) { removePage(indexOf(*closing)); });
}

void MainWindow::closeOthers(std::size_t index) {
  if (index >= pages_.size()) return;
  takeTyping();
  DocumentPage* const kept = pages_[index].get();
  std::vector<DocumentPage*> others;
  for (const auto& each : pages_)
    if (each.get() != kept) others.push_back(each.get());
  if (waitsForWriting(others, [this, kept] { closeOthers(indexOf(*kept)); })) return;
  guardedAll(others, [this, others, kept](const Discarded&) {
    for (const DocumentPage* each : others) removePage(indexOf(*each));
    if (indexOf(*kept) < pages_.size()) showPage(indexOf(*kept));
  });
}

// Nothing that is being written is cut off: what was wanted goes on when it is there, and not when it failed.
bool MainWindow::waitsForWriting(const std::vector<DocumentPage*>& pages, const std::function<void()>& then) {
  const auto writing = std::find_if(pages.begin(), pages.end(), [](const auto* each) { return each->session().writing(); });
  if (writing == pages.end()) return false;
  status_->announce(tr("%1 is still being written; it is closed then.").arg((*writing)->session().title()));
  const QPointer<Job> job = &(*writing)->session().job();
  const auto goOn = [job, then] {
    if (job && !job->lastError()) then();
  };
  connect(job, &Job::finished, this, goOn, static_cast<Qt::ConnectionType>(Qt::QueuedConnection | Qt::SingleShotConnection));
  return true;
}

void MainWindow::closeEvent(QCloseEvent* event) {
  takeTyping();
  std::vector<DocumentPage*> all;
  all.reserve(pages_.size());
  for (const auto& each : pages_) all.push_back(each.get());
  // An answer holds as long as nobody edits that document again: saving the others may have taken its time.
  const Discarded discarded = std::exchange(discarded_, {});
  const auto undecided = [&](const DocumentPage* each) {
    const auto answer = discarded.find(each);
    return each->session().modified() && (answer == discarded.end() || answer->second != each->session().edits());
  };
  if (waitsForWriting(all, [this] { close(); })) return event->ignore();
  if (std::none_of(all.begin(), all.end(), undecided)) {
    for (DocumentPage* each : all) each->session().abandon();
    return event->accept();
  }
  // Saving ends later, when this event is long forgotten.
  event->ignore();
  guardedAll(all, [this](const Discarded& now) {
    discarded_ = now;
    QMetaObject::invokeMethod(this, &QWidget::close, Qt::QueuedConnection);
  });
}

}  // namespace blossom::ui
