#pragma once
#include <QString>
#include <string>

#include "parameter/parameter.h"

namespace blossom::ui {

/// Whether the text is more than a number with an optional unit.
[[nodiscard]] bool isExpression(const QString& typed);

/// A typed expression (a number without a unit is in the preferred unit of length) as stored in a document, where a number
/// without a unit is in mm: unchanged when the value is the same, else with the unit written after the whole expression or
/// after each plain number. Empty when none of these evaluates exactly to the value.
[[nodiscard]] std::string documentText(const ParameterSpec&, const QString& typed, const Value& value,
                                       const NamedNumbers& names);

/// Whether the typed text, with lengths in the preferred unit, evaluates to that value.
[[nodiscard]] bool typedComesTo(const ParameterSpec&, const QString& typed, const Value&, const NamedNumbers& names);

/// The value as stored in the document: the expression if one was typed for it (parameter/written.h), else the value itself.
[[nodiscard]] Value writtenAs(const ParameterSpec&, const QString& expression, const Value&, const NamedNumbers& names);

/// The expression of a stored value; empty when it is none.
[[nodiscard]] QString expressionOf(const Value& stored);

/// What is stored of a typed text, with lengths in the preferred unit. @throws Error InvalidParameter.
[[nodiscard]] Value writtenTyped(const ParameterSpec&, const QString& typed, const NamedNumbers& names);

}  // namespace blossom::ui
