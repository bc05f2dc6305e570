#include "core/expression.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <numbers>
#include <optional>
#include <vector>

#include "core/error.h"
#include "core/expression_functions.h"
#include "core/expression_words.h"
#include "core/units.h"

namespace blossom {
namespace {

constexpr int deepest = 100;  // of parentheses and signs, for the stack's sake

/// How a user counts: characters, not bytes.
std::size_t characterAt(std::string_view text, std::size_t byte) {
  std::size_t count = 1;
  for (const char c : text.substr(0, byte)) count += (static_cast<unsigned char>(c) & 0xC0) != 0x80 ? 1 : 0;
  return count;
}

/// The whole UTF-8 character that starts there.
std::string_view wholeCharacter(std::string_view text, std::size_t byte) {
  std::size_t end = byte + 1;
  while (end < text.size() && (static_cast<unsigned char>(text[end]) & 0xC0) == 0x80) ++end;
  return text.substr(byte, end - byte);
}

class Parser {
 public:
  Parser(std::string_view text, Quantity wanted, const LengthUnit& unit, const NamedNumbers& known)
      : text_(text), wanted_(wanted), unit_(unit), names_(known) {}

  double result() { return checkedAt(0, asWanted(whole())).value; }

  Dimensioned quantityResult() {
    const Dimensioned value = whole();
    if (!value.plain() && !value.is(1, 0) && !value.is(0, 1)) fail(0, "it comes to a product of units");
    return checkedAt(0, value);
  }

 private:
  Dimensioned whole() {
    blanks();
    if (atEnd()) fail(at_, "nothing is written");
    const Dimensioned value = sum();
    blanks();
    if (!atEnd()) unexpected();
    return value;
  }

  // A plain "10" may mean 10 mm: only dimensions that cannot be intended are refused.
  Dimensioned asWanted(const Dimensioned& value) const {
    const bool length = value.is(1, 0), angle = value.is(0, 1);
    if (wanted_ == Quantity::Length && value.plain()) return {value.value * unit_.millimetres};
    if (value.plain() || (wanted_ == Quantity::Length && length) || (wanted_ == Quantity::Angle && angle)) return value;
    fail(0, fmt::format("it comes to {}", length           ? "a length"
                                          : angle          ? "an angle"
                                          : value.is(2, 0) ? "an area"
                                                           : "a product of units"));
  }

  Dimensioned sum() {
    const Depth depth(*this);
    Dimensioned left = product();
    for (;;) {
      blanks();
      const std::size_t place = at_;
      const bool minus = take("-") || take("−");
      if (!minus && !take("+")) return left;
      Dimensioned right = product();
      if (minus) right.value = -right.value;
      left = checkedAt(place, added(left, right, place));
    }
  }

  Dimensioned added(const Dimensioned& a, const Dimensioned& b, std::size_t place) const {
    const auto unitOne = [](const Dimensioned& d) { return d.is(1, 0) || d.is(0, 1); };
    if (a.sameUnit(b)) return a.with(a.value + b.value);
    if (a.plain() && unitOne(b)) return b.with(a.value * plainIn(b) + b.value);
    if (b.plain() && unitOne(a)) return a.with(a.value + b.value * plainIn(a));
    fail(place, "these cannot be added");
  }

  /// As in a sum: max(1 cm, 2) are two lengths.
  void countPlainAsLengths(std::vector<Dimensioned>& values) const {
    const auto length = std::find_if(values.begin(), values.end(), [](const Dimensioned& v) { return v.is(1, 0); });
    if (length == values.end()) return;
    const Dimensioned one = length->with(unit_.millimetres);
    for (Dimensioned& value : values)
      if (value.plain()) value = value * one;
  }

  /// What a plain number beside a length or an angle counts.
  double plainIn(const Dimensioned& other) const { return other.is(1, 0) ? unit_.millimetres : 1; }

  Dimensioned product() {
    Dimensioned left = quantity();
    for (;;) {
      blanks();
      const std::size_t place = at_;
      if (take("*") || take("×") || take("·")) {
        left = checkedAt(place, left * quantity());
      } else if (take("/") || take("÷")) {
        const Dimensioned right = signedPower();
        const auto unit = takeUnit();
        // "pi/4 rad": the unit belongs to the quotient unless what is divided has one already
        const bool whole = unit && left.plain() && right.plain();
        const Dimensioned divisor = unit && !whole ? right * *unit : right;
        if (divisor.value == 0) fail(place, "it divides by zero");
        left = left / divisor;
        left = checkedAt(place, whole ? left * *unit : left);
      } else {
        return left;
      }
    }
  }

