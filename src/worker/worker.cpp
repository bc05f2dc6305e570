#include "worker/worker.h"

#include <dlfcn.h>
#include <signal.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <optional>

#include "core/error.h"
#include "core/parallel.h"
#include "worker/kept_children.h"

namespace blossom {

namespace {

namespace fs = std::filesystem;

fs::path workerProgram() {
  if (const char* named = std::getenv("BLOSSOM_WORKER")) return named;
  std::error_code ignored;
  const fs::path folder = fs::read_symlink("/proc/self/exe", ignored).parent_path();
  for (const fs::path& candidate : {folder / "blossom-worker", folder / "../libexec/blossom/blossom-worker"})
    if (fs::exists(candidate, ignored)) return candidate;
  throw Error(
      ErrorCode::FileNotFound, "The helper program blossom-worker is missing.",
      "It belongs beside the program or in ../libexec/blossom. Install Blossom again, or name it in BLOSSOM_WORKER.");
}

std::string requestLine(const std::string& name, const Value& arguments, const fs::path& folder,
                        const WorkerOptions& options) {
  const Value request{{"call", name},
                      {"arguments", arguments},
                      {"folder", folder.string()},
                      {"parent", ::getpid()},
                      {"module", options.module.string()},
                      {"cpu_seconds", options.cpuSeconds},
                      {"memory", options.memory},
                      {"threads", threadLimit()}};
  // File names need not be UTF-8; in a message they may read a little odd, in a path of `folder` they do not occur.
  return request.dump(-1, ' ', false, Value::error_handler_t::replace) + "\n";
}

/// Handles one line of the child. @returns the message with the result when the call is done.
std::optional<Value> answerOf(const std::string& line, const Progress& progress) {
  Value message = Value::parse(line, nullptr, false);
  if (!message.is_object()) throw Error(ErrorCode::WorkerDied, "A helper process sent a message that is not understood.");
  if (const auto error = message.find("error"); error != message.end())
    throw Error(errorCodeFromName(error->value("code", "")), error->value("message", ""), error->value("hint", ""));
  if (message.contains("result")) return message;
  progress.report(message.value("progress", 0.0), message.value("stage", ""));
  return {};
}

std::string signalName(int number) {
  const char* name = ::sigabbrev_np(number);
  return name ? "SIG" + std::string(name) : "signal " + std::to_string(number);
}

[[noreturn]] void throwDied(int status, const std::string& name, const WorkerOptions& options) {
  const std::string process = "The helper process " + (options.activity.empty() ? "for " + name : options.activity);
  if (!WIFSIGNALED(status))
    throw Error(ErrorCode::WorkerDied,
                process + " stopped without an answer (exit code " + std::to_string(WEXITSTATUS(status)) + ").",
                "Try again. If it happens again, it is a defect of Blossom or of the libraries it uses.");
  const int number = WTERMSIG(status);
  if (number == SIGXCPU)
    throw Error(ErrorCode::LimitExceeded, process + " took longer than it may and was ended.",
                "The input may be damaged, or is too complex.");
  const bool byHand = number == SIGKILL || number == SIGTERM || number == SIGINT || number == SIGHUP || number == SIGQUIT;
  throw Error(ErrorCode::WorkerDied, process + (byHand ? " was ended (" : " crashed (") + signalName(number) + ").",
              byHand ? "Someone ended it, or the system did for want of memory. Try again."
                     : "The rest of Blossom is not affected. Either this is more than the library behind it can do, or the "
                       "input is damaged. Try other values or a simpler shape.");
}

}  // namespace

fs::path moduleOf(const void* address) {
  Dl_info found{};
  if (::dladdr(address, &found) == 0 || !found.dli_fname)
    throw Error(ErrorCode::Internal, "The module of a worker call is not known.");
  return fs::absolute(found.dli_fname);
}

Value runInWorker(const std::string& name, const Value& arguments, const fs::path& folder, const Progress& progress,
                  const WorkerOptions& options) {
  progress.check();
  const std::string module = options.module.string();
  auto child = takeChild(workerProgram(), module);
  std::string pending = requestLine(name, arguments, folder, options);
  std::string received;
  std::size_t searched = 0;  // no line ends before
  for (bool open = true; open;) {
    open = child->process.exchange(pending, received, 20);
    progress.check();
    std::size_t start = 0;
    for (std::size_t end; (end = received.find('\n', searched)) != std::string::npos; start = searched = end + 1) {
      std::optional<Value> answer = answerOf(received.substr(start, end - start), progress);
      if (!answer) continue;
      child->modules.insert(module);
      if (answer->value("again", false) && options.idleSeconds > 0) keepChild(std::move(child), options.idleSeconds);
      return std::move(answer->at("result"));
    }
    received.erase(0, start);
    searched = received.size();
  }
  throwDied(child->process.wait(), name, options);
}

}  // namespace blossom
