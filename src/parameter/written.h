#pragma once
#include <string_view>
#include <vector>

#include "parameter/parameter.h"

/// Values as a document keeps them: as they were typed.
namespace blossom {

/// A count, a number, a ratio, a length or an angle.
bool isNumeric(const ParameterSpec&);

/// Whether an expression uses one of the names.
bool usesNames(std::string_view expression, const NamedNumbers&);

/// A number written with names, {"expression": "2*width", "value": 120}: its value is kept beside it, so that what reads it
/// need not know the names.
bool isNamedExpression(const Value&);

/// What a document keeps of typed text in mm and degrees: the canonical value, but expressions as such, those with names
/// with their value. Of points and lists, each item. @throws Error InvalidParameter.
Value writtenText(const ParameterSpec&, std::string_view text, const NamedNumbers& names);

/// A written value with every expression that uses a name computed anew. What cannot be computed keeps its value, or, when
/// `strict`, throws Error InvalidParameter.
Value withNames(const ParameterSpec&, const Value& written, const NamedNumbers& names, bool strict);

/// Parameters as a document keeps them after an edit: what is the same as before stays as it was written, or absent.
/// @param after canonical
Value keepWritten(const std::vector<ParameterSpec>&, const Value& written, const Value& after);

}  // namespace blossom
