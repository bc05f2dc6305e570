#pragma once
#include <QObject>
#include <QTimer>
#include <filesystem>
#include <memory>
#include <string>

#include "core/error.h"
#include "document/journal.h"
#include "ui/thread/mailbox.h"

namespace blossom::ui {

/// The safety copy of one document: every unsaved step of it is written down, to be recovered after a crash.
class SafetyCopy : public QObject {
  Q_OBJECT
 public:
  explicit SafetyCopy(QObject* parent = nullptr);

  void record(const Document&, const std::string& step, const JournalOrigin&);
  void clear();  ///< nothing is unsaved
  /// The document came from a copy that an earlier run left; that one goes when this one has been written, or is cleared.
  void replaces(const std::filesystem::path& lost);
  /// Begins to write what has been recorded. To be settled before anything dangerous begins; nullptr: there is nothing.
  std::shared_ptr<Journal> snapshot();

 signals:
  void failed(const blossom::Error&);

 private:
  void forgetLost();

  QTimer autosave_;
  Mailbox here_;  // outlives all that post to it
  std::shared_ptr<Journal> journal_;
  std::filesystem::path lost_;
};

}  // namespace blossom::ui
