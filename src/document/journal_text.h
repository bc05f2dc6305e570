#pragma once
#include <optional>
#include <string>
#include <string_view>

#include "document/document.h"

namespace blossom {

/// A line of a journal: checksum, blank, JSON, end of line.
std::string journalLine(const Value&);
/// The JSON of a line without its end; nothing when the line was torn or changed.
std::optional<Value> readJournalLine(std::string_view line);

/// What makes `after` out of `before`: {"put": features that are new or other, "order": ids when they changed, "extra": ..}.
/// O(features) comparisons of pointers; only what changed is looked into.
Value journalStep(const Document& before, const Document& after);
/// Applies a step to a document in the form of document.json. @throws Error FormatDamaged when it does not fit.
void applyJournalStep(Value& document, const Value& step);

}  // namespace blossom
