#include "ui/job.h"

namespace blossom::ui {

namespace {

std::optional<Error> errorOf(const Job::Work& work, const Progress& progress) {
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

Job::~Job() {
  token_.cancel();
  if (thread_.joinable()) thread_.join();
}

void Job::start(const QString& title, Work work, Then then) {
  Q_ASSERT(!running_);
  if (thread_.joinable()) thread_.join();
  running_ = true;
  watched_ = std::make_shared<StallWatch::Work>();
  token_ = CancelToken();
  emit started(title);
  const Progress progress(token_, [this](double fraction, const std::string& stage) {
    QMetaObject::invokeMethod(
        this, [=, this] { emit progressed(fraction, QString::fromStdString(stage)); }, Qt::QueuedConnection);
  });
  thread_ = std::thread([this, progress, work = std::move(work), then = std::move(then)] {
    auto error = errorOf(work, progress);
    QMetaObject::invokeMethod(
        this,
        [this, error = std::move(error), then] {
          running_ = false;
          lastError_ = error;
          const auto watched = std::move(watched_);  // `then` belongs to the work, and may be the end of this object
          emit finished();
          then(error);
        },
        Qt::QueuedConnection);
  });
}

}  // namespace blossom::ui
