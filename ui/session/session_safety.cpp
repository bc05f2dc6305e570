// The part of Session that loses nothing: safety copies of unsaved steps, what a crash left, and files that others write.
#include "ui/look/preferences.h"
#include "ui/look/text.h"
#include "ui/session/recovery.h"
#include "ui/session/session.h"

namespace blossom::ui {

namespace {

/// As it was when that step was made; another state, which nothing equals, when somebody has written it since.
FileStamp stampBefore(const std::filesystem::path& file, std::int64_t millisecondsOfStep) {
  using namespace std::chrono;
  const FileStamp now = FileStamp::of(file);
  if (!now.exists) return now;
  const auto changed = duration_cast<milliseconds>(file_clock::to_sys(now.time).time_since_epoch());
  return changed.count() > millisecondsOfStep ? FileStamp{} : now;
}

}  // namespace

QStringList toList(const std::vector<std::string>& sentences) {
  QStringList list;
  for (const std::string& sentence : sentences) list << qt(sentence);
  return list;
}

// Called after every step; without one that is unsaved there is nothing to keep.
void Session::keep(const QString& what) {
  if (!history_.modified()) return nothingToKeep();
  if (!journal_) {
    journal_ =
        Recovery::instance().newJournal([this](const Error& error) { here_.post([this, error] { emit unsafe(error); }); });
    if (!journal_) return;
  }
  autosave_.start(static_cast<int>(Preferences::instance().get<double>("autosave-minutes") * 60000));
  journal_->record(history_.committed(), what.toStdString(), {file_, title().toStdString()});
}

void Session::nothingToKeep() {
  autosave_.stop();
  if (journal_) journal_->clear();
  forgetLost();
}

void Session::abandon() { nothingToKeep(); }

void Session::forgetLost() {
  if (lostCopy_.empty()) return;
  Recovery::instance().discard(lostCopy_);
  lostCopy_.clear();
}

void Session::recover(const LostDocument& lost) {
  auto result = std::make_shared<OpenedDocument>();
  const std::uint64_t edits = edits_;
  begin(
      tr("Recovering %1").arg(qt(lost.summary.origin.name)),
      [result, folder = lost.folder](const Progress&) { *result = recoverDocument(folder); },
      [this, result, lost, edits] {
        const JournalOrigin& origin = lost.summary.origin;
        if (!untouchedSince(edits, qt(origin.name))) return;
        replace(std::move(result->document), origin.file, qt(origin.name));
        stamp_ = stampBefore(origin.file, lost.summary.milliseconds);
        history_.markUnsaved();
        lostCopy_ = lost.folder;
        keep(qt(lost.summary.lastStep));
        if (journal_) journal_->whenKept([this] { here_.post([this] { forgetLost(); }); });
        emit fileChanged();
        if (result->warnings.empty())
          emit noted(tr("%1 is as it was after \"%2\".").arg(title(), qt(lost.summary.lastStep)));
        else
          emit warned(toList(result->warnings));
        tellWithheld();
      },
      {});
}

bool Session::changedOnDisk() const { return !file_.empty() && FileStamp::of(file_) != stamp_; }

}  // namespace blossom::ui
