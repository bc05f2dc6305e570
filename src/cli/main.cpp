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
#include "core/memory.h"
#include "core/temporaries.h"

namespace {

volatile std::sig_atomic_t readerGone = 0;

/// "blossom features | head": a closed pipe is not an error.
extern "C" void onBrokenPipe(int) { readerGone = 1; }

/// Writes without buffers, which the work may be using; does nothing when the reader has closed the pipe.
void writeNow(int descriptor, const std::string& text) {
  pollfd ready{descriptor, POLLOUT, 0};
  if (::poll(&ready, 1, 0) != 1) return;
  const ssize_t written = ::write(descriptor, text.data(), text.size());
  (void)written;  // nothing can be done
}

void tellCancelled(bool json) {
  if (json)
    writeNow(STDOUT_FILENO, "{\"error\":{\"code\":\"Cancelled\",\"hint\":\"\",\"message\":\"The work was cancelled.\"}}\n");
  else
    writeNow(STDERR_FILENO, "blossom: The work was cancelled.\n");
}

}  // namespace

int main(int argc, char** argv) {
  blossom::keepFreedMemory();
  const bool json = std::any_of(argv + 1, argv + argc, [](std::string_view word) { return word == "--json"; });
  std::signal(SIGPIPE, onBrokenPipe);
  std::signal(SIGXFSZ, SIG_IGN);  // a file size limit is reported as an error of writing
  const blossom::CancelToken cancel;
  const blossom::Interruption interruption(cancel, [json] { tellCancelled(json); });
  blossom::removeAbandonedFolders();
  const int code = blossom::runCli(argc, argv, {std::cout, std::cerr, ::isatty(STDERR_FILENO) != 0, cancel});
  if (std::cout.fail() && !readerGone) std::cerr << "blossom: The result could not be written to standard output.\n";
  return code;
}
