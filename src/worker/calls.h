#pragma once
#include "worker/worker.h"

namespace blossom {

/// The function registered under a name; nullptr when there is none.
const WorkerFunction* findWorkerCall(const std::string& name);

/// The built-in call "worker.selftest", described at workerMain.
Value workerSelftest(const Value& arguments, const std::filesystem::path& folder, const Progress&);

}  // namespace blossom
