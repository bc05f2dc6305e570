#include "feature/declaration.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <set>

#include "core/error.h"
#include "feature/frame_keys.h"

namespace blossom::declaration {
namespace {

/// Flags that every command has, and the "no-" by which the command line turns a flag off.
bool isReserved(const std::string& name) {
  constexpr std::array<std::string_view, 8> common{"allow-files", "help",    "json",    "output",
                                                   "progress",    "salvage", "threads", "version"};
  return std::find(common.begin(), common.end(), name) != common.end() || name.starts_with("no-");
}

/// What is filled is a whole parameter, or each item of one.
void refuseInnerFilling(const std::string& what, const ParameterSpec& spec, const ParameterSpec& field, bool element) {
  const bool items = spec.kind == ParameterKind::List && !element;
  if (field.filling != ListFilling() && !items)
    broken(what, "holds a list that is filled; only whole parameters and the items of one can be");
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
    if (!field.condition.choice.empty() || !field.inputCondition.input.empty())
      broken(what, "holds a field with a condition; only whole parameters can have one");
    refuseInnerFilling(what, spec, field, element);
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

/// What a parameter applies for is read off a choice that always counts itself: there is one step to follow, and no circle.
void checkConditions(const std::string& owner, const std::vector<ParameterSpec>& specs) {
  for (const ParameterSpec& spec : specs) {
    const ParameterCondition& condition = spec.condition;
    if (condition.choice.empty() && condition.values.empty()) continue;
    const std::string what = fmt::format("The parameter \"{}\" of {}", spec.name, owner);
    const auto on =
        std::find_if(specs.begin(), specs.end(), [&](const auto& each) { return each.name == condition.choice; });
    if (on == specs.end() || on->kind != ParameterKind::Choice)
      broken(what, fmt::format("applies only for \"{}\", which is no choice there", condition.choice));
    if (!on->condition.choice.empty())
      broken(what, fmt::format("applies only for \"{}\", which does not always apply itself", condition.choice));
    if (condition.values.empty()) broken(what, fmt::format("names no value of \"{}\" that it applies for", on->name));
    for (const std::string& value : condition.values)
      if (std::find(on->choices.begin(), on->choices.end(), value) == on->choices.end())
        broken(what, fmt::format("applies only for \"{}\", which \"{}\" does not offer", value, on->name));
  }
}

/// A list is filled by the shapes of an input with values of a parameter that its items can have.
void checkFilling(const FeatureType& type, const std::string& what, const ParameterSpec& spec) {
  const ListFilling& filling = spec.filling;
  if (filling == ListFilling()) return;
  if (spec.kind != ParameterKind::List) broken(what, "has one item for each shape, but is no list");
  const auto named = [&](const InputSpec& input) { return input.name == filling.input; };
  if (std::none_of(type.inputs.begin(), type.inputs.end(), named))
    broken(what, fmt::format("has one item for each shape of \"{}\", which is no input there", filling.input));
  const auto alike = [&](const ParameterSpec& other) {
    return other.name == filling.like && other.kind == spec.fields.at(0).kind;
  };
  if (!filling.like.empty() && std::none_of(type.parameters.begin(), type.parameters.end(), alike))
    broken(what, fmt::format("begins as \"{}\", which is no parameter of the kind of its items", filling.like));
}

void checkInputCondition(const FeatureType& type, const std::string& what, const ParameterSpec& spec) {
  const std::string& name = spec.inputCondition.input;
  const auto named = [&](const InputSpec& input) { return input.name == name && input.minimum == 0; };
  if (!name.empty() && std::none_of(type.inputs.begin(), type.inputs.end(), named))
    broken(what, fmt::format("applies only with or without \"{}\", which is no input there that may be left out", name));
}

void checkShapesNamed(const FeatureType& type) {
  for (const ParameterSpec& spec : type.parameters) {
    const std::string what = fmt::format("The parameter \"{}\" of {}", spec.name, type.id);
    checkInputCondition(type, what, spec);
    checkFilling(type, what, spec);
    if (spec.kind == ParameterKind::List) checkFilling(type, what, spec.fields.at(0));
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

void checkPlaying(const std::string& what, const FeatureType& type) {
  const PlayedBy& played = type.playedBy;
  if (played.parameter.empty()) return;
  const auto counts = [&](const ParameterSpec& spec) {
    return spec.name == played.parameter && spec.kind == ParameterKind::Count;
  };
  if (std::none_of(type.parameters.begin(), type.parameters.end(), counts) || played.frames < 2)
    broken(what, fmt::format("cannot play by \"{}\": it must be a count, set to 2 or more", played.parameter));
  const auto holdsKeys = [&](const ParameterSpec& spec) { return spec.name == played.keys && isFrameKeys(spec); };
  if (!played.keys.empty() && std::none_of(type.parameters.begin(), type.parameters.end(), holdsKeys))
    broken(what, fmt::format("has no keys \"{}\" for the timeline", played.keys));
  const auto excludes = [&](const ParameterSpec& spec) {
    return spec.name == played.excludedBy && spec.kind == ParameterKind::List;
  };
  if (!played.excludedBy.empty() && std::none_of(type.parameters.begin(), type.parameters.end(), excludes))
    broken(what, fmt::format("has no list \"{}\" that keeps it from playing", played.excludedBy));
}

bool hasCount(const FeatureType& type, const std::string& name, double from) {
  return std::any_of(type.parameters.begin(), type.parameters.end(), [&](const ParameterSpec& spec) {
    return spec.name == name && spec.kind == ParameterKind::Count && spec.minimum == from;
  });
}

void checkCounts(const std::string& what, const FeatureType& type) {
  if (!type.previewedBy.empty() && !hasCount(type, type.previewedBy, 0))
    broken(what, fmt::format("cannot be previewed by \"{}\": it must be a count from 0", type.previewedBy));
  if (!type.takesFrame.empty() && !(hasCount(type, type.takesFrame, 1) && !type.inputs.empty()))
    broken(what, fmt::format("cannot take a frame by \"{}\": it must be a count from 1, and there must be an input",
                             type.takesFrame));
}

/// A file of its kind is opened by an import followed by the type with its defaults, so nothing else may be needed.
void checkOpening(const std::string& what, const FeatureType& type) {
  if (type.opens == ShapeKind::None) {
    if (type.takesApart) broken(what, "takes shapes apart that it does not open");
    return;
  }
  std::size_t needed = 0;
  for (const InputSpec& input : type.inputs) needed += input.minimum;
  const auto takes = [&](const InputSpec& input) {
    return input.kinds.empty() || std::find(input.kinds.begin(), input.kinds.end(), type.opens) != input.kinds.end();
  };
  if (needed != 1 || !takes(type.inputs.front()))
    broken(what, fmt::format("cannot open a {}: it must take one as its only input", shapeKindName(type.opens)));
  for (const ParameterSpec& spec : type.parameters)
    if (spec.fallback.is_null() && !spec.mayBeAbsent)
      broken(what,
             fmt::format("cannot open a {}: the parameter \"{}\" has no default", shapeKindName(type.opens), spec.name));
}

/// What is made of the shape goes on with the result in its place, so it must be clear which shape that is.
void checkEdited(const std::string& what, const FeatureType& type) {
  const auto edited = [](const InputSpec& input) { return input.use == InputUse::Edited; };
  if (std::none_of(type.inputs.begin(), type.inputs.end(), edited)) return;
  const InputSpec& input = type.inputs.front();
  if (type.inputs.size() != 1 || input.minimum != 1 || input.maximum != 1)
    broken(what, "cannot edit its input: it must take one shape and nothing else");
}

}  // namespace

void broken(const std::string& what, const std::string& why) {
  throw Error(ErrorCode::PluginBroken, fmt::format("{} {}.", what, why), "This is a mistake in its declaration.");
}

bool isName(std::string_view text, bool dots) {
  if (text.empty() || text.front() < 'a' || text.front() > 'z') return false;
  return std::all_of(text.begin(), text.end(), [&](char c) {
    return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '-' || (dots && (c == '.' || c == '_'));
  });
}

void check(FeatureType& type) {
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
  checkConditions(type.id, type.parameters);
  checkShapesNamed(type);
  checkInputByFlags(what, type, names);
  checkOpening(what, type);
  checkPlaying(what, type);
  checkCounts(what, type);
  checkEdited(what, type);
}

void check(Format& format) {
  const std::string what = fmt::format("The format \"{}\"", format.id);
  // "3mf" begins with a digit; with options, the id is also the name of a parameter of the import.
  if (!isName("a" + format.id) || format.id.empty() || (!format.readOptions.empty() && !isName(format.id)))
    broken(what, "has no proper id; use lower-case letters, digits and hyphens");
  if (isReserved(format.id) || format.id == "file") broken(what, "has an id that commands need themselves");
  if (format.title.empty()) broken(what, "has no title");
  if (!format.read && !format.write) broken(what, "can neither be read nor written");
  if (format.writes.empty() != !format.write) broken(what, "must say which kinds of shape it writes, if it writes any");
  if (format.extensions.empty()) broken(what, "has no extension");
  for (const std::string& extension : format.extensions)
    if (!isName("a" + extension) || extension.empty() || extension == "blossom")
      broken(what, fmt::format("cannot have the extension \"{}\"", extension));
  for (auto* options : {&format.readOptions, &format.writeOptions}) {
    std::set<std::string> names;
    for (ParameterSpec& spec : *options) {
      settle("the format " + format.id, spec);
      if (!spec.condition.choice.empty())  // the import has it as a field of a record
        broken(what,
               fmt::format("has a condition on the option \"{}\"; only parameters of features can have one", spec.name));
      if (!names.insert(spec.name).second) broken(what, fmt::format("declares the option \"{}\" twice", spec.name));
    }
  }
}

}  // namespace blossom::declaration
