#include <unistd.h>

#include <csignal>
#include <iostream>

#include "cli/cli.h"

namespace {

blossom::CancelToken* interrupted = nullptr;
volatile std::sig_atomic_t readerGone = 0;

/// The first Ctrl-C asks the work to stop and clean up, the second ends the program.
extern "C" void onInterrupt(int signal) {
  interrupted->cancel();
  std::signal(signal, SIG_DFL);
}

/// "blossom features | head": whoever read the result has seen enough, which is no cause for complaint.
extern "C" void onBrokenPipe(int) { readerGone = 1; }

}  // namespace

int main(int argc, char** argv) {
  blossom::CancelToken cancel;
  interrupted = &cancel;
  std::signal(SIGINT, onInterrupt);
  std::signal(SIGTERM, onInterrupt);
  std::signal(SIGPIPE, onBrokenPipe);
  const int code = blossom::runCli(argc, argv, {std::cout, std::cerr, ::isatty(STDERR_FILENO) != 0, cancel});
  if (std::cout.fail() && !readerGone) std::cerr << "blossom: The result could not be written to standard output.\n";
  return code;
}
