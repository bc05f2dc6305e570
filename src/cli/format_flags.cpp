#include "cli/format_flags.h"

#include <fmt/format.h>

#include <algorithm>

namespace blossom {
namespace {

const ParameterSpec* named(const std::vector<ParameterSpec>& specs, const std::string& name) {
  const auto found = std::find_if(specs.begin(), specs.end(), [&](const auto& spec) { return spec.name == name; });
  return found == specs.end() ? nullptr : &*found;
}

/// An option that reader and writer share is one flag.
std::vector<ParameterSpec> optionsOf(const Format& format, int sides) {
  std::vector<ParameterSpec> specs;
  if (sides & FormatFlags::Writing) specs = format.writeOptions;
  if (sides & FormatFlags::Reading)
    for (const ParameterSpec& spec : format.readOptions)
      if (!named(specs, spec.name)) specs.push_back(spec);
  return specs;
}

}  // namespace

FormatFlags::FormatFlags(CommandLine& line, CLI::App& app, const FormatRegistry& formats, int sides) {
  bool anyChord = false;
  for (const Format& format : formats.formats()) {
    std::vector<ParameterSpec> specs = optionsOf(format, sides);
    anyChord = anyChord || named(format.writeOptions, "chord");
    if (!specs.empty())
      entries_.push_back(
          {format.id, format.title, ParameterFlags(line, app, std::move(specs), format.id + ".", "File options")});
  }
  if (anyChord && (sides & Writing) && !app.get_option_no_throw("--chord"))
    chord_ = app.add_option("--chord",
                            "Largest distance between a shape and the polygons written for it, for all outputs at once.")
                 ->type_name("LENGTH")
                 ->group("File options");
}

Value FormatFlags::given(const Format& format, const std::vector<ParameterSpec>& declared) const {
  Value values = Value::object();
  if (const ParameterSpec* chord = named(declared, "chord"); chord && chord_ && chord_->count() > 0) {
    try {
      values["chord"] = parseText(*chord, chord_->results().back());
    } catch (const Error& error) {
      throw UsageError(namingFlag("--chord", chord->name, error.message()), error.hint());
    }
  }
  for (const Entry& entry : entries_) {
    if (entry.id != format.id) continue;
    const Value all = entry.flags.given();
    for (const auto& [name, value] : all.items())
      if (named(declared, name)) values[name] = value;
  }
  return values;
}

Value FormatFlags::reading(const Format& format) const { return given(format, format.readOptions); }

Value FormatFlags::writing(const Format& format) const { return given(format, format.writeOptions); }

void FormatFlags::refuseUnused(const std::vector<const Format*>& used) const {
  for (const Entry& entry : entries_) {
    const std::string flag = entry.flags.firstGiven();
    if (flag.empty() ||
        std::any_of(used.begin(), used.end(), [&](const Format* format) { return format && format->id == entry.id; }))
      continue;
    throw UsageError(fmt::format("{} is given, but no file here is {}.", flag, entry.title));
  }
}

}  // namespace blossom
