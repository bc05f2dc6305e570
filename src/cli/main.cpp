#include <poll.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <iostream>
#include <string>
#include <string_view>

#include "cli/cli.h"
#include "cli/interruption.h"
#include "core/error.h"
#include "core/temporaries.h"

namespace {

volatile std::sig_atomic_t readerGone = 0;

/// "blossom features | head": whoever read the result has seen enough, which is no cause for complaint.
extern "C" void onBrokenPipe(int) { readerGone = 1; }

/// Past all buffers, which the work may hold at this moment; not to a reader that has stopped reading.
void writeNow(int descriptor, const std::string& text) {
  pollfd ready{descriptor, POLLOUT, 0};
  if (::poll(&ready, 1, 0) != 1) return;
  const ssize_t written = ::write(descriptor, text.data(), text.size());
  (void)written;  // there is nobody left to tell
}

void tellCancelled(bool json) {
  if (json)
    writeNow(STDOUT_FILENO, "{\"error\":{\"code\":\"Cancelled\",\"hint\":\"\",\"message\":\"The work was cancelled.\"}}\n");
  else
    writeNow(STDERR_FILENO, "blossom: The work was cancelled.\n");
}

}  // namespace

int main(int argc, char** argv) {
  const bool json = std::any_of(argv + 1, argv + argc, [](std::string_view word) { return word == "--json"; });
  std::signal(SIGPIPE, onBrokenPipe);
  std::signal(SIGXFSZ, SIG_IGN);  // a file that may not grow further is an error of writing, told as one
  const blossom::CancelToken cancel;
  const blossom::Interruption interruption(cancel, [json] { tellCancelled(json); });
  blossom::removeAbandonedFolders();
  const int code = blossom::runCli(argc, argv, {std::cout, std::cerr, ::isatty(STDERR_FILENO) != 0, cancel});
  if (std::cout.fail() && !readerGone) std::cerr << "blossom: The result could not be written to standard output.\n";
  return code;
}
