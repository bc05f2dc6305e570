#include <fmt/format.h>

#include <algorithm>
#include <list>
#include <memory>
#include <ostream>
#include <sstream>

#include "cli/axis_json.h"
#include "cli/command_line.h"
#include "cli/flag_inputs.h"
#include "cli/input.h"
#include "cli/output.h"
#include "cli/progress_display.h"
#include "cli/report.h"
#include "document/edits.h"

namespace blossom {
namespace {

/// One feature type as a command: INPUT.. --parameter value .. -o OUT..
class FeatureCommand {
 public:
  FeatureCommand(CommandLine& line, Invocation& invocation, std::shared_ptr<const FeatureType> type)
      : invocation_(invocation), type_(std::move(type)) {
    const std::string name = line.has(type_->command) ? type_->id : type_->command;
    app_ = &line.add(name, type_->summary, invocation_, [this] { return run(); });
    if (name != type_->id) app_->alias(type_->id);
    declareInputs();
    app_->add_option("-o,--output", outputs_, "Where the result goes; several files as a comma list or with several -o.")
        ->type_name("FILE,..")
        ->expected(1)
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
    parameters_ = std::make_unique<ParameterFlags>(line, *app_, type_->parameters, "", "Parameters");
    made_ = std::make_unique<FlagInputs>(line, *app_, *invocation_.app.registry, *type_);
    formats_ = std::make_unique<FormatFlags>(line, *app_, *invocation_.app.formats, FormatFlags::Writing, kindsGiven());
    setExamples(*app_, type_->examples);
  }

 private:
  /// With the kind of sequences where frames are asked for by a parameter, or may come with an input.
  [[nodiscard]] std::vector<ShapeKind> kindsGiven() const {
    std::vector<ShapeKind> kinds = type_->produces;
    const auto frames = [](const ParameterSpec& spec) { return spec.name == "frames"; };
    const bool sequences = !type_->inputs.empty() || std::any_of(type_->parameters.begin(), type_->parameters.end(), frames);
    if (!kinds.empty() && sequences) kinds.push_back(ShapeKind::Sequence);
    return kinds;
  }

  void declareInputs() {
    if (const ParameterSpec* file = fileParameter()) {
      app_->add_option("FILE", inputs_, file->help)->type_name("")->expected(0, -1);
      return;
    }
    if (type_->inputs.empty()) return;
    std::string help;
    for (const InputSpec& spec : type_->inputs)
      help += (help.empty() ? "" : " ") + fmt::format("{}: {}", spec.name, spec.help);
    app_->add_option("INPUT", inputs_, help + " A file, a document (model.blossom#feature) or a shape written down.")
        ->type_name("")
        ->expected(0, -1);
    declareNamedInputs();
    CommandLine::addDocumentFlags(*app_, invocation_);
  }

  [[nodiscard]] bool takesSingleInputs() const {
    return std::all_of(type_->inputs.begin(), type_->inputs.end(), [](const InputSpec& spec) { return spec.maximum == 1; });
  }

  /// Where every input is a single one, those after the first can also be given by name: --part FILE.
  void declareNamedInputs() {
    if (!takesSingleInputs()) return;
    for (std::size_t i = 1; i < type_->inputs.size(); ++i) {
      const InputSpec& spec = type_->inputs[i];
      const auto namesake = [&](const ParameterSpec& parameter) { return parameter.name == spec.name; };
      if (std::any_of(type_->parameters.begin(), type_->parameters.end(), namesake)) continue;
      named_.emplace_back();
      named_.back().first = i;
      app_->add_option("--" + spec.name, named_.back().second, fmt::format("INPUT {} by name: the {}.", i + 1, spec.name))
          ->type_name("FILE");
    }
  }

  void takeNamedInputs() {
    for (const auto& [index, input] : named_)
      if (!input.empty())
        inputs_.insert(inputs_.begin() + static_cast<std::ptrdiff_t>(std::min(index, inputs_.size())), input);
  }

  [[nodiscard]] std::size_t namedInputs() const {
    return static_cast<std::size_t>(
        std::count_if(named_.begin(), named_.end(), [](const auto& each) { return !each.second.empty(); }));
  }