  /// A power with its unit, and feet with inches.
  Dimensioned quantity() {
    const std::size_t place = at_;
    const Dimensioned value = signedPower();
    const std::size_t unitPlace = at_;
    const auto unit = takeUnit();
    if (!unit) return value;
    if (!value.plain()) fail(unitPlace, "there is a unit already");
    const Dimensioned whole = checkedAt(place, value * *unit);
    return unit->value == 12 * millimetresPerInch ? withInches(whole) : whole;
  }

  /// 5' 6" and 5 ft 6 in: inches that follow feet are added to them.
  Dimensioned withInches(const Dimensioned& feet) {
    const std::size_t back = at_;
    blanks();
    if (!atEnd() && isDigit(text_[at_])) {
      const double inches = number();
      const auto unit = takeUnit();
      if (unit && unit->value == millimetresPerInch)
        return checkedAt(back, feet.with(feet.value + std::copysign(inches * unit->value, feet.value)));
    }
    at_ = back;
    return feet;
  }

  Dimensioned signedPower() {
    blanks();
    const bool minus = take("-") || take("−");
    if (!minus) take("+");
    const std::size_t place = at_;
    const Dimensioned base = primary();
    blanks();
    Dimensioned value = base;
    if (take("^")) {
      const Depth depth(*this);
      const Dimensioned exponent = signedPower();
      if (!exponent.plain()) fail(place, "an exponent has no unit");
      const auto raised = power(base, exponent.value);
      if (!raised) fail(place, "a unit cannot be raised to that");
      value = checkedAt(place, *raised);
    }
    if (minus) value.value = -value.value;
    return value;
  }

  Dimensioned primary() {
    blanks();
    if (atEnd()) fail(at_, "something is missing at the end");
    const char c = text_[at_];
    if (c == '(') return parenthesised();
    if (isDigit(c) || c == '.') return {number()};
    if (take("π")) return {std::numbers::pi};
    if (letterAt(text_, at_) > 0) return named();
    unexpected();
  }

  Dimensioned parenthesised() {
    const std::size_t open = at_++;
    const Dimensioned value = sum();
    blanks();
    if (!take(")")) fail(open, "this parenthesis is not closed");
    return value;
  }

  Dimensioned named() {
    const std::size_t place = at_;
    const std::string_view name = word();
    blanks();
    if (const auto known = names_.find(name); known != names_.end()) return known->second;
    if (name == "pi") return {std::numbers::pi};
    if (name == "tau") return {2 * std::numbers::pi};
    const ExpressionFunction* function = findFunction(name);
    if (!function && unitNamed(name)) fail(place, fmt::format("before \"{}\" there is no number", name));
    if (!function) fail(place, fmt::format("\"{}\" is not known", name));
    if (!take("(")) fail(at_, fmt::format("{} needs its value in parentheses", name));
    std::vector<Dimensioned> values{sum()};
    for (blanks(); take(",") || take(";"); blanks()) values.push_back(sum());
    if (!take(")")) fail(place, fmt::format("the parenthesis of {} is not closed", name));
    countPlainAsLengths(values);
    if (values.size() < function->minimum || values.size() > function->maximum)
      fail(place, fmt::format("{} takes {} {}", name, function->minimum, function->minimum == 1 ? "value" : "values"));
    const auto value = function->call(values);
    if (!value) fail(place, fmt::format("{} does not take these units", name));
    return checkedAt(place, *value);
  }

  /// Digits with point and exponent, or whole and fraction: "1 1/2".
  double number() {
    const std::size_t place = at_;
    const double value = plainNumber();
    const std::string_view digits = text_.substr(place, at_ - place);
    if (digits.find_first_not_of("0123456789") != std::string_view::npos) return value;
    const std::size_t back = at_;
    blanks();
    if (at_ > back)
      if (const auto numerator = wholeNumber(); numerator) {
        blanks();
        if (take("/")) {
          blanks();
          const std::size_t below = at_;
          if (const auto denominator = wholeNumber(); denominator) {
            if (*denominator == 0) fail(below, "it divides by zero");
            return value + *numerator / *denominator;
          }
        }
      }
    at_ = back;
    return value;
  }

  double plainNumber() {
    double value = 0;
    const auto [end, error] = std::from_chars(text_.data() + at_, text_.data() + text_.size(), value);
    if (error == std::errc::result_out_of_range) fail(at_, "this number is too large or too small");
    if (error != std::errc{} || !std::isfinite(value)) unexpected();
    at_ = static_cast<std::size_t>(end - text_.data());
    return value;
  }

