#pragma once
#include <sys/stat.h>

#include <QTemporaryDir>
#include <string>

#include "core/file.h"
#include "support/modeling.h"

namespace blossom::test {

/// A worker program that only runs these shell words instead.
class FakeWorker {
 public:
  explicit FakeWorker(const char* words) {
    (void)theApp();
    const fs::path script = fs::path(folder_.path().toStdString()) / "worker";
    writeAtomically(script, std::string("#!/bin/sh\n") + words + "\n");
    ::chmod(script.c_str(), 0755);
    before_ = qgetenv("BLOSSOM_WORKER");
    qputenv("BLOSSOM_WORKER", script.c_str());
  }
  ~FakeWorker() { qputenv("BLOSSOM_WORKER", before_); }
  FakeWorker(const FakeWorker&) = delete;
  FakeWorker& operator=(const FakeWorker&) = delete;

 private:
  QTemporaryDir folder_;
  QByteArray before_;
};

inline constexpr const char* crashingWorker = "kill -SEGV $$";
/// Reports the stage "hanging" and never answers.
inline constexpr const char* hangingWorker =
    "read request; echo '{\"progress\": 0.5, \"stage\": \"hanging\"}'; exec sleep 600";

/// Cancels what has arrived in a hanging worker.
inline Progress cancellingWhenItHangs(const CancelToken& token) {
  return Progress(token, [token](double, const std::string& stage) {
    if (stage == "hanging") token.cancel();
  });
}

}  // namespace blossom::test
