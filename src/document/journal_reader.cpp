// The reading half of the journal.
#include <fmt/format.h>

#include "core/file.h"
#include "document/assets.h"
#include "document/document_json.h"
#include "document/journal.h"
#include "document/journal_files.h"
#include "document/journal_text.h"

namespace blossom {
namespace fs = std::filesystem;
namespace {

struct Replayed {
  JournalSummary summary;
  Value document;
};

std::string textOf(const Value& object, const char* key) {
  const auto found = object.find(key);
  return found != object.end() && found->is_string() ? found->get<std::string>() : std::string();
}

std::int64_t timeOf(const Value& object) {
  const auto found = object.find("time");
  return found != object.end() && found->is_number_integer() ? found->get<std::int64_t>() : 0;
}

std::optional<Replayed> readBase(const fs::path& file) {
  std::string text;
  try {
    text = readFile(file);
  } catch (const Error&) {
    return std::nullopt;  // an older generation may still be there
  }
  if (!text.ends_with('\n')) return std::nullopt;
  auto base = readJournalLine(std::string_view(text).substr(0, text.size() - 1));
  if (!base || !base->is_object() || base->value("journal", 0) != 1 || !base->contains("document")) return std::nullopt;
  Replayed replayed;
  replayed.summary.origin = {textOf(*base, "file"), textOf(*base, "name")};
  replayed.summary.lastStep = textOf(*base, "what");
  replayed.summary.milliseconds = timeOf(*base);
  replayed.document = std::move(base->at("document"));
  const bool fits = replayed.document.is_object() && replayed.document.contains("features") &&
                    replayed.document.at("features").is_array() && replayed.document.contains("blossom");
  return fits ? std::optional(std::move(replayed)) : std::nullopt;
}

/// Up to the first line that is not whole or does not fit.
void replaySteps(const fs::path& file, Replayed& replayed) {
  std::error_code ec;
  if (!fs::exists(file, ec)) return;
  const std::string text = readFile(file);
  for (std::size_t at = 0, end; (end = text.find('\n', at)) != std::string::npos; at = end + 1) {
    const auto step = readJournalLine(std::string_view(text).substr(at, end - at));
    if (!step || !step->is_object()) return;
    Value changed = replayed.document;
    try {
      applyJournalStep(changed, *step);
    } catch (const Error&) {
      return;
    }
    replayed.document = std::move(changed);
    replayed.summary.lastStep = textOf(*step, "what");
    replayed.summary.milliseconds = timeOf(*step);
  }
}

Replayed replay(const fs::path& folder) {
  for (const std::size_t generation : journalGenerations(folder)) {
    auto replayed = readBase(journalBase(folder, generation));
    if (!replayed) continue;
    replaySteps(journalSteps(folder, generation), *replayed);
    replayed->summary.features = replayed->document.at("features").size();
    return std::move(*replayed);
  }
  throw Error(ErrorCode::FileNotFound, fmt::format("The folder {} holds nothing to recover.", folder.string()));
}

}  // namespace

JournalSummary summarised(const fs::path& folder) { return replay(folder).summary; }

OpenedDocument recoverDocument(const fs::path& folder) {
  const Replayed replayed = replay(folder);
  Problems problems("The recovered document", true);
  OpenedDocument opened;
  opened.document = readDocumentJson(replayed.document.dump(), problems);
  std::error_code ec;
  for (fs::directory_iterator it(journalAssets(folder), ec), end; !ec && it != end; it.increment(ec)) {
    const std::string hash = it->path().filename().string();
    auto content = std::make_shared<const std::string>(readFile(it->path()));
    if (contentHash(*content) == hash) opened.document = opened.document.withAsset(hash, std::move(content));
  }
  checkAssets(opened.document, problems);
  opened.warnings = std::move(problems.warnings);
  return opened;
}

}  // namespace blossom