  std::optional<double> wholeNumber() {
    const std::size_t place = at_;
    while (!atEnd() && isDigit(text_[at_])) ++at_;
    if (at_ == place) return std::nullopt;
    double value = 0;
    const auto [end, error] = std::from_chars(text_.data() + place, text_.data() + at_, value);
    if (error != std::errc{}) fail(place, "this number is too large or too small");
    return value;
  }

  std::optional<Dimensioned> takeUnit() {
    const std::size_t back = at_;
    blanks();
    for (const std::string_view sign : {"°", "\"", "''", "'", "µm", "μm"})
      if (take(sign)) return unitNamed(sign);
    if (!atEnd() && letterAt(text_, at_) > 0) {
      const std::size_t place = at_;
      const std::string_view name = word();
      if (const auto unit = unitNamed(name)) return unit;
      fail(place, findFunction(name) || names_.contains(name) ? fmt::format("an operator is missing before \"{}\"", name)
                                                              : fmt::format("\"{}\" is not a unit", name));
    }
    at_ = back;
    return std::nullopt;
  }

  std::string_view word() {
    const std::size_t place = at_;
    at_ = wordEnd(text_, at_);
    return text_.substr(place, at_ - place);
  }

  [[nodiscard]] Dimensioned checkedAt(std::size_t place, const Dimensioned& value) const {
    if (std::isnan(value.value)) fail(place, "this has no value");
    if (!std::isfinite(value.value)) fail(place, "this is too large");
    return value;
  }

  void blanks() {
    while (!atEnd()) {
      if (text_[at_] == ' ' || text_[at_] == '\t')
        ++at_;
      else if (!take(" ") && !take(" ") && !take(" "))  // thin and unbreakable spaces of what was copied
        return;
    }
  }

  bool take(std::string_view sign) {
    if (!text_.substr(at_).starts_with(sign)) return false;
    at_ += sign.size();
    return true;
  }

  [[nodiscard]] bool atEnd() const { return at_ >= text_.size(); }

  [[noreturn]] void unexpected() const {
    if (text_[at_] == ',') fail(at_, "the decimal sign is a point, not a comma");
    fail(at_, fmt::format("\"{}\" is not expected here", wholeCharacter(text_, at_)));
  }

  [[noreturn]] void fail(std::size_t place, const std::string& what) const {
    const char* wanted = wanted_ == Quantity::Length ? "a length" : wanted_ == Quantity::Angle ? "an angle" : "a number";
    const std::string examples =
        wanted_ == Quantity::Length  ? "12, 3cm, 1/2 in + 4 or sqrt(2)*10 mm; without a unit it is " + unit_.name
        : wanted_ == Quantity::Angle ? "30, 360/7, pi/4 rad or 0.25turn; without a unit it is degrees"
                                     : "0.5, 3/4, 1e-3 or sqrt(2)/2";
    constexpr std::size_t longest = 60;
    std::string_view shown = text_;
    if (shown.size() > longest)
      for (shown = shown.substr(0, longest); (static_cast<unsigned char>(text_[shown.size()]) & 0xC0) == 0x80;)
        shown.remove_suffix(1);
    throw Error(ErrorCode::InvalidParameter,
                fmt::format("\"{}{}\" is not {}: {} (character {}).", shown, shown.size() < text_.size() ? ".." : "", wanted,
                            what, characterAt(text_, place)),
                fmt::format("Write for example {}.{}", examples, namesTold()));
  }

  [[nodiscard]] std::string namesTold() const {
    std::string told;
    for (const auto& [name, value] : names_) told += (told.empty() ? " Names: " : ", ") + name;
    return told.empty() ? told : told + '.';
  }

  class Depth {
   public:
    explicit Depth(Parser& parser) : parser_(parser) {
      if (++parser_.depth_ > deepest) parser_.fail(parser_.at_, "it is nested too deeply");
    }
    ~Depth() { --parser_.depth_; }
    Depth(const Depth&) = delete;
    Depth& operator=(const Depth&) = delete;

   private:
    Parser& parser_;
  };

  std::string_view text_;
  Quantity wanted_;
  const LengthUnit& unit_;
  const NamedNumbers& names_;
  std::size_t at_ = 0;
  int depth_ = 0;
};

std::string_view trimmed(std::string_view text) {
  const auto first = text.find_first_not_of(" \t");
  return first == std::string_view::npos ? std::string_view() : text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

}  // namespace

double evaluateExpression(std::string_view text, Quantity wanted, const LengthUnit& plain, const NamedNumbers& known) {
  return Parser(trimmed(text), wanted, plain, known).result();
}

Dimensioned evaluateQuantity(std::string_view text, const LengthUnit& plain, const NamedNumbers& known) {
  return Parser(trimmed(text), Quantity::Number, plain, known).quantityResult();
}

}  // namespace blossom
