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
  Displacement,
  File,
  Curve,
  SubShape,
  List,
  Record
};

std::string_view parameterKindName(ParameterKind) noexcept;

/// The values of a choice beside which a parameter means something; with the others its value is accepted and not used.
struct ParameterCondition {
  std::string choice;  ///< name of a parameter of the same feature type that always applies; empty: no condition
  std::vector<std::string> values;
  friend bool operator==(const ParameterCondition&, const ParameterCondition&) = default;
};

/// Whether an input has to be given for a parameter to mean something; otherwise its value is accepted and not used.
struct InputCondition {
  std::string input;  ///< name of an input of the same feature type; empty: no condition
  bool given = false;
  friend bool operator==(const InputCondition&, const InputCondition&) = default;
};

/// How many items a list is to have, so that a form can fill it: one for each shape of an input, or some more or fewer.
struct ListFilling {
  std::string input;  ///< name of an input of the same feature type; empty: any number of items
  int more = 0;       ///< items beside those; -1: none for one of the shapes
  std::string like;   ///< name of a parameter that each item begins with the value of; empty: as items of its kind do
  friend bool operator==(const ListFilling&, const ListFilling&) = default;
};

/// One parameter, declared once: flag, form field, document key and manual row are all derived from it.
struct ParameterSpec {
  std::string name;  ///< "area-preserving": flag and key; with spaces, the label
  std::string help;  ///< one sentence
  ParameterKind kind = ParameterKind::Flag;
  Value fallback;  ///< default in canonical form; null when there is none and a value is required
  /// Of numbers, counts, lengths and angles; of a List: minimum number of items; of a Point: of coordinates that are
  /// written.
  std::optional<double> minimum;
  std::optional<double> maximum;
  bool aboveMinimum = false;          ///< `minimum` itself is not allowed
  std::vector<std::string> choices;   ///< of a Choice; of a SubShape: exactly one, "face", "edge" or "vertex"
  std::vector<ParameterSpec> fields;  ///< of a Record; of a List: exactly one, the element
  std::string fileTypes;              ///< of a File: extensions, "json step"
  bool mayBeAbsent = false;           ///< with a null fallback: the value may be left out
  std::string noneMeans;              ///< meaning of an empty list or an absent value: "all sharp edges"
  ParameterCondition condition;       ///< set by onlyFor; not for fields of records and elements of lists
  InputCondition inputCondition;      ///< set by onlyWith and onlyWithout; as `condition`
  ListFilling filling;                ///< of a List, set by onePer: of a whole parameter, or of each item of one
};

/// The name as users read it: "area preserving".
std::string label(const ParameterSpec&);
/// Accepted values, for help and manual: "length in mm, above 0 mm"; of a parameter with a condition that follows: "..; only
/// if kind is torus or tube".
std::string describe(const ParameterSpec&, const LengthUnit& = {});
/// "only if kind is torus or tube, without element"; empty when the parameter always applies.
std::string describeCondition(const ParameterSpec&);
/// Whether a parameter means anything beside the values `given` of the others; what is absent, or no value that the choice
/// has, counts as its default. `specs` are the parameters of the feature type.
bool applies(const ParameterSpec&, const std::vector<ParameterSpec>& specs, const Value& given);
/// Returns the canonical form of a value after checking kind, range and choices; integers become numbers, texts with units
/// are parsed, of a number written with names (parameter/written.h) its value is taken.
/// @throws Error InvalidParameter such as "t must lie between 0 and 1; it is 1.4."
Value checked(const ParameterSpec&, const Value&);
/// Of what each coordinate of a point, a displacement or a vector is: a length or a number.
ParameterSpec coordinateOf(const ParameterSpec&);
/// Canonical value of typed text, which may use named numbers: "1/2 in", "yes", "1,2,3", "#ff8800", a curve "0:1, 0.5:2", a
/// sub-shape "base:face:3". Items of lists are separated by commas (by semicolons when the items contain commas) or written
/// as JSON; records are written as JSON. Empty text for a file or a sub-shape is null.
/// @throws Error InvalidParameter.
Value parseText(const ParameterSpec&, std::string_view text, const LengthUnit& = {}, const NamedNumbers& = {});
/// Inverse of parseText, for form fields. Of a file only the path is shown.
std::string formatText(const ParameterSpec&, const Value&, const LengthUnit& = {});

/// All parameters of `specs` in canonical form and in that order: values in `given` are checked, absent or null ones
/// replaced by the default.
/// @throws Error InvalidParameter, also for an undeclared name (the hint is the nearest declared one) and for a missing
/// value that is required.
Value completed(const std::vector<ParameterSpec>& specs, const Value& given);

/// The name in `known` that is most similar to `wanted`, for "Did you mean ..?"; empty when none is similar.
std::string nearestName(std::string_view wanted, const std::vector<std::string>& known);

// Kinds of parameters, as in feature<P>(..).parameter("t", &P::t, ratio(), "help").
ParameterSpec flag();
ParameterSpec count(int minimum = 0, std::optional<int> maximum = {});
ParameterSpec number(std::optional<double> minimum = {}, std::optional<double> maximum = {});
ParameterSpec positiveNumber();  ///< above 0
ParameterSpec ratio();           ///< 0..1
ParameterSpec length();          ///< any length in mm
ParameterSpec positiveLength();  ///< mm, above 0
ParameterSpec lengthFromZero();  ///< mm, 0 or more
ParameterSpec angle();           ///< degrees
ParameterSpec choice(std::vector<std::string> names);
ParameterSpec text();
ParameterSpec color();
ParameterSpec point();         ///< of two numbers z is 0
ParameterSpec pointInSpace();  ///< three numbers: 0 would be a guess
ParameterSpec vector();        ///< a direction or factors, without unit
ParameterSpec displacement();  ///< from one place to another, in mm
ParameterSpec file(std::string extensions);
ParameterSpec controlCurve();
ParameterSpec subShape(std::string kind);  ///< "face", "edge" or "vertex"
ParameterSpec list(ParameterSpec element);
ParameterSpec record(std::vector<ParameterSpec> fields);
ParameterSpec optional(ParameterSpec);  ///< may be left out although there is no default (a file, a sub-shape)
/// Sets the meaning of an empty list or an absent value: whenNone(list(subShape("edge")), "all sharp edges").
ParameterSpec whenNone(ParameterSpec, std::string means);
/// Says beside which values of a choice the parameter means something: onlyFor(number(), "kind", {"helicoid"}). Forms hide
/// it beside the others; values are accepted as before.
ParameterSpec onlyFor(ParameterSpec, std::string choice, std::vector<std::string> values);
/// Says that the parameter means something only where an input is given, or is not: onlyWithout(positiveLength(),
/// "element"). Forms hide it otherwise; values are accepted as before.
ParameterSpec onlyWith(ParameterSpec, std::string input);
ParameterSpec onlyWithout(ParameterSpec, std::string input);
/// Says how many items a list is to have: onePer(list(ratio()), "shape", -1, "t") is one for each shape after the first,
/// beginning as t. Forms add all that are missing at once; lists of other lengths are accepted as before.
ParameterSpec onePer(ParameterSpec list, std::string input, int more = 0, std::string like = {});

}  // namespace blossom
