#include "ui/session/safety_copy.h"

#include "ui/look/preferences.h"
#include "ui/session/recovery.h"

namespace blossom::ui {

SafetyCopy::SafetyCopy(QObject* parent) : QObject(parent) {
  connect(&autosave_, &QTimer::timeout, this, &SafetyCopy::snapshot);
}

void SafetyCopy::record(const Document& document, const std::string& step, const JournalOrigin& origin) {
  if (!journal_) {
    journal_ =
        Recovery::instance().newJournal([this](const Error& error) { here_.post([this, error] { emit failed(error); }); });
    if (!journal_) return;
  }
  autosave_.start(static_cast<int>(Preferences::instance().get<double>("autosave-minutes") * 60000));
  journal_->record(document, step, origin);
}

void SafetyCopy::clear() {
  autosave_.stop();
  if (journal_) journal_->clear();
  forgetLost();
}

void SafetyCopy::replaces(const std::filesystem::path& lost) {
  lost_ = lost;
  if (journal_) journal_->whenKept([this] { here_.post([this] { forgetLost(); }); });
}

std::shared_ptr<Journal> SafetyCopy::snapshot() {
  if (journal_) journal_->snapshot();
  return journal_;
}

void SafetyCopy::forgetLost() {
  if (lost_.empty()) return;
  Recovery::instance().discard(lost_);
  lost_.clear();
}

}  // namespace blossom::ui
