#include "document/storage.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/error.h"
#include "core/file.h"
#include "core/zip_archive.h"
#include "document/assets.h"
#include "document/document_json.h"
#include "document/file_access.h"

namespace blossom {
namespace {

constexpr const char* mimeType = "application/x-blossom";
constexpr const char* documentEntry = "document.json";
constexpr std::string_view assetFolder = "assets/";
constexpr std::size_t hashDigits = 64;

bool isHash(std::string_view text) {
  return text.size() == hashDigits &&
         std::all_of(text.begin(), text.end(), [](char c) { return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'f'); });
}

bool isAsset(std::string_view name) { return name.starts_with(assetFolder) && isHash(name.substr(assetFolder.size())); }

bool isWanted(std::string_view name) { return name == documentEntry || isAsset(name); }

/// From the directory at the end of the zip, or, salvaging, from the headers in front of the entries.
ZipContent unpacked(const std::string& bytes, Problems& problems) {
  ZipContent content;
  try {
    content = readZip(bytes, isWanted);
    if (!problems.salvage() || content.damaged.empty()) return content;
  } catch (const Error& e) {
    if (e.code() != ErrorCode::FormatDamaged) throw;
    problems.report("it is cut off or changed, " + e.message().substr(0, e.message().size() - 1));
  }
  ZipContent rest = salvageZip(bytes, isWanted);
  content.entries.merge(rest.entries);
  content.damaged = std::move(rest.damaged);
  return content;
}

Document readContent(const std::string& bytes, Problems& problems) {
  ZipContent content = unpacked(bytes, problems);
  const auto json = content.entries.find(documentEntry);
  const bool jsonDamaged = std::find(content.damaged.begin(), content.damaged.end(),
                                     fmt::format("{} is damaged.", documentEntry)) != content.damaged.end();
  if (json == content.entries.end() && !jsonDamaged) problems.fail(fmt::format("there is no {} in it", documentEntry));
  for (const auto& damaged : content.damaged) problems.report(damaged.substr(0, damaged.size() - 1));
  if (json == content.entries.end()) problems.fail(fmt::format("{} cannot be read", documentEntry));

  Document document = readDocumentJson(json->second, problems);
  for (auto& [name, bytesOfAsset] : content.entries) {
    if (!isAsset(name)) continue;
    const std::string hash = name.substr(assetFolder.size());
    if (contentHash(bytesOfAsset) == hash)
      document = document.withAsset(hash, std::make_shared<const std::string>(std::move(bytesOfAsset)));
    else
      problems.report(fmt::format("{} does not have the content that its name tells", name));
  }
  checkAssets(document, problems);
  return document;
}

/// What would be refused on opening must not replace a file that opens.
void refuseUnreadable(const Document& document, const std::vector<ZipEntry>& entries) {
  std::uint64_t total = 0, largest = 0;
  for (const ZipEntry& entry : entries) {
    total += entry.content.size();
    largest = std::max<std::uint64_t>(largest, entry.content.size());
  }
  const ZipLimits limits;
  if (largest > limits.entry || total > limits.total)
    throw Error(
        ErrorCode::LimitExceeded,
        fmt::format("A document holds at most {} MB, and {} MB of one file; this one has {} MB, its largest file {} MB.",
                    limits.total >> 20, limits.entry >> 20, total >> 20, largest >> 20),
        "Remove imported files that are not needed, or divide the document.");
  if (document.features().size() > maximumFeatures)
    throw Error(
        ErrorCode::LimitExceeded,
        fmt::format("A document holds at most {} features; this one has {}.", maximumFeatures, document.features().size()),
        "Divide the document.");
}

}  // namespace

void saveDocument(const Document& document, const std::filesystem::path& path, const Progress& progress) {
  const std::string json = toJson(document);
  std::vector<ZipEntry> entries{{"mimetype", mimeType, true}, {documentEntry, json, false}};
  for (const auto& hash : namedAssets(document))
    entries.push_back({std::string(assetFolder) + hash, *document.assets().at(hash), false});
  refuseUnreadable(document, entries);
  writeAtomically(path, [&](const std::filesystem::path& temporary) { writeZip(temporary, entries, progress); });
}

OpenedDocument openDocument(const std::filesystem::path& path, bool salvage) {
  const std::string bytes = readFile(path);
  if (!bytes.starts_with("PK"))
    throw Error(ErrorCode::FormatDamaged, fmt::format("{} is not a Blossom document.", path.filename().string()),
                bytes.empty() ? "The file is empty." : "A Blossom document is a zip file; this one holds something else.");
  Problems problems(fmt::format("The document {}", path.filename().string()), salvage);
  OpenedDocument opened;
  opened.document =
      readContent(bytes, problems).withAccess(FileAccess::below(std::filesystem::absolute(path).parent_path()));
  opened.warnings = std::move(problems.warnings);
  return opened;
}

}  // namespace blossom
