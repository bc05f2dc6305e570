#pragma once
#include <filesystem>
#include <memory>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "worker/child_process.h"

namespace blossom {

/// What a program inherits from its parent when it is started, and what does not follow when the parent changes it later.
struct Surroundings {
  std::string program, folder;
  int niceness = 0;
  std::vector<std::string> environment;
  friend bool operator==(const Surroundings&, const Surroundings&) = default;
};

/// A child process that can serve several calls, one after the other.
struct WorkerChild {
  explicit WorkerChild(Surroundings given) : surroundings(std::move(given)), process(surroundings.program) {}

  Surroundings surroundings;
  std::set<std::string> modules;  ///< those it has loaded
  ChildProcess process;
};

/// An idle child whose surroundings are those of a program started now, preferably one that has loaded `module`; a new one
/// when there is none. @throws as ChildProcess.
std::unique_ptr<WorkerChild> takeChild(const std::filesystem::path& program, const std::string& module);

/// Keeps an idle child for later calls. It is ended after `seconds`, with this process, or when more than a few are idle.
void keepChild(std::unique_ptr<WorkerChild>, double seconds);

}  // namespace blossom
