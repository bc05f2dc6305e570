#pragma once
#include <mutex>
#include <string>

#include "parameter/value.h"

namespace blossom {

/// The child's way to its parent, on a descriptor of its own: stdin and stdout are then free for code that prints. Messages
/// are lines of JSON.
class Channel {
 public:
  Channel();
  Channel(const Channel&) = delete;
  Channel& operator=(const Channel&) = delete;

  /// Next line that arrives; empty when the parent is gone.
  [[nodiscard]] std::string receive() const;
  /// Callable from several threads; a parent that is gone ends the process.
  void send(const Value& message);

 private:
  int descriptor_;
  std::mutex mutex_;
};

}  // namespace blossom
