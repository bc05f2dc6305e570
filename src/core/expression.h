#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "core/dimensioned.h"
#include "core/units.h"

namespace blossom {

/// Dimension that an expression must have. A number without a unit counts as mm (or the unit passed as `plain`) where a
/// length is wanted, and as degrees where an angle is wanted.
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
/// @param names numbers that it may use by their names
double evaluateExpression(std::string_view text, Quantity wanted, const LengthUnit& plain = {},
                          const NamedNumbers& names = {});
/// The same where a number, a length or an angle is wanted; a number without a unit is plain.
Dimensioned evaluateQuantity(std::string_view text, const LengthUnit& plain = {}, const NamedNumbers& names = {});

/// Why a number cannot have this name: letters, digits and _, not beginning with a digit, and no unit, function or constant.
/// Letters of other alphabets are allowed. Empty: it can.
std::string nameProblem(std::string_view name);
/// The words of an expression that are no numbers: names, units, functions.
std::vector<std::string> wordsOf(std::string_view expression);
/// The expression with one word in the place of another.
std::string withWord(std::string_view expression, std::string_view word, std::string_view replacement);

}  // namespace blossom
