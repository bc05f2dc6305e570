#pragma once
#include <iosfwd>

#include "cli/invocation.h"

namespace blossom {

/// Every feature of a document with its state ("done", "failed", "suppressed"), time, measures, stats, warnings and error.
Value featuresJson(const Document&, const Results&, const Progress&);

/// The same as a table: name, state, time, what came out.
void printFeatureTable(std::ostream&, const Value& features);

/// "surface, area 12.5": kind and the few measures that say most.
std::string shortResult(const Value& result);

}  // namespace blossom
