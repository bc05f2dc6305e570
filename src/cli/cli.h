#pragma once
#include <iosfwd>

#include "core/progress.h"

namespace blossom {

/// Where a command line talks to, and what asks it to stop.
struct Terminal {
  std::ostream& out;         ///< results
  std::ostream& err;         ///< errors, warnings, progress
  bool interactive = false;  ///< `err` is a screen: progress is a bar that is drawn over itself
  CancelToken cancel;
};

/// The `blossom` command. Every feature type of the registry is a subcommand.
/// @returns 0 done, 1 failed or cancelled (also when `out` took not all of the result), 2 wrong use. Never throws.
int runCli(int argc, const char* const* argv, const Terminal&);

struct App;
/// The same with feature types and formats at hand instead of those of this installation.
int runCli(const App&, int argc, const char* const* argv, const Terminal&);

}  // namespace blossom
