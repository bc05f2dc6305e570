#include "ui/window/document_closing.h"

#include <QMessageBox>
#include <QPointer>
#include <algorithm>
#include <utility>

#include "ui/files/unsaved_dialog.h"
#include "ui/page/page.h"
#include "ui/window/document_files.h"
#include "ui/window/open_documents.h"

namespace blossom::ui {

namespace {

QString listedName(const Session& session) {
  if (session.fromSample()) return DocumentClosing::tr("%1 (sample, untitled)").arg(session.title());
  const bool named = !session.suggestedName().isEmpty() && session.title() != Session::tr("Untitled");
  if (session.file().empty() && named) return DocumentClosing::tr("%1 (untitled)").arg(session.title());
  return session.title();
}

}  // namespace

DocumentClosing::DocumentClosing(OpenDocuments& documents, DocumentFiles& files, QWidget* window)
    : QObject(window), documents_(documents), files_(files), window_(window) {}

bool DocumentClosing::isOpen(const DocumentPage& page) const { return documents_.indexOf(page) < documents_.count(); }

void DocumentClosing::show(const DocumentPage& page) { documents_.show(documents_.indexOf(page)); }

void DocumentClosing::guarded(DocumentPage& page, const AfterQuestion& go) {
  if (!page.session().modified()) return go({});
  QMessageBox question(window_);
  question.setIcon(QMessageBox::NoIcon);
  question.setText(tr("Save the changes of %1?").arg(page.session().title()));
  question.setInformativeText(tr("Without saving, they are lost."));
  question.setStandardButtons(QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel);
  question.setDefaultButton(QMessageBox::Save);
  const int answer = question.exec();
  if (answer == QMessageBox::Save)
    files_.save(page, [go] { go({}); });
  else if (answer == QMessageBox::Discard)
    go({{&page, page.session().edits()}});
}

// One after the other, since each may have to be asked for a name; the first that is not saved ends it.
void DocumentClosing::saveInTurn(std::vector<DocumentPage*> pages, std::function<void()> then) {
  std::erase_if(pages, [this](const DocumentPage* each) { return !isOpen(*each); });  // closed meanwhile
  if (pages.empty()) return then();
  DocumentPage* const first = pages.front();
  pages.erase(pages.begin());
  show(*first);
  files_.save(*first, [this, pages = std::move(pages), then = std::move(then)] { saveInTurn(pages, then); });
}

// What was tried out on a sample is seldom meant to stay; it is saved only when asked for.
std::vector<UnsavedDocument> DocumentClosing::unsaved(const std::vector<DocumentPage*>& pages) const {
  std::vector<UnsavedDocument> all;
  std::map<QString, int> count;
  for (const DocumentPage* each : pages) {
    all.push_back({listedName(each->session()), !each->session().fromSample()});
    ++count[all.back().name];
  }
  for (std::size_t i = 0; i < all.size(); ++i)
    if (count[all[i].name] > 1) all[i].name = tr("%1, tab %2").arg(all[i].name).arg(documents_.indexOf(*pages[i]) + 1);
  return all;
}

void DocumentClosing::guardedAll(const std::vector<DocumentPage*>& pages, const AfterQuestion& go) {
  std::vector<DocumentPage*> modified;
  for (DocumentPage* each : pages)
    if (each->session().modified()) modified.push_back(each);
  if (modified.empty()) return go({});
  if (modified.size() == 1) {
    show(*modified.front());  // the question is about what is seen
    return guarded(*modified.front(), go);
  }
  UnsavedDialog question(unsaved(modified), window_);
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

void DocumentClosing::close(std::size_t index) {
  if (index >= documents_.count()) return;
  files_.takeTyping();
  DocumentPage* const closing = &documents_.at(index);
  if (waitsForWriting({closing}, [this, closing] { close(documents_.indexOf(*closing)); })) return;
  guardedAll({closing}, [this, closing](const Discarded&) { documents_.remove(documents_.indexOf(*closing)); });
}

void DocumentClosing::closeOthers(std::size_t index) {
  if (index >= documents_.count()) return;
  files_.takeTyping();
  DocumentPage* const kept = &documents_.at(index);
  std::vector<DocumentPage*> others = documents_.all();
  std::erase(others, kept);
  if (waitsForWriting(others, [this, kept] { closeOthers(documents_.indexOf(*kept)); })) return;
  guardedAll(others, [this, others, kept](const Discarded&) {
    for (const DocumentPage* each : others) documents_.remove(documents_.indexOf(*each));
    if (isOpen(*kept)) show(*kept);
  });
}

// Nothing that is being written is cut off: what was wanted goes on when it is there, and not when it failed.
bool DocumentClosing::waitsForWriting(const std::vector<DocumentPage*>& pages, const std::function<void()>& then) {
  const auto writing = std::find_if(pages.begin(), pages.end(), [](const auto* each) { return each->session().writing(); });
  if (writing == pages.end()) return false;
  emit announced(tr("%1 is still being written; it is closed then.").arg((*writing)->session().title()));
  const QPointer<Job> job = &(*writing)->session().job();
  const auto goOn = [job, then] {
    if (job && !job->lastError()) then();
  };
  connect(job, &Job::finished, this, goOn, static_cast<Qt::ConnectionType>(Qt::QueuedConnection | Qt::SingleShotConnection));
  return true;
}

// Saving ends later, when the event that closes the window is long forgotten.
bool DocumentClosing::mayCloseAll() {
  files_.takeTyping();
  const std::vector<DocumentPage*> all = documents_.all();
  // An answer holds as long as nobody edits that document again: saving the others may have taken its time.
  const Discarded discarded = std::exchange(discarded_, {});
  const auto undecided = [&](const DocumentPage* each) {
    const auto answer = discarded.find(each);
    return each->session().modified() && (answer == discarded.end() || answer->second != each->session().edits());
  };
  if (waitsForWriting(all, [this] { window_->close(); })) return false;
  if (std::none_of(all.begin(), all.end(), undecided)) {
    for (DocumentPage* each : all) each->session().abandon();
    return true;
  }
  guardedAll(all, [this](const Discarded& now) {
    discarded_ = now;
    QMetaObject::invokeMethod(window_, &QWidget::close, Qt::QueuedConnection);
  });
  return false;
}

}  // namespace blossom::ui
