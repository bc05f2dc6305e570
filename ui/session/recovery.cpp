#include "ui/session/recovery.h"

#include <QStandardPaths>
#include <QTimer>
#include <array>
#include <chrono>

#include "ui/look/preferences.h"

namespace blossom::ui {

using namespace std::chrono_literals;

Recovery& Recovery::instance() {
  static Recovery recovery;
  return recovery;
}

std::filesystem::path Recovery::standardFolder() {
  return (QStandardPaths::writableLocation(QStandardPaths::AppDataLocation) + QStringLiteral("/recovery")).toStdString();
}

void Recovery::start(const std::filesystem::path& folder) {
  area_ = std::make_shared<RecoveryArea>(folder);
  look(area_, 0);
}

void Recovery::look(const std::shared_ptr<RecoveryArea>& area, std::size_t time) {
  static constexpr std::array<std::chrono::seconds, 3> untilNext{2s, 4s, 10s};
  auto found = std::make_shared<std::vector<LostDocument>>();
  look_.start(
      tr("Looking for unsaved documents"), [found, area](const Progress&) { *found = area->lost(); },
      [this, found, area, time](const std::optional<Error>&) {
        if (area != area_) return;
        std::error_code ignored;  // discarded meanwhile
        std::erase_if(*found, [&](const LostDocument& each) { return !std::filesystem::exists(each.folder, ignored); });
        const bool more = found->size() > lost_.size();
        lost_ = std::move(*found);
        if (more) emit changed();
        if (time == untilNext.size()) return;
        QTimer::singleShot(untilNext[time], this, [this, area, time] {
          if (area == area_ && !look_.running()) look(area, time + 1);
        });
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
