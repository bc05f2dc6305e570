#pragma once
#include <iosfwd>

#include "cli/invocation.h"

namespace blossom {

/// All features of a document with state ("done", "failed", "suppressed"), time, measures, stats, warnings and error.
Value featuresJson(const Document&, const Results&, const Progress&);

/// Prints the features as a table: name, state, time, result.
void printFeatureTable(std::ostream&, const Value& features);

/// "surface, area 12.5": the kind and its most important measures.
std::string shortResult(const Value& result);

}  // namespace blossom
