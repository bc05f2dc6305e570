#include <fmt/format.h>

#include <algorithm>
#include <new>
#include <ostream>

#include "cli/command_line.h"
#include "cli/feature_table.h"
#include "cli/format_flags.h"
#include "cli/input.h"
#include "cli/progress_display.h"
#include "cli/report.h"
#include "document/edits.h"
#include "document/named_numbers.h"
#include "geometry/measure/volume_doubt.h"

namespace blossom {
namespace {

/// The content of a file, measured like the result of a feature.
class InfoCommand {
 public:
  InfoCommand(CommandLine& line, Invocation& invocation)
      : invocation_(invocation), app_(line.add("info", "Measure what files hold.", invocation, [this] { return run(); })) {
    app_.add_option("FILE", files_, "Files to look at (or model.blossom#feature).")->type_name("..")->expected(0, -1);
    CommandLine::addDocumentFlags(app_, invocation_);
    formats_ = std::make_unique<FormatFlags>(line, app_, *invocation.app.formats, FormatFlags::Reading);
    setExamples(app_, {"blossom info part.step", "blossom info drawing.dxf --json"});
  }

 private:
  struct Info {
    Value json;
    Measures measures;
  };

  static std::vector<std::string> withDoubts(std::vector<std::string> warnings, const Shape& shape,
                                             const Progress& progress) {
    if (const Mesh* mesh = shape.get<Mesh>())
      if (const auto doubt = volumeDoubt(*mesh, progress)) warnings.push_back(*doubt);
    return warnings;
  }

  Info ofFile(const std::filesystem::path& file, const Progress& progress) const {
    const Stopwatch watch;
    const Format* format = invocation_.app.formats->find(file.extension().string());
    const Imported imported =
        readShape(*invocation_.app.formats, file, format ? formats_->reading(*format) : Value::object(), progress);
    const double readMs = watch.elapsedMs();
    Info info{Value{{"file", file.string()}, {"format", format->id}}, measure(imported.shape, progress)};
    info.json["result"] = resultJson(info.measures);
    info.json["warnings"] = withDoubts(imported.warnings, imported.shape, progress);
    info.json["stats"] = {{"read_ms", readMs},
                          {"total_ms", invocation_.elapsedMs()},
                          {"entities", imported.entities},
                          {"skipped", imported.skipped}};
    return info;
  }

  Info ofDocument(const std::filesystem::path& file, const Progress& progress) const {
    const OpenedDocument opened = openInput(invocation_, file);
    Info info{
        Value{{"file", file.string()}, {"format", "blossom"}, {"features", Value::array()}, {"result", Value::object()}},
        {}};
    std::vector<std::string> warnings = opened.warnings;
    if (!opened.document.features().empty()) {
      const Results results = Evaluator(invocation_.app.registry).evaluate(opened.document, progress);
      info.json["features"] = featuresJson(opened.document, results, progress);
      const FeatureId last = lastFeature(opened.document).id;
      const auto& result = *results.at(last);
      if (result.error)
        warnings.push_back(
            fmt::format("The feature \"{}\" failed: {}", last, rootCause(opened.document, results, last).message()));
      else
        info.json["result"] = resultJson(info.measures = measured(result.evaluated, progress));
      warnings = withDoubts(std::move(warnings), result.evaluated.shape, progress);
    }
    for (const NamedNumber& row : numbersOf(opened.document)) info.json["numbers"][row.name] = row.value;
    info.json["stats"] = {{"total_ms", invocation_.elapsedMs()}};
    info.json["warnings"] = warnings;
    return info;
  }

  Info ofPart(const std::string& text, const Progress& progress) const {
    Document document;
    std::vector<std::string> warnings;
    const FeatureId id = addInput(invocation_, document, text, warnings);
    const auto result = evaluateFor(invocation_.app, document, id, progress);
    warnings.insert(warnings.end(), result->evaluated.warnings.begin(), result->evaluated.warnings.end());
    Info info{Value{{"file", text}}, measured(result->evaluated, progress)};
    info.json["result"] = resultJson(info.measures);
    info.json["warnings"] = withDoubts(std::move(warnings), result->evaluated.shape, progress);
    info.json["stats"] = {{"kernel_ms", result->kernelMs}, {"total_ms", invocation_.elapsedMs()}};
    info.json["stats"].update(result->evaluated.stats);
    return info;
  }

