#include "ui/session/recovery.h"

#include <QStandardPaths>

#include "ui/look/preferences.h"

namespace blossom::ui {

Recovery& Recovery::instance() {
  static Recovery recovery;
  return recovery;
}

std::filesystem::path Recovery::standardFolder() {
  return (QStandardPaths::writableLocation(QStandardPaths::AppDataLocation) + QStringLiteral("/recovery")).toStdString();
}

void Recovery::start(const std::filesystem::path& folder) {
  area_ = std::make_shared<RecoveryArea>(folder);
  auto found = std::make_shared<std::vector<LostDocument>>();
  look_.start(
      tr("Looking for unsaved documents"), [found, area = area_](const Progress&) { *found = area->lost(); },
      [this, found](const std::optional<Error>&) {
        lost_ = std::move(*found);
        if (!lost_.empty()) emit changed();
      });
}

void Recovery::stop() {
  area_.reset();
  lost_.clear();
}

std::unique_ptr<Journal> Recovery::newJournal(Journal::Problem problem) const {
  if (!area_ || !Preferences::instance().get<bool>("autosave")) return nullptr;
  return std::make_unique<Journal>(area_->newFolder(), std::move(problem));
}

void Recovery::discard(const std::filesystem::path& folder) {
  if (area_) area_->discard(folder);
  std::erase_if(lost_, [&](const LostDocument& each) { return each.folder == folder; });
  emit changed();
}

}  // namespace blossom::ui
