#include "exchange/cad/brep_export.h"

#include "core/error.h"
#include "core/file.h"
#include "transport/brep_transport.h"
#include "worker/worker.h"

namespace blossom {

namespace {

namespace fs = std::filesystem;

/// Name of the link to the file: what OCCT gets is short and plain whatever the file is called.
constexpr const char* outputLink = "output";

Value serveWriter(BrepWriter writer, const Value& arguments, const fs::path& folder, const Progress& progress) {
  writer(loadBrep(arguments.at("shape"), folder), (folder / outputLink).string(), arguments.at("options"), progress);
  return Value::object();
}

}  // namespace

void registerBrepWriter(const std::string& call, BrepWriter writer) {
  registerWorkerCall(call, [writer](const Value& arguments, const fs::path& folder, const Progress& progress) {
    return serveWriter(writer, arguments, folder, progress);
  });
}

void exportBrep(const std::string& call, const Brep& brep, const fs::path& path, const Value& options,
                const Progress& progress) {
  if (brep.shape().IsNull()) throw Error(ErrorCode::InvalidInput, "The shape is empty; there is nothing to write.");
  const TemporaryFolder folder;
  const Value arguments{{"shape", saveBrep(brep, folder.path(), "shape")}, {"options", options}};
  fs::create_symlink(fs::absolute(path), folder.path() / outputLink);
  runInWorker(call, arguments, folder.path(), progress, {.activity = "that writes the file"});
}

}  // namespace blossom
