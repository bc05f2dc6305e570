#include <fmt/format.h>

#include <ostream>

#include "app/reference_page.h"
#include "cli/command_line.h"
#include "cli/parameter_flags.h"
#include "cli/report.h"
#include "feature/acceptance.h"

namespace blossom {
namespace {

Value specJson(const ParameterSpec& spec) {
  Value json{{"name", spec.name},
             {"help", spec.help},
             {"kind", parameterKindName(spec.kind)},
             {"takes", describe(spec)},
             {"default", spec.fallback}};
  if (spec.minimum) json[spec.aboveMinimum ? "above" : "least"] = *spec.minimum;
  if (spec.maximum) json["greatest"] = *spec.maximum;
  if (!spec.noneMeans.empty()) json["none_means"] = spec.noneMeans;
  if (!spec.condition.choice.empty())
    json["only_for"] = {{"parameter", spec.condition.choice}, {"values", spec.condition.values}};
  if (!spec.filling.input.empty())
    json["one_for_each"] = {{"input", spec.filling.input}, {"more", spec.filling.more}, {"like", spec.filling.like}};
  if (!spec.choices.empty()) json["choices"] = spec.choices;
  if (!spec.fileTypes.empty()) json["file_types"] = spec.fileTypes;
  for (const ParameterSpec& field : spec.fields) json["fields"].push_back(specJson(field));
  return json;
}

Value kindsJson(const std::vector<ShapeKind>& kinds) {
  Value json = Value::array();
  for (const ShapeKind kind : kinds) json.push_back(shapeKindName(kind));
  return json;
}

Value inputJson(const InputSpec& spec) {
  Value json{{"name", spec.name}, {"help", spec.help}, {"kinds", kindsJson(spec.kinds)}, {"least", spec.minimum}};
  json["sequences"] = takenByFrames(spec, Sequence()) ? "frame by frame" : "as they are";
  json["most"] = spec.maximum == anyNumber ? Value() : Value(spec.maximum);
  return json;
}

Value typeJson(const FeatureType& type) {
  Value json{{"id", type.id}, {"command", type.command}, {"title", type.title}, {"summary", type.summary}};
  json["inputs"] = Value::array();
  for (const InputSpec& spec : type.inputs) json["inputs"].push_back(inputJson(spec));
  json["parameters"] = Value::array();
  for (const ParameterSpec& spec : type.parameters) json["parameters"].push_back(specJson(spec));
  json["gives"] = kindsJson(type.produces);
  json["examples"] = type.examples;
  return json;
}

void printType(std::ostream& out, const FeatureType& type) {
  out << type.title << "  (" << type.id << ")\n" << type.summary << '\n';
  if (!type.inputs.empty()) out << "\nInputs\n";
  std::vector<std::vector<std::string>> lines;
  for (const InputSpec& spec : type.inputs)
    lines.push_back({"  " + spec.name, howMany(spec), kindsText(spec.kinds), spec.help});
  if (!lines.empty()) printTable(out, {"", "", "", ""}, lines);
  if (takesByFrames(type)) out << "\nA sequence is taken frame by frame; the result is a sequence, too.\n";
  out << "\nGives " << kindsText(type.produces) << ".\n";
  lines.clear();
  for (const ParameterSpec& spec : type.parameters)
    lines.push_back(
        {"  --" + spec.name, describe(spec), spec.fallback.is_null() ? "" : formatText(spec, spec.fallback), spec.help});
  if (!lines.empty()) {
    out << "\nParameters\n";
    printTable(out, {"  FLAG", "TAKES", "DEFAULT", "HELP"}, lines);
  }
  for (const std::string& example : type.examples)
    out << (&example == &type.examples.front() ? "\nExamples\n" : "") << "  " << example << '\n';
}

class FeaturesCommand {
 public:
  FeaturesCommand(CommandLine& line, Invocation& invocation) : invocation_(invocation) {
    CLI::App& app =
        line.add("features", "List the features, or all there is to know about one.", invocation, [this] { return run(); });
    app.add_option("FEATURE", name_, "Command or id of a feature.")->type_name("");
    app.add_flag("--markdown", markdown_, "Print the manual's pages.");
    setExamples(app, {"blossom features", "blossom features sweep", "blossom features --markdown >reference.md"});
  }

 private:
  int run() {
    std::ostream& out = invocation_.terminal.out;
    if (!name_.empty()) {
      const auto type = invocation_.app.registry->at(name_);
      if (invocation_.json)
        printJson(out, typeJson(*type));
      else if (markdown_)
        out << referencePage(*type);
      else
        printType(out, *type);
      return 0;
    }
    Value all = Value::array();
    std::vector<std::vector<std::string>> lines;
    for (const auto& type : invocation_.app.registry->types()) {
      all.push_back(typeJson(*type));
      lines.push_back({type->command, type->id, type->summary});
    }
    if (invocation_.json)
      printJson(out, {{"features", all}});
    else if (markdown_)
      for (const auto& type : invocation_.app.registry->types()) out << referencePage(*type) << '\n';
    else
      printTable(out, {"COMMAND", "ID", "SUMMARY"}, lines);
    return 0;
  }

  Invocation& invocation_;
  std::string name_;
  bool markdown_ = false;
};

}  // namespace

void addFeaturesCommand(CommandLine& line, Invocation& invocation) {
  line.keep(std::make_shared<FeaturesCommand>(line, invocation));
}

}  // namespace blossom
