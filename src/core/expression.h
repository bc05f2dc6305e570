#pragma once
#include <string_view>

#include "core/units.h"

namespace blossom {

/// What a written quantity must come to. Without a unit a number counts as mm (or the unit given) where a length is wanted
/// and as degrees where an angle is.
enum class Quantity { Number, Length, Angle };

/// Value of an expression such as "1/2 in + 3*(2 cm)", "sqrt(2)*10", "pi/4 rad", "5' 6 1/2\"", "2*sin(30°)*10 mm": in mm, in
/// degrees or plain. Lengths and angles are told apart and may be multiplied and divided as long as the result is what is
/// wanted; a plain number added to a length counts as one, to an angle as degrees. A unit behind a quotient of plain numbers
/// belongs to the quotient ("pi/4 rad"), and "1 1/2 in" is read as on a tape measure. Precedence: + -, then * /, then signs,
/// then ^. Constants: pi, tau. Functions: sqrt abs round floor ceil exp ln log sin cos tan asin acos atan (of degrees, to
/// degrees), and of several values min max hypot atan2 mod.
/// Hand-written because the libraries of formulas (muParser, ExprTk) compute with plain numbers: they tell no length from an
/// angle, and read no feet and inches.
/// @throws Error InvalidParameter that quotes the text, says what is wrong, and at which character (the first is 1); also
/// when a result is not finite.
double evaluateExpression(std::string_view text, Quantity wanted, const LengthUnit& plain = {});

}  // namespace blossom
