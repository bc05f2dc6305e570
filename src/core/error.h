#pragma once
#include <exception>
#include <string>
#include <string_view>

namespace blossom {

/// Error codes that programs can test; errorCodeName returns the name printed by `--json`.
enum class ErrorCode {
  Cancelled,         ///< the user, or a parent job, asked to stop
  InvalidParameter,  ///< a value is outside its range or has the wrong form
  InvalidInput,      ///< the input geometry cannot be used here
  FileNotFound,
  FileUnreadable,  ///< exists, but cannot be opened or read
  FileUnwritable,
  FormatUnknown,  ///< no reader or writer for this extension or content
  FormatDamaged,  ///< truncated, or against the rules of its format
  FormatTooNew,   ///< written by a later version of Blossom
  LimitExceeded,  ///< larger than what can be handled
  Degenerate,     ///< the geometry collapses: zero length, zero weight, vanishing quaternion
  NotFound,       ///< a feature, a command or a sub-shape of that name does not exist
  InUse,          ///< cannot be removed while others need it
  CycleFound,     ///< a feature would depend on itself
  PluginBroken,
  WorkerDied,          ///< the child process crashed or was ended by hand
  OutputNotSupported,  ///< this kind of shape cannot be written in that format
  Internal             ///< a violated invariant inside Blossom; always a defect
};

std::string_view errorCodeName(ErrorCode) noexcept;
/// Inverse of errorCodeName, for errors that cross a process boundary; Internal when the name is unknown.
ErrorCode errorCodeFromName(std::string_view) noexcept;

/// The one exception type of Blossom: a code, a sentence a user understands, and what to do about it.
/// Thrown anywhere, caught at the evaluator, the command line and the tool.
class Error : public std::exception {
 public:
  explicit Error(ErrorCode code, std::string message, std::string hint = {});

  [[nodiscard]] ErrorCode code() const noexcept { return code_; }
  [[nodiscard]] const std::string& message() const noexcept { return message_; }
  [[nodiscard]] const std::string& hint() const noexcept { return hint_; }
  [[nodiscard]] const char* what() const noexcept override { return message_.c_str(); }

 private:
  ErrorCode code_;
  std::string message_;
  std::string hint_;
};

}  // namespace blossom
