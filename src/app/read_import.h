#pragma once
#include "app/app.h"
#include "document/evaluator.h"

namespace blossom {

/// Reads the file of an import feature now, so that one that cannot be read is told before there is a feature of it. What
/// was read stays in the cache of the evaluator. What the options of the format may mend is left to the feature.
/// @throws Error Cancelled, and why the file cannot be read, with its name.
void readImport(const App&, Evaluator&, const Document&, const FeatureId& import, const Progress&);

}  // namespace blossom
