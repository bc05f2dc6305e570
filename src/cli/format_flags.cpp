#include "cli/format_flags.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

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

/// Options known well enough to be given without their format.
struct CommonFlag {
  const char *name, *placeholder, *help;
};
constexpr std::array<CommonFlag, 2> commonFlags{{
    {"chord", "LENGTH", "Largest distance between a shape and the polygons written for it, for all outputs at once."},
    {"post", "NAME", "The control that G-code is written for; short for --gcode.post."},
}};

}  // namespace

bool canHold(const Format& format, const std::vector<ShapeKind>& kinds) {
  const bool film = format.writes == std::vector{ShapeKind::Sequence};
  return kinds.empty() || std::any_of(kinds.begin(), kinds.end(), [&](ShapeKind kind) {
           return kind == ShapeKind::Sequence ? film : canStore(format, kind);
         });
}

FormatFlags::FormatFlags(CommandLine& line, CLI::App& app, const FormatRegistry& formats, int sides,
                         const std::vector<ShapeKind>& written) {
  for (const Format& format : formats.formats()) {
    std::vector<ParameterSpec> specs = optionsOf(format, canHold(format, written) ? sides : sides & ~Writing);
    if (!specs.empty())
      entries_.push_back({format.id, format.title, ParameterFlags(line, app, specs, format.id + ".", "File options")});
  }
  if (!(sides & Writing)) return;
  for (const CommonFlag& flag : commonFlags) {
    const std::string name = std::string("--") + flag.name;
    const auto has = [&](const Format& format) { return canHold(format, written) && named(format.writeOptions, flag.name); };
    const bool known = std::any_of(formats.formats().begin(), formats.formats().end(), has);
    if (!known || app.get_option_no_throw(name)) continue;
    common_.push_back({flag.name, app.add_option(name, flag.help)->type_name(flag.placeholder)->group("File options")});
  }
}

Value FormatFlags::values(const Format& format, const std::vector<ParameterSpec>& declared) const {
  Value values = Value::object();
  for (const auto& [name, option] : common_) {
    const ParameterSpec* spec = named(declared, name);
    if (!spec || option->count() == 0) continue;
    try {
      values[name] = parseText(*spec, option->results().back());
    } catch (const Error& error) {
      throw UsageError(namingFlag("--" + name, spec->name, error.message()), error.hint());
    }
  }
  for (const Entry& entry : entries_) {
    if (entry.id != format.id) continue;
    const Value all = entry.flags.values();
    for (const auto& [name, value] : all.items())
      if (named(declared, name)) values[name] = value;
  }
  return values;
}

Value FormatFlags::reading(const Format& format) const { return values(format, format.readOptions); }

Value FormatFlags::writing(const Format& format) const { return values(format, format.writeOptions); }

void FormatFlags::refuseUnused(const std::vector<const Format*>& used) const {
  for (const Entry& entry : entries_) {
    const std::string flag = entry.flags.firstUsed();
    if (flag.empty() ||
        std::any_of(used.begin(), used.end(), [&](const Format* format) { return format && format->id == entry.id; }))
      continue;
    throw UsageError(fmt::format("{} is given, but no file here is {}.", flag, entry.title));
  }
}

}  // namespace blossom
