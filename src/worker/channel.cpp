#include "worker/channel.h"

#include <fcntl.h>
#include <unistd.h>

#include <array>
#include <cerrno>

namespace blossom {

Channel::Channel() : descriptor_(::fcntl(STDIN_FILENO, F_DUPFD_CLOEXEC, 3)) {
  const int nowhere = ::open("/dev/null", O_RDWR | O_CLOEXEC);
  ::dup2(nowhere, STDIN_FILENO);
  ::dup2(nowhere, STDOUT_FILENO);
  ::close(nowhere);
}

// The parent sends the next line only after the answer to the last: nothing follows the end of a line.
std::string Channel::receive() const {
  std::string line;
  std::array<char, 1 << 16> buffer;
  for (;;) {
    const ssize_t count = ::read(descriptor_, buffer.data(), buffer.size());
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return {};
    line.append(buffer.data(), static_cast<std::size_t>(count));
    if (line.back() == '\n') return line;
  }
}

void Channel::send(const Value& message) {
  const std::string line = message.dump(-1, ' ', false, Value::error_handler_t::replace) + "\n";
  const std::lock_guard lock(mutex_);
  for (std::size_t done = 0; done < line.size();) {
    const ssize_t count = ::write(descriptor_, line.data() + done, line.size() - done);
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) ::_exit(1);
    done += static_cast<std::size_t>(count);
  }
}

}  // namespace blossom