  /// A feature without inputs that needs one file (import) accepts it as a positional argument.
  [[nodiscard]] const ParameterSpec* fileParameter() const {
    if (!type_->inputs.empty()) return nullptr;
    const ParameterSpec* found = nullptr;
    for (const ParameterSpec& spec : type_->parameters) {
      if (spec.kind != ParameterKind::File || !spec.fallback.is_null() || spec.mayBeAbsent) continue;
      if (found) return nullptr;
      found = &spec;
    }
    return found;
  }

  void checkNumberOfInputs() const {
    if (fileParameter()) return;
    const std::size_t given = inputs_.size() + made_->features().size();
    std::size_t minimum = 0, maximum = 0;
    std::string wanted;
    for (const InputSpec& spec : type_->inputs) {
      minimum += spec.minimum;
      maximum = spec.maximum == anyNumber || maximum == anyNumber ? anyNumber : maximum + spec.maximum;
      wanted += (wanted.empty() ? "" : ", ") + spec.name;
    }
    // Beside what flags make, inputs that may be left out are told by name.
    const bool isTwice = !made_->features().empty() && given - namedInputs() > minimum;
    if (given >= minimum && given <= maximum && !isTwice) return;
    const std::string number = minimum == maximum     ? std::to_string(minimum)
                               : maximum == anyNumber ? fmt::format("at least {}", minimum)
                                                      : fmt::format("{} to {}", minimum, maximum);
    throw UsageError(
        fmt::format("{} takes {} input{} ({}); {} {} given.", app_->get_name(), number, number == "1" ? "" : "s", wanted,
                    given, given == 1 ? "is" : "are"),
        given > maximum || isTwice ? hintForTooMany() : fmt::format("\"blossom {} --help\" shows how.", app_->get_name()),
        ErrorCode::InvalidInput);
  }

  [[nodiscard]] std::string hintForTooMany() const {
    const auto made = made_->features();
    if (made.empty()) return "Several outputs are a comma list: -o a.step,b.stl.";
    return fmt::format("--{} makes one of them; leave it out, or one of the others.",
                       invocation_.app.registry->at(made.front().second.type)->inputByFlags.asks);
  }

  [[nodiscard]] Value parameters() const {
    Value given = parameters_->values();
    if (const ParameterSpec* file = fileParameter(); file && !inputs_.empty()) {
      if (inputs_.size() > 1 || given.contains(file->name))
        throw UsageError(fmt::format("{} takes one file; more are given.", app_->get_name()),
                         "Several outputs are a comma list: -o a.step,b.stl.");
      given[file->name] = parseText(*file, inputs_.front());
    }
    try {
      (void)completed(type_->parameters, given);
    } catch (const Error& error) {
      throw UsageError(error.message(), error.hint(), error.code());
    }
    return given;
  }

  [[nodiscard]] std::vector<Output> outputs() const {
    std::vector<std::filesystem::path> files;
    for (const std::string& input : inputs_) files.push_back(fileOfInput(input));
    auto planned =
        plannedOutputs(*invocation_.app.formats, outputPaths(*invocation_.app.formats, outputs_), files, formats_.get());
    std::vector<const Format*> used;
    used.reserve(planned.size());
    for (const Output& output : planned) {
      used.push_back(output.format);
      if (output.format && !canHold(*output.format, kindsGiven())) refuseUnlessStorable(*output.format, type_->produces);
    }
    formats_->refuseUnused(used);
    return planned;
  }

  void chooseByOutput(const std::vector<Output>& planned, Value& given) const {
    const ChoiceByOutput& choice = type_->byOutput;
    if (choice.parameter.empty() || given.contains(choice.parameter) || planned.empty() || !planned.front().format) return;
    for (const auto& [extensions, value] : choice.byExtensions) {
      std::istringstream words(extensions);
      for (std::string extension; words >> extension;)
        if (extension == planned.front().format->extensions.front()) given[choice.parameter] = value;
    }
  }

  /// The options with which the file at a place of the command line is imported.
  [[nodiscard]] Value importedWith(std::size_t place) const {
    for (const auto& [before, made] : made_->features())
      if (before <= place) ++place;
    if (place >= type_->inputs.size() || !takesSingleInputs()) return Value::object();
    return type_->inputs[place].importedWith;
  }

