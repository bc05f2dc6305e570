#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "cli/format_flags.h"
#include "exchange/format/export_shape.h"
#include "geometry/measure/measure.h"

namespace blossom {

/// A file to write; without a format it is a .blossom document.
struct Output {
  std::filesystem::path path;
  const Format* format = nullptr;
  Value options = Value::object();
  bool chordGiven = false;                      ///< the user has set the chord
  std::vector<std::filesystem::path> inputs{};  ///< files that none of its frames may replace
  ExportReport report{};                        ///< set once the file is written; of the frames of a sequence, at the first
};

/// Adds the warnings about written files, and the gouge measured in written programs to the measures.
void addReports(const std::vector<Output>& written, Measures& measures, std::vector<std::string>& warnings);

/// The paths given by -o, which may be repeated or a comma list. A text with commas is split only when every part has a
/// known extension.
std::vector<std::string> outputPaths(const FormatRegistry&, const std::vector<std::string>& given);

/// The outputs, checked before any work is done: extensions are known, folders exist and are writable, no file appears twice
/// or is an input.
/// @throws Error FormatUnknown, FileUnwritable; UsageError.
std::vector<Output> plannedOutputs(const FormatRegistry&, const std::vector<std::string>& paths,
                                   const std::vector<std::filesystem::path>& inputs, const FormatFlags* flags);

/// Writes a shape, and for .blossom files the document that made it with all its files. A sequence becomes several files in
/// formats of one frame (see exchange/format/frames.h). Whether all formats can store the shape, and that no frame replaces
/// an input, is checked before the first file is written. @returns the files written. @throws Error OutputNotSupported,
/// FileUnwritable, Cancelled; UsageError.
std::vector<Output> writeOutputs(const App&, const std::vector<Output>&, const Shape&, const Document&, const Progress&);

/// The paths as printed by `--json`.
Value pathsJson(const std::vector<Output>&);

}  // namespace blossom
