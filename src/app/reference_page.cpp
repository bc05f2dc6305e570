#include "app/reference_page.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

#include "feature/acceptance.h"
#include "geometry/shape/kind_names.h"

namespace blossom {
namespace {

// Declarations are plain text: what Markdown would read as marks is shown as it stands.
std::string plain(std::string_view text) {
  std::string result;
  result.reserve(text.size());
  for (const char c : text) {
    if (c == '\n') {
      result += ' ';
      continue;
    }
    if (std::string_view("\\`*_|<>[]#").find(c) != std::string_view::npos) result += '\\';
    result += c;
  }
  return result;
}

// Code in a cell of a table: a bar would end the cell.
std::string code(std::string_view text) {
  std::string result = "`";
  for (const char c : text) result += c == '|' ? std::string("\\|") : std::string(1, c);
  return result + '`';
}

std::string defaultText(const ParameterSpec& spec) {
  if (spec.fallback.is_null()) return spec.mayBeAbsent ? "none" : "must be given";
  if (spec.kind == ParameterKind::Flag) return spec.fallback.get<bool>() ? "on" : "off";
  const std::string text = formatText(spec, spec.fallback);
  return text.empty() ? "empty" : code(text);
}

// What a list or record holds follows in rows of its own, indented by the name it belongs to.
void addRows(std::string& page, const ParameterSpec& spec, const std::string& inside) {
  const std::string name = inside + spec.name;
  page += fmt::format("| {} | {} | {} | {} |\n", code(name), plain(describe(spec)), defaultText(spec), plain(spec.help));
  const bool listOfRecords =
      spec.kind == ParameterKind::List && !spec.fields.empty() && spec.fields.front().kind == ParameterKind::Record;
  const auto& fields = listOfRecords ? spec.fields.front().fields : spec.fields;
  if (listOfRecords || spec.kind == ParameterKind::Record)
    for (const ParameterSpec& field : fields) addRows(page, field, name + (listOfRecords ? "[]." : "."));
}

std::string usage(const FeatureType& type) {
  std::string line = "blossom " + type.command;
  for (const InputSpec& input : type.inputs) {
    const std::string name = input.maximum > 1 ? fmt::format("{0} {0}..", input.name) : input.name;
    line += input.minimum == 0 ? fmt::format(" [{}]", name) : ' ' + name;
  }
  for (const ParameterSpec& spec : type.parameters)
    if (spec.fallback.is_null() && !spec.mayBeAbsent) line += fmt::format(" --{} ..", spec.name);
  return line + " -o FILE";
}

}  // namespace

std::string howMany(const InputSpec& spec) {
  if (spec.minimum == 1 && spec.maximum == 1) return "one";
  if (spec.minimum == spec.maximum) return std::to_string(spec.minimum);
  return spec.maximum == anyNumber ? fmt::format("{} or more", spec.minimum)
                                   : fmt::format("{} to {}", spec.minimum, spec.maximum);
}

std::string kindsText(const std::vector<ShapeKind>& kinds) { return kinds.empty() ? "any shape" : kindNames(kinds); }

bool takesByFrames(const FeatureType& type) {
  return std::any_of(type.inputs.begin(), type.inputs.end(),
                     [](const InputSpec& input) { return takenByFrames(input, Sequence()); });
}

std::string referencePageName(const std::string& featureId) { return "reference/" + featureId + ".md"; }

std::string referencePage(const FeatureType& type) {
  std::string page = fmt::format("# {}\n\n{}\n\nCommand {} · feature type {}\n", plain(type.title), plain(type.summary),
                                 code(type.command), code(type.id));
  page += "\n## Inputs\n\n";
  if (type.inputs.empty()) page += "None: it is made from its parameters alone.\n";
  if (!type.inputs.empty()) page += "| Input | How many | Takes | Meaning |\n|---|---|---|---|\n";
  for (const InputSpec& input : type.inputs)
    page +=
        fmt::format("| {} | {} | {} | {} |\n", plain(input.name), howMany(input), kindsText(input.kinds), plain(input.help));
  if (takesByFrames(type)) page += "\nA sequence is taken frame by frame; the result is a sequence, too.\n";
  page += fmt::format("\n## Result\n\nGives {}.\n", kindsText(type.produces));
  page += "\n## Parameters\n\n";
  if (type.parameters.empty()) page += "None.\n";
  if (!type.parameters.empty()) page += "| Parameter | Takes | Default | Meaning |\n|---|---|---|---|\n";
  for (const ParameterSpec& spec : type.parameters) addRows(page, spec, {});
  page += fmt::format("\n## On the command line\n\n```sh\n{}\n", usage(type));
  for (const std::string& example : type.examples) page += example + '\n';
  return page + "```\n";
}

}  // namespace blossom