  /// Files and what is written down, and between them, each in its place, what flags make.
  [[nodiscard]] std::vector<FeatureId> addInputs(Document& document, std::vector<std::string>& warnings) const {
    std::vector<FeatureId> ids;
    for (std::size_t i = 0; i < inputs_.size(); ++i)
      ids.push_back(addInput(invocation_, document, inputs_[i], warnings, importedWith(i)));
    for (auto& [place, made] : made_->features()) {
      made.id = document.freshId(made.id);
      made.name = freeName(document, made.name);
      ids.insert(ids.begin() + static_cast<std::ptrdiff_t>(std::min(place, ids.size())), made.id);
      document = document.with(std::move(made));
    }
    return ids;
  }

  /// The document that this command line describes: its inputs, then the feature itself.
  [[nodiscard]] Document document(const Value& parameters, FeatureId& id, std::vector<std::string>& warnings) const {
    Document result;
    std::vector<FeatureId> inputs;
    if (!fileParameter()) inputs = addInputs(result, warnings);
    for (const FeatureId& input : inputs) {
      Feature hidden = result.at(input);
      hidden.visible = false;
      result = result.with(std::move(hidden));
    }
    Feature feature = newFeature(result, *type_, std::move(inputs));
    feature.parameters = parameters;
    id = feature.id;
    return result.with(std::move(feature));
  }

  int run() {
    takeNamedInputs();
    checkNumberOfInputs();
    Value given = parameters();
    std::vector<Output> planned = outputs();
    chooseByOutput(planned, given);
    std::vector<std::string> warnings;
    FeatureId id;
    const Document made = document(given, id, warnings);
    ProgressDisplay display(invocation_);
    const Progress progress = display.progress();
    Results results;
    const auto result = evaluateFor(invocation_.app, made, id, progress.part(0, 0.8), &results);
    for (const auto& feature : made.features())
      if (const auto each = results.find(feature->id); each != results.end())
        warnings.insert(warnings.end(), each->second->evaluated.warnings.begin(), each->second->evaluated.warnings.end());
    const Stopwatch writing;
    planned = writeOutputs(invocation_.app, planned, result->evaluated.shape, made, progress.part(0.8, 0.95));
    const double writeMs = writing.elapsedMs();
    Measures measures = measured(result->evaluated, progress.part(0.95, 1));
    addReports(planned, measures, warnings);
    Value stats{{"kernel_ms", result->kernelMs}, {"total_ms", 0.0}};
    if (!planned.empty()) stats["write_ms"] = writeMs;
    stats.update(result->evaluated.stats);
    stats["total_ms"] = invocation_.elapsedMs();
    report(result->evaluated.shape, planned, measures, stats, warnings);
    return 0;
  }

  void report(const Shape& shape, const std::vector<Output>& planned, const Measures& measures, const Value& stats,
              const std::vector<std::string>& warnings) const {
    std::ostream& out = invocation_.terminal.out;
    if (invocation_.json) {
      Value json{{"feature", type_->id},
                 {"outputs", pathsJson(planned)},
                 {"result", resultJson(measures)},
                 {"stats", stats},
                 {"warnings", warnings}};
      if (const auto* axis = shape.get<MedialAxis>()) json["result"]["axis"] = axisJson(*axis);
      printJson(out, json);
      return;
    }
    out << type_->title << '\n';
    auto rows = rowsOf(measures);
    addRows(rows, stats);
    for (const Output& output : planned) rows.push_back({"written", output.path.string(), ""});
    printRows(out, rows);
    for (const std::string& warning : warnings) invocation_.terminal.err << "blossom: warning: " << warning << '\n';
  }

  Invocation& invocation_;
  std::shared_ptr<const FeatureType> type_;
  CLI::App* app_ = nullptr;
  std::vector<std::string> inputs_, outputs_;
  std::list<std::pair<std::size_t, std::string>>
      named_;  ///< inputs by name, with their place; a list: the parser keeps addresses
  std::unique_ptr<ParameterFlags> parameters_;
  std::unique_ptr<FlagInputs> made_;
  std::unique_ptr<FormatFlags> formats_;
};

}  // namespace

void addFeatureCommands(CommandLine& line, Invocation& invocation) {
  for (const auto& type : invocation.app.registry->types())
    line.keep(std::make_shared<FeatureCommand>(line, invocation, type));
}

}  // namespace blossom
