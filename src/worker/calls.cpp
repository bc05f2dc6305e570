#include "worker/calls.h"

#include <map>
#include <utility>

namespace blossom {

namespace {

/// A function's static, because rooms may register at static initialisation, in any order.
std::map<std::string, WorkerFunction>& calls() {
  static std::map<std::string, WorkerFunction> all{{"worker.selftest", workerSelftest}};
  return all;
}

}  // namespace

void registerWorkerCall(std::string name, WorkerFunction function) { calls()[std::move(name)] = std::move(function); }

const WorkerFunction* findWorkerCall(const std::string& name) {
  const auto found = calls().find(name);
  return found == calls().end() ? nullptr : &found->second;
}

}  // namespace blossom
