#include <dlfcn.h>
#include <signal.h>
#include <sys/prctl.h>
#include <unistd.h>

#include <atomic>
#include <cstdlib>
#include <new>
#include <set>

#include "core/error.h"
#include "core/parallel.h"
#include "worker/calls.h"
#include "worker/channel.h"
#include "worker/limits.h"

namespace blossom {

namespace {

std::atomic<pid_t> parent = 0;
static_assert(std::atomic<pid_t>::is_always_lock_free);  // a signal handler reads it

/// The system sends this signal whenever the thread ends that started this process, which need not be the thread of the
/// call: only when all threads of the parent have ended there is another parent.
extern "C" void endWithoutParent(int) {
  if (::getppid() != parent) ::kill(0, SIGKILL);
}

/// The child must not outlive its parent, not even one that died before this line; nor does anything that it has started.
void dieWithParent(const Value& request) {
  if (parent.exchange(request.value("parent", pid_t{0})) == 0) {
    struct sigaction action {};
    action.sa_handler = endWithoutParent;
    action.sa_flags = SA_RESTART;
    ::sigaction(SIGUSR1, &action, nullptr);
    ::prctl(PR_SET_PDEATHSIG, SIGUSR1);
  }
  if (::getppid() != parent) ::_exit(1);
}

Value errorMessage(const Error& error) {
  return {{"error", {{"code", errorCodeName(error.code())}, {"message", error.message()}, {"hint", error.hint()}}}};
}

/// Stays loaded: its functions are called until the process ends.
void loadModule(const std::string& path) {
  static std::set<std::string> loaded;
  if (path.empty() || loaded.contains(path)) return;
  void* module = ::dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL);
  void* entry = module ? ::dlsym(module, "blossomRegisterWorkerCalls") : nullptr;
  if (!entry) {
    const char* why = ::dlerror();
    throw Error(ErrorCode::PluginBroken,
                "The helper program cannot load the module " + path + ": " + (why ? why : "it registers no calls") + ".",
                "Install the plugin again.");
  }
  reinterpret_cast<void (*)()>(entry)();
  loaded.insert(path);
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

/// Serves one request. @returns whether this process can serve another.
bool serveOne(const Value& request, Channel& channel) {
  dieWithParent(request);
  applyLimits(request);
  keepTemporariesIn(request.value("folder", ""));
  setThreadLimit(request.value("threads", 0));
  Value message = answer(request, channel);
  const bool again = message.contains("result") && mayServeAgain();
  message["again"] = again;
  channel.send(message);
  return again;
}

}  // namespace

int workerMain() {
  ::signal(SIGXFSZ, SIG_IGN);  // a file that may not grow further is an error of writing, told as one
  Channel channel;
  std::string line = channel.receive();
  do {
    const Value request = Value::parse(line, nullptr, false);
    if (!request.is_object()) return 2;
    if (!serveOne(request, channel)) return 0;
    line = channel.receive();
  } while (!line.empty());
  return 0;
}

}  // namespace blossom
