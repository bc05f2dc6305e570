#pragma once
#include <string_view>

#include "core/units.h"

namespace blossom {

/// Dimension that an expression must have. A number without a unit counts as mm (or the unit passed as `plain`) where a
/// length is wanted, and as degrees where an angle is wanted.
enum class Quantity { Number, Length, Angle };

/// Returns the value of an expression such as "1/2 in + 3*(2 cm)", "sqrt(2)*10", "pi/4 rad", "5' 6 1/2\"" or "2*sin(30°)*10
/// mm", in mm, in degrees or as a plain number. Units are checked: lengths and angles may be multiplied and divided as long
/// as the result has the wanted dimension; a plain number added to a length counts as a length, added to an angle as
/// degrees. A unit after a quotient of plain numbers belongs to the quotient ("pi/4 rad"), and "1 1/2 in" is a mixed number.
/// Precedence: + -, then * /, then signs, then ^. Constants: pi, tau. Functions: sqrt abs round floor ceil exp ln log, sin
/// cos tan (of degrees), asin acos atan atan2 (in degrees), and, of several values, min max hypot mod.
/// @throws Error InvalidParameter that quotes the text, the mistake and its character (the first is 1); also when the result
/// is not finite.
double evaluateExpression(std::string_view text, Quantity wanted, const LengthUnit& plain = {});

}  // namespace blossom
