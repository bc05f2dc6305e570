#include "document/edits.h"

#include <fmt/format.h>

#include <functional>
#include <set>

#include "core/error.h"
#include "core/file.h"
#include "core/zip_archive.h"
#include "document/file_access.h"
#include "document/file_values.h"
#include "document/storage.h"
#include "feature/registry.h"

namespace blossom {
namespace fs = std::filesystem;
namespace {

bool isEmbedded(const Value& file) { return !file.value("asset", std::string()).empty(); }

/// The path of a file value becomes an asset.
void embed(Value& file, Document& document) {
  const std::string path = file.value("path", std::string());
  const FileAccess* const access = document.access().get();
  if (isEmbedded(file) || path.empty() || (access && !access->permits(path))) return;
  auto content = std::make_shared<const std::string>(readFile(access ? access->opened(path) : fs::path(path)));
  if (content->size() > ZipLimits{}.entry)
    throw Error(ErrorCode::LimitExceeded,
                fmt::format("The file {} has {} MB; a document can keep files of at most {} MB.", path,
                            content->size() >> 20, ZipLimits{}.entry >> 20),
                "Divide the file, or make it smaller.");
  const std::string hash = contentHash(*content);
  document = document.withAsset(hash, std::move(content));
  // Where it lay on this machine is nobody else's business.
  file = Value{{"path", fs::path(path).filename().string()}, {"asset", hash}};
}

using FileVisit = std::function<void(Value& file, Document&)>;

/// The document with every file value as `visit` leaves it.
Document withFilesVisited(const Registry& registry, const Document& document, const FileVisit& visit) {
  Document result = document;
  for (const auto& each : document.features()) {
    const auto type = registry.find(each->type);
    if (!type || !hasFileParameter(type->parameters)) continue;
    Feature changed = *each;
    eachFile(type->parameters, changed.parameters, [&](Value& file) { visit(file, result); });
    if (!(changed == *each)) result = result.with(std::move(changed));
  }
  return result;
}

}  // namespace

Document withFilesEmbedded(const Registry& registry, const Document& document) {
  return withFilesVisited(registry, document, embed);
}

Document withFoundFilesEmbedded(const Registry& registry, const Document& document) {
  return withFilesVisited(registry, document, [](Value& file, Document& result) {
    try {
      embed(file, result);
    } catch (const Error& error) {
      if (error.code() != ErrorCode::FileNotFound && error.code() != ErrorCode::FileUnreadable) throw;
    }
  });
}

std::vector<fs::path> withheldFiles(const Registry& registry, const Document& document) {
  std::set<fs::path> withheld;
  withFilesVisited(registry, document, [&](Value& file, Document&) {
    const fs::path path = file.value("path", std::string());
    const bool kept = document.assets().contains(file.value("asset", std::string()));
    if (!kept && !path.empty() && document.access() && !document.access()->permits(path))
      withheld.insert(document.access()->resolved(path));
  });
  return {withheld.begin(), withheld.end()};
}

}  // namespace blossom
