#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/units.h"
#include "parameter/value.h"

namespace blossom {

enum class ParameterKind {
  Flag,
  Count,
  Number,
  Ratio,
  Length,
  Angle,
  Choice,
  Text,
  Color,
  Point,
  Vector,
  File,
  Curve,
  SubShape,
  List,
  Record
};

std::string_view parameterKindName(ParameterKind) noexcept;

/// One parameter, declared once: flag, form field, document key and manual row are all made from this.
struct ParameterSpec {
  std::string name;  ///< "area-preserving": the flag, the key, and, with spaces, the label
  std::string help;  ///< one sentence
  ParameterKind kind = ParameterKind::Flag;
  Value fallback;                 ///< default, canonical form; null when the user must give one
  std::optional<double> minimum;  ///< smallest value allowed (numbers, counts, lengths, angles); of a List: fewest items
  std::optional<double> maximum;
  bool aboveLeast = false;            ///< `least` itself is not allowed
  std::vector<std::string> choices;   ///< of a Choice; of a SubShape: exactly one, "face", "edge" or "vertex"
  std::vector<ParameterSpec> fields;  ///< of a Record; of a List: exactly one, the element
  std::string fileTypes;              ///< of a File: extensions, "json step"
  bool mayBeAbsent = false;           ///< a null fallback then means "none" instead of "must be given"
  std::string noneMeans;              ///< what an empty list, or none, stands for: "all sharp edges"
};

/// "area preserving": the name as a user reads it.
std::string label(const ParameterSpec&);
/// "length in mm, above 0": what may be given, for help and manual.
std::string describe(const ParameterSpec&);
/// Canonical form of a value, checked against kind, range and choices; integers become numbers, texts with units are parsed.
/// @throws Error InvalidParameter such as "t must lie between 0 and 1; it is 1.4."
Value checked(const ParameterSpec&, const Value&);
/// Canonical value from what a user typed: "1/2 in", "yes", "1,2,3", "#ff8800", a curve "0:1, 0.5:2", a sub-shape
/// "base:face:3". Lists take commas (semicolons when their items hold commas themselves) or JSON, records JSON. Nothing
/// typed for a file or a sub-shape is null.
/// @throws Error InvalidParameter.
Value parseText(const ParameterSpec&, std::string_view text, const LengthUnit& = {});
/// Inverse of parseText, as a form shows it. A file shows its path alone.
std::string formatText(const ParameterSpec&, const Value&, const LengthUnit& = {});

/// All parameters of `specs` in their canonical form and order: given ones checked, absent (or null) ones at their default.
/// @throws Error InvalidParameter, also for a name that is not declared (with the nearest declared one as a hint) and for
/// one that must be given and is not.
Value completed(const std::vector<ParameterSpec>& specs, const Value& given);

/// The name in `known` that is most like `wanted`, empty when nothing is near; for "Did you mean ..?".
std::string nearestName(std::string_view wanted, const std::vector<std::string>& known);

// What kinds may be declared; used as feature<P>(..).parameter("t", &P::t, ratio(), "help").
ParameterSpec flag();
ParameterSpec count(int minimum = 0, std::optional<int> maximum = {});
ParameterSpec number(std::optional<double> minimum = {}, std::optional<double> maximum = {});
ParameterSpec ratio();           ///< 0..1
ParameterSpec length();          ///< any length in mm
ParameterSpec positiveLength();  ///< mm, above 0
ParameterSpec lengthFromZero();  ///< mm, 0 or more
ParameterSpec angle();           ///< degrees
ParameterSpec choice(std::vector<std::string> names);
ParameterSpec text();
ParameterSpec color();
ParameterSpec point();
ParameterSpec vector();
ParameterSpec file(std::string extensions);
ParameterSpec controlCurve();
ParameterSpec subShape(std::string kind);  ///< "face", "edge" or "vertex"
ParameterSpec list(ParameterSpec element);
ParameterSpec record(std::vector<ParameterSpec> fields);
ParameterSpec optional(ParameterSpec);  ///< may be left out although it has no default (a file, a sub-shape)
/// Says what stands for a list without items, or for none: whenNone(list(subShape("edge")), "all sharp edges").
ParameterSpec whenNone(ParameterSpec, std::string means);

}  // namespace blossom
