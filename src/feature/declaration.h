#pragma once
#include <string>
#include <string_view>

#include "exchange/format/format.h"
#include "feature/feature_type.h"

/// Checks of what plugins declare, before anything relies on it.
namespace blossom::declaration {

/// @throws Error PluginBroken: "WHAT WHY."
[[noreturn]] void broken(const std::string& what, const std::string& why);

/// Lower-case letters, digits and hyphens, as flags and commands are written; `dots` allows "plugin.name".
bool isName(std::string_view, bool dots = false);

/// Brings the defaults into canonical form. @throws Error PluginBroken when the declaration is incomplete or contradicts
/// itself.
void check(FeatureType&);
void check(Format&);

}  // namespace blossom::declaration