  Info about(const std::string& text, const Progress& progress) const {
    if (text.empty()) throw UsageError("The name of a file is empty.", "Give the name of a file.");
    const std::filesystem::path file = fileOfInput(text);
    if (file.empty() || file.string() != text) return ofPart(text, progress);
    return isDocument(file) && std::filesystem::is_regular_file(file) ? ofDocument(file, progress) : ofFile(file, progress);
  }

  /// One file of several; its failure does not prevent the others.
  Info aboutOrWhyNot(const std::string& text, const Progress& progress) const {
    const auto failure = [&](const Error& error) { return Info{Value{{"file", text}, {"error", toJson(error)}}, {}}; };
    try {
      return about(text, progress);
    } catch (const Error& error) {
      if (error.code() == ErrorCode::Cancelled) throw;
      return failure(error);
    } catch (const std::bad_alloc&) {
      return failure(Error(ErrorCode::LimitExceeded, fmt::format("There is not enough memory for {}.", text)));
    }
  }

  void printFailure(const Value& info) const {
    std::ostream& err = invocation_.terminal.err;
    err << "blossom: " << info.at("error").at("message").get<std::string>() << '\n';
    if (const auto hint = info.at("error").at("hint").get<std::string>(); !hint.empty()) err << "  " << hint << '\n';
  }

  void print(const Info& all) const {
    const Value& info = all.json;
    if (info.contains("error")) return printFailure(info);
    std::ostream& out = invocation_.terminal.out;
    out << info.at("file").get<std::string>() << '\n';
    if (info.contains("features")) printFeatureTable(out, info.at("features"));
    if (const auto numbers = info.find("numbers"); numbers != info.end())
      for (const auto& [name, value] : numbers->items()) out << name << " = " << value.get<std::string>() << '\n';
    auto rows = all.measures.kind.empty() ? std::vector<ReportRow>() : rowsOf(all.measures);
    addRows(rows, info.at("stats"));
    printRows(out, rows);
    std::ostream& err = invocation_.terminal.err;
    for (const auto& warning : info.at("warnings")) err << "blossom: warning: " << warning.get<std::string>() << '\n';
    for (const auto& feature : info.value("features", Value::array()))
      for (const auto& warning : feature.value("warnings", Value::array()))
        err << "blossom: warning: " << feature.at("name").get<std::string>() << ": " << warning.get<std::string>() << '\n';
  }

  int run() {
    if (files_.empty()) throw UsageError("info needs a file.", "\"blossom info part.step\" measures what the file holds.");
    ProgressDisplay display(invocation_);
    const Progress progress = display.progress();
    if (files_.size() == 1) {
      const Info info = about(files_.front(), progress);
      if (invocation_.json)
        printJson(invocation_.terminal.out, info.json);
      else
        print(info);
      return 0;
    }
    std::vector<Info> all;
    for (const std::string& file : files_) all.push_back(aboutOrWhyNot(file, progress));
    if (invocation_.json) {
      Value objects = Value::array();
      for (const Info& each : all) objects.push_back(each.json);
      printJson(invocation_.terminal.out, Value{{"files", objects}});
    } else {
      for (const Info& each : all) print(each);
    }
    const bool failed = std::any_of(all.begin(), all.end(), [](const Info& each) { return each.json.contains("error"); });
    return failed ? 1 : 0;
  }

  Invocation& invocation_;
  CLI::App& app_;
  std::vector<std::string> files_;
  std::unique_ptr<FormatFlags> formats_;
};

}  // namespace

void addInfoCommand(CommandLine& line, Invocation& invocation) {
  line.keep(std::make_shared<InfoCommand>(line, invocation));
}

}  // namespace blossom
