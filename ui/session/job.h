#pragma once
#include <QObject>
#include <QString>
#include <functional>
#include <memory>
#include <optional>

#include "core/error.h"
#include "core/progress.h"
#include "ui/thread/background.h"
#include "ui/thread/mailbox.h"
#include "ui/thread/stall_watch.h"

namespace blossom::ui {

/// Work that the window must not wait for, one at a time, on a thread of its own: opening, saving, importing, exporting.
class Job : public QObject {
  Q_OBJECT
 public:
  using Work = std::function<void(const Progress&)>;
  using Then = std::function<void(const std::optional<Error>&)>;

  explicit Job(QObject* parent = nullptr) : QObject(parent) {}
  ~Job() override;

  [[nodiscard]] bool running() const { return running_; }
  /// Runs `work`, then `then` in the window's thread, with the error that `work` threw. @pre !running()
  void start(const QString& title, Work work, Then then);
  void cancel() { token_.cancel(); }
  /// What the newest work that has finished threw.
  [[nodiscard]] const std::optional<Error>& lastError() const { return lastError_; }

 signals:
  void started(const QString& title);
  void progressed(double fraction, const QString& stage);
  void finished();

 private:
  void finish(const std::optional<Error>&, const Then&);

  CancelToken token_;
  bool running_ = false;
  std::shared_ptr<StallWatch::Work> watched_;
  std::optional<Error> lastError_;
  Mailbox here_;
  Background thread_;  // ends first
};

}  // namespace blossom::ui
