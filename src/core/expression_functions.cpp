#include "core/expression_functions.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "core/units.h"

namespace blossom {
namespace {

using Values = std::span<const Dimensioned>;
using Result = std::optional<Dimensioned>;

constexpr double perRadian = 180 / std::numbers::pi;
constexpr std::size_t anyNumber = 100;

template <double (*f)(double)>
Result ofPlain(Values v) {
  if (!v[0].plain()) return std::nullopt;
  return Dimensioned{f(v[0].value)};
}

/// The unit stays.
template <double (*f)(double)>
Result ofAny(Values v) {
  return v[0].with(f(v[0].value));
}

/// Quarter turns are met exactly, as a user expects of cos(90).
double sine(double degrees) {
  const double turn = std::remainder(degrees, 360);
  if (std::fmod(turn, 90) == 0) return std::abs(turn) == 90 ? std::copysign(1, turn) : 0;
  return std::sin(turn / perRadian);
}
double cosine(double degrees) {
  const double turn = std::remainder(degrees, 360);
  if (std::fmod(turn, 90) == 0) return std::abs(turn) == 90 ? 0 : turn == 0 ? 1 : -1;
  return std::cos(turn / perRadian);
}
double tangent(double degrees) { return sine(degrees) / cosine(degrees); }
double arcSine(double x) { return std::asin(x) * perRadian; }
double arcCosine(double x) { return std::acos(x) * perRadian; }
double arcTangent(double x) { return std::atan(x) * perRadian; }

template <double (*f)(double)>
Result ofAngle(Values v) {
  if (!v[0].plain() && !v[0].is(0, 1)) return std::nullopt;
  return Dimensioned{f(v[0].value)};
}

template <double (*f)(double)>
Result toAngle(Values v) {
  if (!v[0].plain()) return std::nullopt;
  return Dimensioned{f(v[0].value), 0, 1};
}

/// Plain numbers get the unit of the others; empty when there are two different units.
Result commonUnit(Values values) {
  Dimensioned unit;
  for (const Dimensioned& v : values) {
    if (v.plain()) continue;
    if (!unit.plain() && !unit.sameUnit(v)) return std::nullopt;
    unit = v;
  }
  return unit;
}

template <double (*f)(double, double)>
Result folded(Values values) {
  const Result unit = commonUnit(values);
  if (!unit) return std::nullopt;
  double result = values[0].value;
  for (const Dimensioned& v : values.subspan(1)) result = f(result, v.value);
  return unit->with(result);
}

double smaller(double a, double b) { return std::min(a, b); }
double larger(double a, double b) { return std::max(a, b); }
double distance(double a, double b) { return std::hypot(a, b); }
/// Between 0 and b, also for negative a.
double modulo(double a, double b) {
  if (b == 0) return std::numeric_limits<double>::quiet_NaN();
  const double rest = std::fmod(a, b);
  return rest != 0 && (rest < 0) != (b < 0) ? rest + b : rest;
}

Result angleOf(Values v) {
  if (!commonUnit(v)) return std::nullopt;
  return Dimensioned{std::atan2(v[0].value, v[1].value) * perRadian, 0, 1};
}

Result squareRoot(Values v) { return power(v[0], 0.5); }

double exponential(double x) { return std::exp(x); }
double naturalLog(double x) { return std::log(x); }
double decimalLog(double x) { return std::log10(x); }
double absolute(double x) { return std::abs(x); }
double rounded(double x) { return std::round(x); }
double floored(double x) { return std::floor(x); }
double ceiled(double x) { return std::ceil(x); }

constexpr std::array<ExpressionFunction, 19> functions{{{"sqrt", 1, 1, squareRoot},
                                                        {"abs", 1, 1, ofAny<absolute>},
                                                        {"round", 1, 1, ofAny<rounded>},
                                                        {"floor", 1, 1, ofAny<floored>},
                                                        {"ceil", 1, 1, ofAny<ceiled>},
                                                        {"exp", 1, 1, ofPlain<exponential>},
                                                        {"ln", 1, 1, ofPlain<naturalLog>},
                                                        {"log", 1, 1, ofPlain<decimalLog>},
                                                        {"sin", 1, 1, ofAngle<sine>},
                                                        {"cos", 1, 1, ofAngle<cosine>},
                                                        {"tan", 1, 1, ofAngle<tangent>},
                                                        {"asin", 1, 1, toAngle<arcSine>},
                                                        {"acos", 1, 1, toAngle<arcCosine>},
                                                        {"atan", 1, 1, toAngle<arcTangent>},
                                                        {"atan2", 2, 2, angleOf},
                                                        {"min", 1, anyNumber, folded<smaller>},
                                                        {"max", 1, anyNumber, folded<larger>},
                                                        {"hypot", 2, anyNumber, folded<distance>},
                                                        {"mod", 2, 2, folded<modulo>}}};

}  // namespace

std::optional<Dimensioned> power(const Dimensioned& base, double exponent) {
  const double lengths = base.lengths * exponent, angles = base.angles * exponent;
  if (lengths != std::trunc(lengths) || angles != std::trunc(angles) || std::abs(lengths) > 9 || std::abs(angles) > 9)
    return std::nullopt;
  return Dimensioned{exponent == 0.5 ? std::sqrt(base.value) : std::pow(base.value, exponent), static_cast<int>(lengths),
                     static_cast<int>(angles)};
}

std::optional<Dimensioned> unitNamed(std::string_view name) {
  if (const double factor = millimetresPer(name); factor > 0) return Dimensioned{factor, 1, 0};
  if (name == "deg" || name == "°") return Dimensioned{1, 0, 1};
  if (name == "rad") return Dimensioned{perRadian, 0, 1};
  if (name == "grad" || name == "gon") return Dimensioned{0.9, 0, 1};
  if (name == "turn") return Dimensioned{360, 0, 1};
  return std::nullopt;
}

const ExpressionFunction* findFunction(std::string_view name) {
  const auto* found = std::find_if(functions.begin(), functions.end(), [&](const auto& f) { return f.name == name; });
  return found == functions.end() ? nullptr : &*found;
}

}  // namespace blossom
