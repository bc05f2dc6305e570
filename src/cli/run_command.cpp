#include <fmt/format.h>

#include <algorithm>
#include <ostream>

#include "cli/command_line.h"
#include "cli/feature_table.h"
#include "cli/input.h"
#include "cli/output.h"
#include "cli/progress_display.h"
#include "cli/report.h"
#include "document/edits.h"
#include "document/file_access.h"
#include "document/file_values.h"
#include "document/named_numbers.h"
#include "geometry/occt/merged_shape.h"
#include "parameter/written.h"

namespace blossom {
namespace {

struct Export {
  FeatureId feature;  ///< empty: the last one
  std::string path;
};

/// A document evaluated as a whole, perhaps with other values, and exported.
class RunCommand {
 public:
  RunCommand(CommandLine& line, Invocation& invocation)
      : invocation_(invocation),
        app_(line.add("run", "Evaluate all features of a document.", invocation, [this] { return run(); })) {
    app_.add_option("DOC", file_, "A .blossom document, or any file that Blossom reads.")->type_name("");
    app_.add_option("--set", settings_,
                    "Another value for a parameter of a feature, or for a named number of the document; may be repeated.")
        ->type_name("FEATURE.PARAMETER[.FIELD]=VALUE|NUMBER=VALUE")
        ->expected(1)
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
    app_.add_option("--export,-o,--output", exports_,
                    "Write a feature (the last one if none is named); may be repeated. A .blossom file takes the document.")
        ->type_name("[FEATURE=]FILE")
        ->expected(1)
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
    CommandLine::addDocumentFlags(app_, invocation_);
    formats_ = std::make_unique<FormatFlags>(line, app_, *invocation.app.formats, FormatFlags::Writing);
    setExamples(app_, {"blossom run model.blossom --json",
                       "blossom run model.blossom --set sweep-1.tolerance=0.01 --export sweep-1=sweep.step",
                       "blossom run model.blossom --set sweep-1.solid=yes --export other.blossom"});
  }

 private:
  /// By its id, else its name, else the command or the id of its type where only one feature is of that type.
  const Feature& featureNamed(const Document& document, const std::string& name) const {
    const Feature* byName = nullptr;
    std::vector<const Feature*> ofType;
    std::vector<std::string> known;
    for (const auto& each : document.features()) {
      if (each->id == name) return *each;
      if (each->name == name) byName = each.get();
      const auto type = invocation_.app.registry->find(each->type);
      if (each->type == name || (type && type->command == name)) ofType.push_back(each.get());
      known.push_back(each->id);
    }
    if (byName) return *byName;
    if (ofType.size() == 1) return *ofType.front();
    if (ofType.size() > 1)
      throw UsageError(fmt::format("The document has {} features of the type {}.", ofType.size(), name),
                       fmt::format("Name one of them, such as {}.", ofType.front()->id), ErrorCode::NotFound);
    const std::string near = nearestName(name, known);
    throw UsageError(
        fmt::format("The document has no feature \"{}\".", name),
        near.empty() ? fmt::format("\"blossom info {}\" lists its features.", file_) : fmt::format("Did you mean {}?", near),
        ErrorCode::NotFound);
  }

  [[nodiscard]] bool names(const Document& document, const std::string& name) const {
    const auto features = document.features();
    return std::any_of(features.begin(), features.end(), [&](const auto& each) {
      const auto type = invocation_.app.registry->find(each->type);
      return each->id == name || each->name == name || each->type == name || (type && type->command == name);
    });
  }

  /// What stands in front of the = of --set.
  struct Setting {
    std::string feature, parameter, field;  ///< of a record; else empty
  };

  Setting settingOf(const Document& document, const std::string& text) const {
    const auto equals = text.find('=');
    const auto dot = text.substr(0, equals).rfind('.');
    if (equals == std::string::npos || dot == std::string::npos)
      throw UsageError(fmt::format("\"{}\" is not FEATURE.PARAMETER=VALUE, and no named number.", text),
                       "Write for example --set sweep-1.tolerance=0.01.");
    Setting setting{text.substr(0, dot), text.substr(dot + 1, equals - dot - 1), {}};
    const auto inner = setting.feature.rfind('.');
    if (inner == std::string::npos || names(document, setting.feature) || !names(document, setting.feature.substr(0, inner)))
      return setting;
    return {setting.feature.substr(0, inner), setting.feature.substr(inner + 1), setting.parameter};
  }

