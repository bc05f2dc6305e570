#include <dlfcn.h>
#include <fcntl.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cmath>
#include <cstdlib>
#include <mutex>
#include <new>

#include "core/error.h"
#include "worker/calls.h"

namespace blossom {

namespace {

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool sanitized = true;  // their shadow memory needs terabytes of address space
#else
constexpr bool sanitized = false;
#endif

/// The way to the parent, on a descriptor of its own: stdin and stdout are then free for code that prints.
class Channel {
 public:
  Channel() : descriptor_(::fcntl(STDIN_FILENO, F_DUPFD_CLOEXEC, 3)) {
    const int nowhere = ::open("/dev/null", O_RDWR | O_CLOEXEC);
    ::dup2(nowhere, STDIN_FILENO);
    ::dup2(nowhere, STDOUT_FILENO);
    ::close(nowhere);
  }

  /// First line that arrives; empty when the parent is gone.
  [[nodiscard]] std::string receive() const {
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

  /// Callable from several threads; a parent that is gone ends the process.
  void send(const Value& message) {
    const std::string line = message.dump(-1, ' ', false, Value::error_handler_t::replace) + "\n";
    const std::lock_guard lock(mutex_);
    for (std::size_t done = 0; done < line.size();) {
      const ssize_t count = ::write(descriptor_, line.data() + done, line.size() - done);
      if (count < 0 && errno == EINTR) continue;
      if (count < 0) ::_exit(1);
      done += static_cast<std::size_t>(count);
    }
  }

 private:
  int descriptor_;
  std::mutex mutex_;
};

void limit(decltype(RLIMIT_AS) resource, rlim_t value) {
  rlimit current{};
  ::getrlimit(resource, &current);
  if (current.rlim_max != RLIM_INFINITY && value > current.rlim_max) return;
  current.rlim_cur = value;
  ::setrlimit(resource, &current);
}

void applyLimits(const Value& request) {
  limit(RLIMIT_CORE, 0);  // a crash on a damaged file is an answer, not something to dump gigabytes for
  if (const double seconds = request.value("cpu_seconds", 0.0); seconds > 0)
    limit(RLIMIT_CPU, static_cast<rlim_t>(std::ceil(seconds)));
  if (sanitized) return;
  rlim_t memory = request.value("memory", rlim_t{0});
  if (memory == 0) memory = static_cast<rlim_t>(::sysconf(_SC_PHYS_PAGES)) * static_cast<rlim_t>(::sysconf(_SC_PAGESIZE));
  limit(RLIMIT_AS, memory);
}

/// The child must not outlive its parent, not even one that died before this line.
void dieWithParent(const Value& request) {
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (::getppid() != request.value("parent", pid_t{0})) ::_exit(1);
}

Value errorMessage(const Error& error) {
  return {{"error", {{"code", errorCodeName(error.code())}, {"message", error.message()}, {"hint", error.hint()}}}};
}

/// Stays loaded: its functions are called until the process ends.
void loadModule(const std::string& path) {
  if (path.empty()) return;
  void* module = ::dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL);
  void* entry = module ? ::dlsym(module, "blossomRegisterWorkerCalls") : nullptr;
  if (!entry) {
    const char* why = ::dlerror();
    throw Error(ErrorCode::PluginBroken,
                "The helper program cannot load the module " + path + ": " + (why ? why : "it registers no calls") + ".",
                "Install the plugin again.");
  }
  reinterpret_cast<void (*)()>(entry)();
}

Value call(const Value& request, Channel& channel) {
  loadModule(request.value("module", ""));
  const std::string name = request.at("call");
  const WorkerFunction* function = findWorkerCall(name);
  if (!function)
    throw Error(ErrorCode::Internal, "The helper program does not know \"" + name + "\".", "Install Blossom again.");
  const Progress progress({}, [&channel](double fraction, const std::string& stage) {
    channel.send({{"progress", fraction}, {"stage", stage}});
  });
  return {{"result", (*function)(request.at("arguments"), request.at("folder").get<std::string>(), progress)}};
}

Value answer(const Value& request, Channel& channel) {
  try {
    return call(request, channel);
  } catch (const Error& error) {
    return errorMessage(error);
  } catch (const std::bad_alloc&) {
    return errorMessage(Error(ErrorCode::LimitExceeded, "There is not enough memory for this."));
  } catch (const std::exception& error) {
    return errorMessage(Error(ErrorCode::Internal, std::string("A helper process failed: ") + error.what() + "."));
  }
}

/// What is temporary here lies in the caller's folder, and goes with it whichever way this process ends.
void keepTemporariesIn(const std::string& folder) {
  if (!folder.empty()) ::setenv("TMPDIR", folder.c_str(), 1);
}

}  // namespace

int workerMain() {
  ::signal(SIGXFSZ, SIG_IGN);  // a file that may not grow further is an error of writing, told as one
  Channel channel;
  const Value request = Value::parse(channel.receive(), nullptr, false);
  if (!request.is_object()) return 2;
  dieWithParent(request);
  applyLimits(request);
  keepTemporariesIn(request.value("folder", ""));
  channel.send(answer(request, channel));
  return 0;
}

}  // namespace blossom
