#include "cli/output.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>

#include "document/edits.h"
#include "exchange/format/frames.h"

namespace blossom {
namespace fs = std::filesystem;
namespace {

const Format* writableFormat(const FormatRegistry& formats, const fs::path& path) {
  const Format* format = path.has_extension() ? formats.find(path.extension().string()) : nullptr;
  return format && format->write ? format : nullptr;
}

std::string writableExtensions(const FormatRegistry& formats) {
  std::string known = ".blossom";
  for (const Format& each : formats.formats())
    if (each.write) known += ", ." + each.extensions.front();
  return known;
}

[[noreturn]] void unwritable(const fs::path& path, const std::string& why, const std::string& hint) {
  throw Error(ErrorCode::FileUnwritable, fmt::format("The file {} cannot be written: {}.", path.string(), why), hint);
}

void checkPlace(const fs::path& path) {
  const fs::path folder = path.has_parent_path() ? path.parent_path() : fs::path(".");
  std::error_code ec;
  if (fs::is_directory(path, ec)) unwritable(path, "it is a folder", "Name a file in it.");
  if (!fs::exists(folder, ec))
    unwritable(path, fmt::format("the folder {} does not exist", folder.string()), "Make the folder first.");
  if (!fs::is_directory(folder, ec))
    unwritable(path, fmt::format("{} is not a folder", folder.string()), "Choose another place.");
  if (::access(folder.c_str(), W_OK | X_OK) != 0)
    unwritable(path, std::strerror(errno), "Choose a folder that you may write to.");
  if (fs::exists(path, ec) && ::access(path.c_str(), W_OK) != 0)
    unwritable(path, std::strerror(errno), "Choose another name.");
  if (fs::exists(path, ec) && !fs::is_regular_file(path, ec))
    unwritable(path, "it is not an ordinary file", "Choose another name.");
}

bool sameFile(const fs::path& a, const fs::path& b) {
  std::error_code ec;
  if (fs::equivalent(a, b, ec)) return true;
  return fs::weakly_canonical(a, ec) == fs::weakly_canonical(b, ec);
}

void refuseInput(const fs::path& output, const std::vector<fs::path>& inputs) {
  for (const fs::path& input : inputs)
    if (!input.empty() && sameFile(output, input))
      throw UsageError(fmt::format("The output {} would replace the input.", output.string()),
                       "Choose another name for the output.");
}

Output planned(const FormatRegistry& formats, const fs::path& path) {
  if (path.empty()) throw UsageError("The name of an output is empty.", "Write -o and the name of a file.");
  Output output;
  output.path = path;
  if (!isDocument(path)) output.format = writableFormat(formats, path);
  if (!isDocument(path) && !output.format)
    throw Error(ErrorCode::FormatUnknown, fmt::format("The file {} has no extension that Blossom writes.", path.string()),
                fmt::format("Blossom writes {}.", writableExtensions(formats)));
  checkPlace(path);
  refuseResource(path);
  return output;
}

std::vector<std::string> splitAtCommas(const std::string& text) {
  std::vector<std::string> parts{""};
  for (const char c : text)
    if (c == ',')
      parts.emplace_back();
    else
      parts.back() += c;
  return parts;
}

/// What can be known before the first file is written.
void checkFiles(const std::vector<Output>& outputs, const Shape& shape) {
  for (const Output& output : outputs) {
    if (!output.format) continue;
    for (const ShapeKind kind : kindsInFiles(*output.format, shape, output.options))
      refuseUnlessStorable(*output.format, std::array{kind});
    for (const FileOfShape& file : filesOf(*output.format, shape, output.path, output.options))
      if (file.path != output.path) {
        checkPlace(file.path);
        refuseInput(file.path, output.inputs);
      }
  }
}

}  // namespace

std::vector<std::string> outputPaths(const FormatRegistry& formats, const std::vector<std::string>& given) {
  const auto known = [&](const std::string& path) { return isDocument(path) || writableFormat(formats, path); };
  std::vector<std::string> paths;
  for (const std::string& text : given) {
    const auto parts = splitAtCommas(text);
    if (std::all_of(parts.begin(), parts.end(), known))
      paths.insert(paths.end(), parts.begin(), parts.end());
    else
      paths.push_back(text);
  }
  return paths;
}

std::vector<Output> plannedOutputs(const FormatRegistry& formats, const std::vector<std::string>& paths,
                                   const std::vector<fs::path>& inputs, const FormatFlags* flags) {
  std::vector<Output> outputs;
  for (const std::string& path : paths) {
    Output output = planned(formats, path);
    refuseInput(path, inputs);
    output.inputs = inputs;
    for (const Output& other : outputs)
      if (sameFile(other.path, output.path))
        throw UsageError(fmt::format("The output {} is named twice.", path), "Name every file once.");
    if (flags && output.format) {
      const Value given = flags->writing(*output.format);
      output.chordGiven = given.contains("chord");
      output.options = completed(output.format->writeOptions, given);
    }
    outputs.push_back(std::move(output));
  }
  return outputs;
}

std::vector<Output> writeOutputs(const App& app, const std::vector<Output>& planned, const Shape& shape,
                                 const Document& document, const Progress& progress) {
  checkFiles(planned, shape);
  std::vector<Output> written;
  for (std::size_t i = 0; i < planned.size(); ++i) {
    const double count = static_cast<double>(planned.size());
    const Progress part = progress.part(static_cast<double>(i) / count, static_cast<double>(i + 1) / count);
    Output output = planned[i];
    if (!output.format) {
      saveDocument(withFilesEmbedded(*app.registry, document), output.path, part);
      written.push_back(std::move(output));
      continue;
    }
    output.report = exportShape(*app.formats, shape, output.path, output.options, output.chordGiven, part);
    for (FileOfShape& file : filesOf(*output.format, shape, planned[i].path, planned[i].options)) {
      output.path = std::move(file.path);
      written.push_back(output);
      output.report = {};  // which tells of all of them
    }
  }
  return written;
}

void addReports(const std::vector<Output>& written, Measures& measures, std::vector<std::string>& warnings) {
  for (const Output& output : written) {
    warnings.insert(warnings.end(), output.report.warnings.begin(), output.report.warnings.end());
    if (!output.report.gouge) continue;
    for (Measure& measure : measures.values)
      if (double* told = std::get_if<double>(&measure.value); told && measure.name == "gouge_mm")
        *told = std::max(*told, *output.report.gouge);
  }
}

Value pathsJson(const std::vector<Output>& outputs) {
  Value paths = Value::array();
  for (const Output& output : outputs) paths.push_back(output.path.string());
  return paths;
}

}  // namespace blossom
