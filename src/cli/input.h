#pragma once
#include <string>
#include <vector>

#include "cli/session.h"

namespace blossom {

/// Adds the feature for an INPUT of the command line: a file, a literal (ball:5:3), the last feature of a document
/// (model.blossom) or a feature of a document by id (model.blossom#sweep-1).
/// @throws Error FileNotFound, FormatUnknown, NotFound; UsageError when the text is empty.
FeatureId addInput(const Session&, Document&, const std::string& text, std::vector<std::string>& warnings);

/// Opens a document, or any other file as a new document that imports it; with --salvage the readable part of a damaged
/// document.
/// @throws Error as openAny; for a damaged document the hint says whether --salvage would help.
OpenedDocument openInput(const Session&, const std::filesystem::path&);

/// The file named by an INPUT; empty for a literal.
std::filesystem::path fileOfInput(const std::string& text);

/// Evaluates a document as far as one feature requires.
/// @throws Error of the feature, or of the input that made it fail; Cancelled.
std::shared_ptr<const FeatureResult> evaluateFor(const App&, const Document&, const FeatureId&, const Progress&,
                                                 Results* all = nullptr);

/// The error that made a feature fail: that of its first ancestor that failed. @pre the feature failed
const Error& rootCause(const Document&, const Results&, const FeatureId&);

}  // namespace blossom
