#pragma once
#include <string>
#include <vector>

#include "cli/invocation.h"

namespace blossom {

/// Adds the feature for an INPUT of the command line: a file, a literal (ball:5:3), the last feature of a document
/// (model.blossom) or a feature of a document by id (model.blossom#sweep-1). A file is imported with `options`, by format,
/// as in InputSpec::importedWith.
/// @throws Error FileNotFound, FormatUnknown, NotFound; UsageError when the text is empty.
FeatureId addInput(const Invocation&, Document&, const std::string& text, std::vector<std::string>& warnings,
                   const Value& options = Value::object());

/// A document, or any other file as a new one; with --salvage what is readable of a damaged document.
/// @throws Error as openAny; the hint at damage says whether --salvage would help.
OpenedDocument openInput(const Invocation&, const std::filesystem::path&);

/// The file named by an INPUT; empty for a literal.
std::filesystem::path fileOfInput(const std::string& text);

/// Evaluates a document as far as one feature requires.
/// @throws Error of the feature, or of the input that made it fail; Cancelled.
std::shared_ptr<const FeatureResult> evaluateFor(const App&, const Document&, const FeatureId&, const Progress&,
                                                 Results* all = nullptr);

/// The error that made a feature fail: that of its first ancestor that failed. @pre the feature failed
const Error& rootCause(const Document&, const Results&, const FeatureId&);

}  // namespace blossom
