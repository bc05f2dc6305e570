#include "ui/session/job.h"

namespace blossom::ui {

namespace {

std::optional<Error> errorOfWork(const Job::Work& work, const Progress& progress) {
  try {
    work(progress);
    return std::nullopt;
  } catch (const Error& error) {
    return error;
  } catch (const std::exception& problem) {
    return Error(ErrorCode::Internal, std::string("Something unforeseen happened: ") + problem.what() + ".");
  }
}

}  // namespace

Job::~Job() { token_.cancel(); }

void Job::start(const QString& title, Work work, Then then) {
  Q_ASSERT(!running_);
  running_ = true;
  watched_ = std::make_shared<StallWatch::Work>();
  token_ = CancelToken();
  emit started(title);
  const Progress progress(token_, [this](double fraction, const std::string& stage) {
    here_.post([this, fraction, stage] { emit progressed(fraction, QString::fromStdString(stage)); });
  });
  thread_.start([this, progress, work = std::move(work), then = std::move(then)] {
    here_.post([this, error = errorOfWork(work, progress), then] { finish(error, then); });
  });
}

void Job::finish(const std::optional<Error>& error, const Then& then) {
  running_ = false;
  lastError_ = error;
  const auto watched = std::move(watched_);  // `then` belongs to the work, and may be the end of this object
  emit finished();
  then(error);
}

}  // namespace blossom::ui
