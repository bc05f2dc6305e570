#pragma once
#include <memory>
#include <string>
#include <vector>

#include "app/app.h"
#include "cli/cli.h"
#include "core/error.h"
#include "core/stopwatch.h"
#include "parameter/value.h"

namespace blossom {

/// The command was not called as it wants to be: exit code 2 instead of 1.
class UsageError : public Error {
 public:
  explicit UsageError(std::string message, std::string hint = {}, ErrorCode code = ErrorCode::InvalidParameter)
      : Error(code, std::move(message), std::move(hint)) {}
};

/// What one run of `blossom` shares with its command.
struct Session {
  const App& app;
  const Terminal& terminal;
  Stopwatch watch = {};
  bool json = false;           ///< --json: one JSON object on stdout
  bool progressLines = false;  ///< --progress: plain lines also where stderr is no screen
  bool salvage = false;        ///< --salvage: open what is readable of a damaged document
  bool allowFiles = false;     ///< --allow-files: documents may read files outside of their folder
  int threads = 0;             ///< --threads; 0 leaves it to the machine

  [[nodiscard]] double elapsedMs() const { return watch.elapsedMs(); }
};

/// One JSON object, one line. Bytes that are not UTF-8 (file names) are replaced, numbers read back as the same double.
void printJson(std::ostream&, const Value&);

/// {"code", "message", "hint"}
Value toJson(const Error&);

}  // namespace blossom
