#include <poll.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <iostream>
#include <limits>
#include <memory>
#include <vector>

#include "core/error.h"
#include "core/parallel.h"
#include "worker/calls.h"

namespace blossom {

namespace {

Value waitToBeEnded(const Progress& progress) {
  progress.report(0.5, std::to_string(::getpid()));
  for (;;) {
    progress.check();
    ::poll(nullptr, 0, 20);
  }
}

Value tellProcess(const Progress& progress) {
  progress.report(0.5, std::to_string(::getpid()));
  return ::getpid();
}

Value takeMemory(std::uintmax_t bytes, const Progress& progress) {
  constexpr std::size_t block = std::size_t{64} << 20;
  std::vector<std::unique_ptr<char[]>> taken;
  for (std::uintmax_t done = 0; done < bytes; done += block) {
    progress.check();
    taken.emplace_back(new char[block]);  // not filled: it is the address space that is limited
  }
  return ::getpid();
}

Value keepMemory(std::size_t bytes) {
  static std::vector<char> kept;
  kept.assign(bytes, 'x');
  return ::getpid();
}

Value takeTime(double seconds, const Progress& progress) {
  const auto computed = [] { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; };
  for (const double start = computed(); computed() - start < seconds;) progress.check();
  return ::getpid();
}

Value makeNoise() {
  std::cout << "{\"result\": \"not this one\"}\n" << std::flush;
  std::puts("** noise **");
  std::fflush(stdout);
  return "quiet";
}

}  // namespace

Value workerSelftest(const Value& arguments, const std::filesystem::path&, const Progress& progress) {
  const std::string mode = arguments.value("mode", "echo");
  if (mode == "echo") return arguments;
  if (mode == "pid") return ::getpid();
  if (mode == "threads") return threadLimit();
  if (mode == "tell") return tellProcess(progress);
  if (mode == "wait") return waitToBeEnded(progress);
  if (mode == "abort") std::abort();
  if (mode == "noise") return makeNoise();
  if (mode == "memory") return takeMemory(arguments.value("bytes", std::numeric_limits<std::uintmax_t>::max()), progress);
  if (mode == "hoard") return keepMemory(arguments.value("bytes", std::size_t{0}));
  if (mode == "spin") return takeTime(arguments.value("seconds", std::numeric_limits<double>::infinity()), progress);
  if (mode == "throw")
    throw Error(errorCodeFromName(arguments.value("code", "")), arguments.value("message", ""), arguments.value("hint", ""));
  throw Error(ErrorCode::InvalidParameter, "The self-test has no mode \"" + mode + "\".");
}

}  // namespace blossom
