#include "worker/calls.h"

#include <fcntl.h>
#include <poll.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <iostream>
#include <map>
#include <vector>

#include "core/error.h"

namespace blossom {

namespace {

/// A function's static, because rooms may register at static initialisation, in any order.
std::map<std::string, WorkerFunction>& calls() {
  static std::map<std::string, WorkerFunction> all{{"worker.selftest", workerSelftest}};
  return all;
}

Value waitToBeEnded(const Progress& progress) {
  progress.report(0.5, std::to_string(::getpid()));
  for (;;) {
    progress.check();
    ::poll(nullptr, 0, 20);
  }
}

Value takeMemory(const Progress& progress) {
  std::vector<std::vector<char>> taken;
  for (;;) {
    progress.check();
    taken.emplace_back(std::size_t{64} << 20);
  }
}

Value takeTime(const Progress& progress) {
  for (;;) progress.check();
}

Value makeNoise() {
  std::cout << "{\"result\": \"not this one\"}\n" << std::flush;
  std::puts("** noise **");
  std::fflush(stdout);
  return "quiet";
}

}  // namespace

void registerWorkerCall(std::string name, WorkerFunction function) { calls()[std::move(name)] = std::move(function); }

const WorkerFunction* findWorkerCall(const std::string& name) {
  const auto found = calls().find(name);
  return found == calls().end() ? nullptr : &found->second;
}

Value workerSelftest(const Value& arguments, const std::filesystem::path&, const Progress& progress) {
  const std::string mode = arguments.value("mode", "echo");
  if (mode == "echo") return arguments;
  if (mode == "wait") return waitToBeEnded(progress);
  if (mode == "abort") std::abort();
  if (mode == "noise") return makeNoise();
  if (mode == "memory") return takeMemory(progress);
  if (mode == "spin") return takeTime(progress);
  if (mode == "throw")
    throw Error(errorCodeFromName(arguments.value("code", "")), arguments.value("message", ""), arguments.value("hint", ""));
  throw Error(ErrorCode::InvalidParameter, "The self-test has no mode \"" + mode + "\".");
}

}  // namespace blossom
