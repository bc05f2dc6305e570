#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "cli/format_flags.h"
#include "exchange/format/export_shape.h"
#include "geometry/measure/measure.h"

namespace blossom {

/// One file to be written; without a format it is a .blossom document.
struct Output {
  std::filesystem::path path;
  const Format* format = nullptr;
  Value options = Value::object();
  std::optional<Shape> shape{};  ///< what was written into it
  bool chordGiven = false;       ///< the user has said how fine polygons are to be
  ExportReport report{};         ///< once it is written
};

/// What is to be said about files that were written, and with what they are worth the measures of what they hold.
void tellReports(const std::vector<Output>& written, Measures& measures, std::vector<std::string>& warnings);

/// The paths of -o: repeated or as a comma list. A comma stays part of a name where what it would split off has no known
/// extension.
std::vector<std::string> outputPaths(const FormatRegistry&, const std::vector<std::string>& given);

/// The outputs asked for, checked before any work is done: known extensions, folders that exist and may be written to, no
/// file twice, none of the inputs.
/// @throws Error FormatUnknown, FileUnwritable; UsageError.
std::vector<Output> plannedOutputs(const FormatRegistry&, const std::vector<std::string>& paths,
                                   const std::vector<std::filesystem::path>& inputs, const FormatFlags* flags);

/// Writes a shape (and, for .blossom files, the document that made it with all its files inside). A sequence becomes
/// several files in formats of one frame (see exchange/format/frames.h). What one of the formats cannot hold is said before
/// the first is written. @returns the files written. @throws Error OutputNotSupported, FileUnwritable, Cancelled.
std::vector<Output> writeOutputs(const App&, const std::vector<Output>&, const Shape&, const Document&, const Progress&);

/// The paths as --json prints them.
Value pathsJson(const std::vector<Output>&);

}  // namespace blossom