  /// The declaration that a value is read by: of the parameter, or of the field of it that is named.
  static const ParameterSpec& declared(const FeatureType& type, const Setting& setting) {
    const auto named = [](const std::vector<ParameterSpec>& specs, const std::string& name) {
      const auto found = std::find_if(specs.begin(), specs.end(), [&](const auto& each) { return each.name == name; });
      return found == specs.end() ? nullptr : &*found;
    };
    const ParameterSpec* spec = named(type.parameters, setting.parameter);
    if (!spec) refuseParameter(type, setting.parameter);
    if (setting.field.empty()) return *spec;
    const ParameterSpec* field = spec->kind == ParameterKind::Record ? named(spec->fields, setting.field) : nullptr;
    if (!field) refuseParameter(type, setting.parameter + '.' + setting.field);
    return *field;
  }

  /// A file that is typed here begins at the current folder, whatever the document's own begin at, and may be read.
  static Value typed(const ParameterSpec& spec, const std::string& text, const Document& document) {
    Value value = writtenText(spec, text, namedNumbersOf(document));
    eachFile(spec, value, [&](Value& file) {
      const std::filesystem::path path = std::filesystem::absolute(file.value("path", std::string()));
      if (document.access()) document.access()->allow(path);
      file["path"] = path.string();
    });
    return value;
  }

  /// "width=60 mm" for a named number of the document; nothing when the text does not name one.
  std::optional<Document> withNumberSet(const Document& document, const std::string& text) const {
    const auto equals = text.find('=');
    std::vector<NamedNumber> table = numbersOf(document);
    const auto row = std::find_if(table.begin(), table.end(),
                                  [&](const NamedNumber& each) { return each.name == text.substr(0, equals); });
    if (equals == std::string::npos || row == table.end()) return std::nullopt;
    row->value = text.substr(equals + 1);
    try {
      return withNumbers(document, *invocation_.app.registry, table);
    } catch (const Error& error) {
      throw UsageError("--set " + error.message(), error.hint(), error.code());
    }
  }

  /// "sweep-1.tolerance=0.01", "import-1.control-points.degree-u=1"
  Document withSetting(const Document& document, const std::string& text) const {
    if (auto changed = withNumberSet(document, text)) return *std::move(changed);
    const Setting setting = settingOf(document, text);
    const std::size_t equals = text.find('=');
    Feature changed = featureNamed(document, setting.feature);
    const auto type = invocation_.app.registry->find(changed.type);
    if (!type)
      throw Error(ErrorCode::PluginBroken, fmt::format("The feature type {} is not there.", changed.type),
                  "\"blossom plugins\" lists the plugins that are loaded.");
    const ParameterSpec& spec = declared(*type, setting);
    try {
      Value& value = changed.parameters[setting.parameter];
      if (!setting.field.empty() && !value.is_object()) value = Value::object();
      (setting.field.empty() ? value : value[setting.field]) = typed(spec, text.substr(equals + 1), document);
      (void)completed(type->parameters, changed.parameters);
    } catch (const Error& error) {
      throw UsageError(namingFlag("--set " + text.substr(0, equals), spec.name, error.message()), error.hint(),
                       error.code());
    }
    return document.with(std::move(changed));
  }

  [[noreturn]] static void refuseParameter(const FeatureType& type, const std::string& name) {
    std::vector<std::string> known;
    for (const ParameterSpec& each : type.parameters) known.push_back(each.name);
    const std::string near = nearestName(name, known);
    throw UsageError(fmt::format("{} has no parameter \"{}\".", type.title, name),
                     near.empty() ? fmt::format("\"blossom features {}\" lists its parameters.", type.command)
                                  : fmt::format("Did you mean {}?", near),
                     ErrorCode::NotFound);
  }

  /// "FEATURE=FILE" or "FILE"; a = in the name of a folder or file is none of ours.
  std::vector<Export> exportsFor(const Document& document) const {
    std::vector<Export> all;
    for (const std::string& text : exports_) {
      const auto equals = text.find('=');
      if (equals == std::string::npos || text.find('/') < equals) {
        for (const std::string& path : outputPaths(*invocation_.app.formats, {text})) all.push_back({"", path});
      } else {
        const FeatureId id = featureNamed(document, text.substr(0, equals)).id;
        for (const std::string& path : outputPaths(*invocation_.app.formats, {text.substr(equals + 1)}))
          all.push_back({id, path});
      }
    }
    return all;
  }

