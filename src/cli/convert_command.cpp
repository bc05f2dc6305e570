#include <fmt/format.h>

#include <ostream>

#include "cli/command_line.h"
#include "cli/input.h"
#include "cli/output.h"
#include "cli/progress_display.h"
#include "cli/report.h"
#include "geometry/occt/merged_shape.h"

namespace blossom {
namespace {

/// A file in, the same shape out in other formats.
class ConvertCommand {
 public:
  ConvertCommand(CommandLine& line, Invocation& invocation)
      : invocation_(invocation),
        app_(line.add("convert", "Write a file in another format.", invocation, [this] { return run(); })) {
    app_.add_option("IN", words_, "The file to read (or model.blossom#feature), then the files to write.")
        ->type_name("OUT..")
        ->expected(0, -1);
    app_.add_option("-o,--output", outputs_, "Files to write, as a comma list; the same as naming them after IN.")
        ->type_name("FILE,..")
        ->expected(1)
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
    CommandLine::addDocumentFlags(app_, invocation_);
    formats_ =
        std::make_unique<FormatFlags>(line, app_, *invocation.app.formats, FormatFlags::Reading | FormatFlags::Writing);
    setExamples(app_, {"blossom convert part.igs part.step", "blossom convert part.step part.stl part.obj --chord 0.01",
                       "blossom convert model.blossom#sweep-1 sweep.step"});
  }

 private:
  struct Source {
    Document document;
    Evaluated made;
    double readMs = 0;
  };

  /// What is written comes from the very document that a .blossom output gets: the options of the reader are part of it.
  Source readSource(const std::string& text, const std::filesystem::path& file, const Progress& progress) const {
    const Stopwatch watch;
    Source source;
    std::vector<std::string> warnings;
    const FeatureId id = addInput(invocation_, source.document, text, warnings);
    if (!isDocument(file) && !file.empty()) giveOptions(source.document, id, file);
    source.made = evaluateFor(invocation_.app, source.document, id, progress)->evaluated;
    if (isDocument(file)) source.made.shape = mergedShape({{source.document.at(id).name, source.made.shape}});
    source.made.warnings.insert(source.made.warnings.begin(), warnings.begin(), warnings.end());
    source.readMs = watch.elapsedMs();
    return source;
  }

  void giveOptions(Document& document, const FeatureId& import, const std::filesystem::path& file) const {
    const Format& format = *invocation_.app.formats->find(file.extension().string());
    Value options = formats_->reading(format);
    if (options.empty()) return;
    Feature changed = document.at(import);
    changed.parameters[format.id] = std::move(options);
    document = document.with(std::move(changed));
  }

  int run() {
    if (words_.empty())
      throw UsageError("convert needs a file to read.",
                       "\"blossom convert part.igs part.step\" writes an IGES file as STEP.");
    const std::string in = words_.front();
    std::vector<std::string> targets(words_.begin() + 1, words_.end());
    targets.insert(targets.end(), outputs_.begin(), outputs_.end());
    if (targets.empty())
      throw UsageError("convert needs a file to write.", fmt::format("\"blossom info {}\" only looks at the file.", in));
    const std::filesystem::path file = fileOfInput(in);
    auto planned =
        plannedOutputs(*invocation_.app.formats, outputPaths(*invocation_.app.formats, targets), {file}, formats_.get());
    std::vector<const Format*> used{invocation_.app.formats->find(file.extension().string())};
    for (const Output& output : planned) used.push_back(output.format);
    formats_->refuseUnused(used);

    ProgressDisplay display(invocation_);
    const Progress progress = display.progress();
    Source source = readSource(in, file, progress.part(0, 0.5));
    // What cannot be measured is not written either.
    Measures measures = measure(source.made.shape, progress.part(0.5, 0.55));
    const Stopwatch writing;
    planned = writeOutputs(invocation_.app, planned, source.made.shape, source.document, progress.part(0.55, 1));
    Value stats{{"read_ms", source.readMs}, {"write_ms", writing.elapsedMs()}, {"total_ms", 0.0}};
    addReports(planned, measures, source.made.warnings);
    for (const char* counts : {"entities", "skipped"}) stats[counts] = source.made.stats.value(counts, Value::object());
    stats["total_ms"] = invocation_.elapsedMs();
    report(in, planned, measures, stats, source.made.warnings);
    return 0;
  }

  void report(const std::string& in, const std::vector<Output>& planned, const Measures& measures, const Value& stats,
              const std::vector<std::string>& warnings) const {
    std::ostream& out = invocation_.terminal.out;
    if (invocation_.json) {
      printJson(out, {{"input", in},
                      {"outputs", pathsJson(planned)},
                      {"result", resultJson(measures)},
                      {"stats", stats},
                      {"warnings", warnings}});
      return;
    }
    out << in << '\n';
    auto rows = rowsOf(measures);
    addRows(rows, stats);
    for (const Output& output : planned) rows.push_back({"written", output.path.string(), ""});
    printRows(out, rows);
    for (const std::string& warning : warnings) invocation_.terminal.err << "blossom: warning: " << warning << '\n';
  }

  Invocation& invocation_;
  CLI::App& app_;
  std::vector<std::string> words_, outputs_;
  std::unique_ptr<FormatFlags> formats_;
};

}  // namespace

void addConvertCommand(CommandLine& line, Invocation& invocation) {
  line.keep(std::make_shared<ConvertCommand>(line, invocation));
}

}  // namespace blossom
