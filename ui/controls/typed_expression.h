#pragma once
#include <QString>
#include <string>

#include "parameter/parameter.h"

namespace blossom::ui {

/// Whether there is more to it than a number and perhaps its unit.
[[nodiscard]] bool isExpression(const QString& typed);

/// An expression, typed with lengths in the unit preferred, as a document keeps it, whose lengths without a unit are in mm:
/// as typed where that comes to the same value, else with the unit written behind the whole or behind each plain number.
/// Empty when none of these comes to exactly that value.
[[nodiscard]] std::string documentText(const ParameterSpec&, const QString& typed, const Value& value);

/// Whether what was typed, with lengths in the unit preferred, comes to that value.
[[nodiscard]] bool typedComesTo(const ParameterSpec&, const QString& typed, const Value&);

/// The value as the document keeps it: the expression where one was typed for it, else the value itself.
[[nodiscard]] Value writtenAs(const ParameterSpec&, const QString& expression, const Value&);

}  // namespace blossom::ui
