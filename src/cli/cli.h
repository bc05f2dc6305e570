#pragma once
#include <iosfwd>

#include "core/progress.h"

namespace blossom {

/// Output streams and cancellation of a command line.
struct Terminal {
  std::ostream& out;         ///< results
  std::ostream& err;         ///< errors, warnings, progress
  bool interactive = false;  ///< `err` is a terminal: progress is drawn as a bar
  CancelToken cancel;
};

/// Runs the `blossom` command. Every feature type of the registry is a subcommand.
/// @returns the exit code: 0 success, 1 failed or cancelled (also when `out` did not accept the whole result), 2 wrong
/// usage. Does not throw.
int runCli(int argc, const char* const* argv, const Terminal&);

struct App;
/// The same with the feature types and formats of `App` instead of those installed.
int runCli(const App&, int argc, const char* const* argv, const Terminal&);

}  // namespace blossom
