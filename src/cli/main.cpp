#include <unistd.h>

#include <csignal>
#include <iostream>

#include "cli/cli.h"

namespace {

blossom::CancelToken* interrupted = nullptr;

/// The first Ctrl-C asks the work to stop and clean up, the second ends the program.
extern "C" void onInterrupt(int signal) {
  interrupted->cancel();
  std::signal(signal, SIG_DFL);
}

}  // namespace

int main(int argc, char** argv) {
  blossom::CancelToken cancel;
  interrupted = &cancel;
  std::signal(SIGINT, onInterrupt);
  std::signal(SIGTERM, onInterrupt);
  std::signal(SIGPIPE, SIG_IGN);  // a reader that went away ("blossom features | head") is noticed when writing
  return blossom::runCli(argc, argv, {std::cout, std::cerr, ::isatty(STDERR_FILENO) != 0, cancel});
}
