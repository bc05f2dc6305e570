#include "feature/registry.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <set>

#include "core/error.h"

namespace blossom {
namespace {

[[noreturn]] void broken(const std::string& what, const std::string& why) {
  throw Error(ErrorCode::PluginBroken, fmt::format("{} {}.", what, why),
              "This is a mistake in the declaration of the feature type.");
}

/// Lower-case letters, digits and hyphens, as flags and commands are written; `dots` allows "plugin.name".
bool isName(std::string_view text, bool dots = false) {
  if (text.empty() || text.front() < 'a' || text.front() > 'z') return false;
  return std::all_of(text.begin(), text.end(), [&](char c) {
    return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '-' || (dots && (c == '.' || c == '_'));
  });
}

/// Flags that every command has, and the "no-" by which the command line turns a flag off.
bool isReserved(const std::string& name) {
  constexpr std::array<std::string_view, 8> common{"allow-files", "help",    "json",    "output",
                                                   "progress",    "salvage", "threads", "version"};
  return std::find(common.begin(), common.end(), name) != common.end() || name.starts_with("no-");
}

/// Checks a declaration and brings its default into canonical form.
void settle(const std::string& owner, ParameterSpec& spec, bool element = false) {
  const std::string what = fmt::format("The parameter \"{}\" of {}", spec.name, owner);
  if (!element && !isName(spec.name)) broken(what, "has no proper name; use lower-case letters, digits and hyphens");
  if (spec.kind == ParameterKind::Choice && spec.choices.empty()) broken(what, "offers no choices");
  if (spec.kind == ParameterKind::List && spec.fields.size() != 1) broken(what, "must declare exactly one element");
  if (spec.kind == ParameterKind::Record && spec.fields.empty()) broken(what, "declares no fields");
  std::set<std::string> names;
  for (auto& field : spec.fields) {
    settle(owner, field, spec.kind == ParameterKind::List);
    if (!names.insert(field.name).second) broken(what, fmt::format("declares the field \"{}\" twice", field.name));
  }
  if (spec.fallback.is_null()) return;
  try {
    spec.fallback = checked(spec, spec.fallback);
  } catch (const Error& e) {
    broken(what, "has a default that it does not allow itself: " + e.message());
  }
}

void checkInputByFlags(const std::string& what, const FeatureType& type, const std::set<std::string>& parameters) {
  const InputByFlags& flags = type.inputByFlags;
  if (flags.asks.empty()) return;
  if (!type.inputs.empty()) broken(what, "cannot be an input by flags alone, for it takes inputs itself");
  if (type.produces.empty()) broken(what, "cannot be an input by flags alone, for it does not declare what it gives");
  for (const std::string& name : flags.plain)
    if (!parameters.contains(name)) broken(what, fmt::format("has no parameter \"{}\" to be an input by", name));
  if (!parameters.contains(flags.asks)) broken(what, fmt::format("has no parameter \"{}\" to be an input by", flags.asks));
}

void checkDeclaration(FeatureType& type) {
  const std::string what = fmt::format("The feature type \"{}\"", type.id);
  if (!isName(type.id, true) || type.id.find('.') == std::string::npos) broken(what, "has no proper id; write plugin.name");
  if (!isName(type.command))
    broken(what, fmt::format("has the command \"{}\"; use lower-case letters, digits and hyphens", type.command));
  if (type.title.empty() || type.summary.empty()) broken(what, "has no title or no summary");
  if (!type.evaluate) broken(what, "cannot be evaluated");
  for (const auto& input : type.inputs)
    if (input.name.empty() || input.minimum > input.maximum || input.maximum == 0)
      broken(what, fmt::format("declares the input \"{}\" wrongly", input.name));
  std::set<std::string> names;
  for (auto& spec : type.parameters) {
    settle(type.id, spec);
    if (isReserved(spec.name))
      broken(fmt::format("The parameter \"{}\" of {}", spec.name, type.id), "has a name that every command needs itself");
    if (!names.insert(spec.name).second) broken(what, fmt::format("declares the parameter \"{}\" twice", spec.name));
  }
  checkInputByFlags(what, type, names);
}

}  // namespace

void Registry::add(FeatureType type) {
  checkDeclaration(type);
  for (const auto& other : types_) {
    if (other->id == type.id) broken(fmt::format("The feature type \"{}\"", type.id), "exists already");
    if (other->command == type.command)
      broken(fmt::format("The command \"{}\" of {}", type.command, type.id), fmt::format("is taken by {}", other->id));
  }
  types_.push_back(std::make_shared<const FeatureType>(std::move(type)));
}

void Registry::add(LiteralForm form) {
  const std::string what = fmt::format("The literal form \"{}\"", form.name);
  if (!isName(form.name)) broken(what, "has no proper name");
  if (!form.parse) broken(what, "cannot be read");
  for (const auto& other : literals_)
    if (other.name == form.name) broken(what, "exists already");
  literals_.push_back(std::move(form));
}

void Registry::merge(const Registry& other) {
  Registry all = *this;
  for (const auto& type : other.types_) all.add(*type);
  for (const auto& form : other.literals_) all.add(form);
  *this = std::move(all);
}

std::shared_ptr<const FeatureType> Registry::find(std::string_view commandOrId) const {
  for (const auto& type : types_)
    if (type->id == commandOrId || type->command == commandOrId) return type;
  return nullptr;
}

std::shared_ptr<const FeatureType> Registry::at(std::string_view commandOrId) const {
  if (auto type = find(commandOrId)) return type;
  std::vector<std::string> known;
  for (const auto& type : types_) known.insert(known.end(), {type->command, type->id});
  const std::string near = nearestName(commandOrId, known);
  throw Error(ErrorCode::NotFound, fmt::format("There is no feature \"{}\".", commandOrId),
              near.empty() ? "\"blossom features\" lists all that there are." : fmt::format("Did you mean {}?", near));
}

Shape Registry::literal(std::string_view text) const {
  const auto colon = text.find(':');
  const std::string_view name = text.substr(0, colon);
  for (const auto& form : literals_)
    if (form.name == name) return form.parse(colon == std::string_view::npos ? std::string_view() : text.substr(colon + 1));
  return {};
}

}  // namespace blossom
