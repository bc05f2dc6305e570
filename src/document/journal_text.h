#pragma once
#include <optional>
#include <string>
#include <string_view>

#include "document/document.h"

namespace blossom {

/// A line of a journal: checksum, blank, JSON, end of line.
std::string journalLine(const Value&);
/// The JSON of a line without its line end; empty when the line is truncated or changed.
std::optional<Value> readJournalLine(std::string_view line);

/// The difference from `before` to `after`: {"put": features that are new or changed, "order": ids when they changed,
/// "extra": ..}. O(features) comparisons of pointers; only changed features are examined.
Value journalStep(const Document& before, const Document& after);
/// Applies a step to a document in the form of document.json. @throws Error FormatDamaged when it does not fit.
void applyJournalStep(Value& document, const Value& step);

}  // namespace blossom
