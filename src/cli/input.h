#pragma once
#include <string>
#include <vector>

#include "cli/invocation.h"

namespace blossom {

/// Adds the feature that an INPUT of the command line stands for: a file, a shape written down (ball:5:3), a document
/// (model.blossom: its last feature) or a feature of one (model.blossom#sweep-1).
/// @throws Error FileNotFound, FormatUnknown, NotFound; UsageError when the text is empty.
FeatureId addInput(const Invocation&, Document&, const std::string& text, std::vector<std::string>& warnings);

/// A document, or any other file as a new one; with --salvage what is readable of a damaged document.
/// @throws Error as openAny; the hint at damage tells whether --salvage would help.
OpenedDocument openInput(const Invocation&, const std::filesystem::path&);

/// The file that an INPUT names; empty for a shape written down.
std::filesystem::path fileOfInput(const std::string& text);

/// Evaluates a document for one of its features.
/// @throws Error what the feature, or the input that made it fail, has to say; Cancelled.
std::shared_ptr<const FeatureResult> evaluateFor(const App&, const Document&, const FeatureId&, const Progress&,
                                                 Results* all = nullptr);

/// The error that explains why a feature failed: that of the first of its ancestors to fail. @pre the feature failed
const Error& rootCause(const Document&, const Results&, const FeatureId&);

}  // namespace blossom
