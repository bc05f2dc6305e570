#include "cli/flag_inputs.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

namespace blossom {
namespace {

/// The first input of a command that accepts the result of the feature.
std::optional<std::size_t> placeFor(const FeatureType& command, const std::vector<ShapeKind>& made) {
  for (std::size_t i = 0; i < command.inputs.size(); ++i) {
    const auto& kinds = command.inputs[i].kinds;
    if (kinds.empty() || std::find_first_of(kinds.begin(), kinds.end(), made.begin(), made.end()) != kinds.end()) return i;
  }
  return std::nullopt;
}

bool isFree(const CLI::App& app, const std::string& name) { return !app.get_option_no_throw("--" + name); }

/// The parameters in the order declared, each with the others of its sort: the one that asks, plain ones, prefixed ones.
struct Sorted {
  std::vector<ParameterSpec> asks, plain, prefixed;
};

Sorted sorted(const FeatureType& source, const CLI::App& app) {
  Sorted result;
  const InputByFlags& flags = source.inputByFlags;
  for (const ParameterSpec& spec : source.parameters) {
    const bool plain = std::find(flags.plain.begin(), flags.plain.end(), spec.name) != flags.plain.end();
    if (spec.name == flags.asks) {
      result.asks.push_back(spec);
      result.asks.back().fallback = nullptr;  // creates the input only when the flag is used, so there is no default
      result.asks.back().mayBeAbsent = true;
    } else {
      (plain && isFree(app, spec.name) ? result.plain : result.prefixed).push_back(spec);
    }
  }
  return result;
}

}  // namespace

FlagInputs::FlagInputs(CommandLine& line, CLI::App& app, const Registry& registry, const FeatureType& command) {
  for (const auto& source : registry.types()) {
    const InputByFlags& flags = source->inputByFlags;
    const auto place = placeFor(command, source->produces);
    if (flags.asks.empty() || !place || !isFree(app, flags.asks)) continue;
    const Sorted specs = sorted(*source, app);
    const std::string group = fmt::format("{} in place of a file", source->title);
    sources_.push_back({*place, source, ParameterFlags(line, app, specs.asks, "", group),
                        ParameterFlags(line, app, specs.plain, "", group),
                        ParameterFlags(line, app, specs.prefixed, flags.asks + ".", group)});
  }
}

std::vector<std::pair<std::size_t, Feature>> FlagInputs::features() const {
  std::vector<std::pair<std::size_t, Feature>> result;
  for (const Source& source : sources_) {
    Value parameters = source.asks.values();
    const bool asked = !parameters.empty();
    for (const ParameterFlags* flags : {&source.plain, &source.prefixed}) {
      if (!asked && !flags->firstUsed().empty())
        throw UsageError(
            fmt::format("{} says how --{} is made, which is not given.", flags->firstUsed(), source.type->inputByFlags.asks),
            fmt::format("Give --{} too.", source.type->inputByFlags.asks));
      parameters.update(flags->values());
    }
    if (!asked) continue;
    Feature feature;
    feature.type = source.type->id;
    feature.name = source.type->title;
    feature.id = source.type->command;
    feature.parameters = std::move(parameters);
    result.emplace_back(source.place, std::move(feature));
  }
  return result;
}

}  // namespace blossom