  /// A document may be saved over itself (it was read whole and is replaced as a whole); other outputs must not replace the
  /// input.
  std::vector<Output> planned(const std::vector<Export>& exports) const {
    std::vector<std::string> shapes, documents;
    for (const Export& each : exports) (isDocument(each.path) ? documents : shapes).push_back(each.path);
    const std::filesystem::path file = fileOfInput(file_);
    (void)plannedOutputs(*invocation_.app.formats, shapes, {file}, formats_.get());
    // What was salvaged must not overwrite what could not be read.
    const std::vector<std::filesystem::path> kept{invocation_.salvage ? file : std::filesystem::path()};
    (void)plannedOutputs(*invocation_.app.formats, documents, kept, nullptr);
    std::vector<Output> outputs;
    std::vector<const Format*> used;
    for (const Export& each : exports) {
      const auto inputs = isDocument(each.path) ? std::vector<std::filesystem::path>() : std::vector{file};
      outputs.push_back(plannedOutputs(*invocation_.app.formats, {each.path}, inputs, formats_.get()).front());
      used.push_back(outputs.back().format);
    }
    formats_->refuseUnused(used);
    return outputs;
  }

  int run() {
    if (file_.empty())
      throw UsageError("run needs a document.", "\"blossom run model.blossom\" evaluates all its features.");
    OpenedDocument opened = openInput(invocation_, file_);
    for (const std::string& setting : settings_) opened.document = withSetting(opened.document, setting);
    const auto exports = exportsFor(opened.document);
    const auto outputs = planned(exports);
    (void)lastFeature(opened.document);

    ProgressDisplay display(invocation_);
    const Progress progress = display.progress();
    const Results results = Evaluator(invocation_.app.registry).evaluate(opened.document, progress.part(0, 0.8));
    const Value features = featuresJson(opened.document, results, progress.part(0.8, 0.85));
    std::vector<Output> written;
    std::optional<Error> problem = firstFailure(opened.document, results);
    for (std::size_t i = 0; i < exports.size(); ++i) {
      try {
        const auto files = writeOne(opened.document, results, exports[i], outputs[i], progress.part(0.85, 1));
        written.insert(written.end(), files.begin(), files.end());
      } catch (const Error& error) {
        if (error.code() == ErrorCode::Cancelled) throw;
        if (!problem) problem = error;
      }
    }
    Measures none;
    addReports(written, none, opened.warnings);
    report(features, opened.warnings, written, problem);
    return problem ? 1 : 0;
  }

  static std::optional<Error> firstFailure(const Document& document, const Results& results) {
    for (const auto& feature : document.features())
      if (const auto found = results.find(feature->id); found != results.end() && found->second->error)
        return found->second->error;
    return {};
  }

  std::vector<Output> writeOne(const Document& document, const Results& results, const Export& wanted, const Output& output,
                               const Progress& progress) const {
    if (!output.format) return writeOutputs(invocation_.app, {output}, {}, document, progress);
    const FeatureId id = wanted.feature.empty() ? lastFeature(document).id : wanted.feature;
    const auto found = results.find(id);
    if (found == results.end())
      throw Error(ErrorCode::InvalidInput, fmt::format("The feature \"{}\" is suppressed and was not exported.", id));
    if (found->second->error)
      throw Error(found->second->error->code(), fmt::format("{} was not written, because \"{}\" failed.", wanted.path, id),
                  found->second->error->message());
    const Shape shape = mergedShape({{document.at(id).name, found->second->evaluated.shape}});
    return writeOutputs(invocation_.app, {output}, shape, document, progress);
  }

  void report(const Value& features, const std::vector<std::string>& warnings, const std::vector<Output>& written,
              const std::optional<Error>& problem) const {
    std::ostream& out = invocation_.terminal.out;
    if (invocation_.json) {
      Value all{{"document", file_}, {"features", features}, {"outputs", pathsJson(written)}};
      all["stats"] = {{"total_ms", invocation_.elapsedMs()}};
      all["warnings"] = warnings;
      if (problem) all["error"] = toJson(*problem);
      return printJson(out, all);
    }
    printFeatureTable(out, features);
    for (const Output& output : written) out << "written  " << output.path.string() << '\n';
    for (const std::string& warning : warnings) invocation_.terminal.err << "blossom: warning: " << warning << '\n';
    for (const Value& row : features)
      for (const auto& warning : row.value("warnings", Value::array()))
        invocation_.terminal.err << "blossom: warning: " << warning.get<std::string>() << '\n';
    if (problem)
      invocation_.terminal.err << "blossom: " << problem->message() << '\n'
                               << (problem->hint().empty() ? "" : "  " + problem->hint() + "\n");
  }

  Invocation& invocation_;
  CLI::App& app_;
  std::string file_;
  std::vector<std::string> settings_, exports_;
  std::unique_ptr<FormatFlags> formats_;
};

}  // namespace

void addRunCommand(CommandLine& line, Invocation& invocation) { line.keep(std::make_shared<RunCommand>(line, invocation)); }

}  // namespace blossom
