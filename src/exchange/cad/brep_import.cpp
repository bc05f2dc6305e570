#include "exchange/cad/brep_import.h"

#include <BRep_Tool.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <fstream>

#include "core/error.h"
#include "core/file.h"
#include "exchange/cad/entity_count.h"
#include "transport/brep_transport.h"
#include "worker/worker.h"

namespace blossom {

namespace {

namespace fs = std::filesystem;

/// Name of the link to the file: what OCCT gets is short and plain whatever the file is called.
constexpr const char* linkName = "input";

/// A face without surface or an edge without curve, as damaged files make them, would crash later and in the parent.
bool isComplete(const TopoDS_Shape& shape) {
  for (TopExp_Explorer face(shape, TopAbs_FACE); face.More(); face.Next())
    if (BRep_Tool::Surface(TopoDS::Face(face.Current())).IsNull()) return false;
  for (TopExp_Explorer edge(shape, TopAbs_EDGE, TopAbs_FACE); edge.More(); edge.Next()) {
    double first = 0, last = 0;
    if (BRep_Tool::Curve(TopoDS::Edge(edge.Current()), first, last).IsNull()) return false;
  }
  return true;
}

Value serve(BrepReader reader, const fs::path& folder, const Progress& progress) {
  const BrepImport read = reader((folder / linkName).string(), progress);
  if (read.brep.shape().IsNull())
    throw Error(ErrorCode::FormatDamaged, "It holds no geometry.", "It may be empty, or hold only drawings or annotations.");
  if (!isComplete(read.brep.shape())) throw Error(ErrorCode::FormatDamaged, "Some of its faces or edges have no geometry.");
  return {{"shape", saveBrep(read.brep, folder, "shape")},
          {"entities", countEntities(read.brep)},
          {"skipped", read.skipped},
          {"warnings", read.warnings}};
}

/// OCCT reads about 2 MB a second; a damaged file can send it round for ever.
double cpuLimit(const fs::path& path) {
  constexpr double minimumSeconds = 15, secondsPerMegabyte = 20;
  return minimumSeconds + secondsPerMegabyte * static_cast<double>(fs::file_size(path)) / 1e6;
}

}  // namespace

void registerBrepReader(const std::string& call, BrepReader reader) {
  registerWorkerCall(call, [reader](const Value&, const fs::path& folder, const Progress& progress) {
    return serve(reader, folder, progress);
  });
}

Imported importBrep(const std::string& call, const fs::path& path, const Progress& progress) {
  const TemporaryFolder folder;
  fs::create_symlink(fs::absolute(path), folder.path() / linkName);
  const WorkerOptions options{.activity = "reading " + path.filename().string(), .cpuSeconds = cpuLimit(path)};
  Value answer = runInWorker(call, Value::object(), folder.path(), progress, options);
  Imported imported;
  imported.shape = loadBrep(answer.at("shape"), folder.path());
  imported.entities = std::move(answer.at("entities"));
  imported.skipped = std::move(answer.at("skipped"));
  imported.warnings = answer.at("warnings").get<std::vector<std::string>>();
  return imported;
}

std::string tailOf(const fs::path& path, std::size_t count) {
  std::ifstream stream(path, std::ios::binary | std::ios::ate);
  const auto size = static_cast<std::size_t>(std::max<std::streamoff>(stream.tellg(), 0));
  std::string tail(std::min(size, count), '\0');
  stream.seekg(static_cast<std::streamoff>(size - tail.size()));
  stream.read(tail.data(), static_cast<std::streamsize>(tail.size()));
  return tail;
}

}  // namespace blossom
