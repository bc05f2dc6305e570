#include "ui/session/surface_studies.h"

#include <algorithm>

#include "document/error_of.h"
#include "ui/session/display_cache.h"

namespace blossom::ui {

namespace {

constexpr std::size_t versionsKept = 2;  // of every feature of a document

const void* studiedAddress(const Shape& shape) {
  return shape.visit([](const auto& value) { return static_cast<const void*>(&value); });
}

}  // namespace

SurfaceStudies::~SurfaceStudies() { token_.cancel(); }

SurfaceStudies::Entry* SurfaceStudies::find(const Key& key) {
  const auto it = std::find_if(entries_.begin(), entries_.end(), [&](const Entry& entry) { return entry.key == key; });
  if (it == entries_.end()) return nullptr;
  entries_.splice(entries_.begin(), entries_, it);
  return &entries_.front();
}

void SurfaceStudies::makeRoomFor(std::size_t features) { most_ = std::max(most_, versionsKept * features); }

std::shared_ptr<const SurfaceStudy> SurfaceStudies::known(const Shape& shape, double chord, int isoCurves) {
  const Entry* const entry = find({studiedAddress(shape), chord, isoCurves});
  return entry ? entry->study : nullptr;
}

void SurfaceStudies::want(const Shape& shape, double chord, int isoCurves) {
  const Key key{studiedAddress(shape), chord, isoCurves};
  if (find(key)) return;
  entries_.push_front({key, shape, nullptr});
  // Those under way stay whatever their number: their shapes are being read.
  for (auto it = std::prev(entries_.end()); entries_.size() > most_ && it != entries_.begin();) {
    const bool idle = it->study || it->givenUp;
    it = std::prev(idle ? entries_.erase(it) : it);
  }
  if (waiting_++ == 0) emit started();
  const Progress progress(token_, [this](double fraction, const std::string& stage) {
    here_.post([this, fraction, stage] { emit progressed(fraction, QString::fromStdString(stage)); });
  });
  thread_.start([this, key, shape, progress, round = round_] {
    std::shared_ptr<const SurfaceStudy> study;
    std::optional<Error> error;
    try {
      error = errorOf("Looking at the surfaces", [&] {
        progress.check();
        study = std::make_shared<const SurfaceStudy>(
            studySurfaces(shape, drawnFineness(shape, key.chord), key.isoCurves, progress));
      });
    } catch (const Error& cancelled) {
      error = cancelled;
    }
    here_.post([this, key, round, study, error] { take(key, round, study, error); });
  });
}

void SurfaceStudies::take(const Key& key, std::uint64_t round, std::shared_ptr<const SurfaceStudy> study,
                          const std::optional<Error>& error) {
  if (round != round_) return;  // cancelled meanwhile, or asked for anew
  if (Entry* const entry = find(key)) {
    entry->study = std::move(study);
    entry->givenUp = !entry->study;
    if (entry->study) emit arrived();
  }
  if (error && error->code() != ErrorCode::Cancelled)
    emit failed(QString::fromStdString(error->message()), QString::fromStdString(error->hint()));
  if (--waiting_ == 0) emit ended();
}

void SurfaceStudies::cancel() {
  if (waiting_ == 0) return;
  token_.cancel();
  token_ = CancelToken();
  ++round_;
  waiting_ = 0;
  for (Entry& entry : entries_) entry.givenUp = !entry.study;
  emit ended();
}

void SurfaceStudies::allowAgain() {
  std::erase_if(entries_, [](const Entry& entry) { return entry.givenUp; });
}

}  // namespace blossom::ui
