#include "parameter/written.h"

#include <algorithm>

#include "core/error.h"
#include "core/expression.h"

namespace blossom {

namespace {

using enum ParameterKind;

bool hasCoordinates(const ParameterSpec& spec) {
  return spec.kind == Point || spec.kind == Vector || spec.kind == Displacement;
}

Value pairOf(const ParameterSpec& spec, const std::string& text, const NamedNumbers& names) {
  return {{"expression", text}, {"value", parseText(spec, text, {}, names)}};
}

Value numberWithNames(const ParameterSpec& spec, const Value& written, const NamedNumbers& names, bool strict) {
  const bool pair = isNamedExpression(written);
  if (!pair && !written.is_string()) return written;
  const std::string text = (pair ? written.at("expression") : written).get<std::string>();
  if (!pair && !usesNames(text, names)) return written;
  try {
    return pairOf(spec, text, names);
  } catch (const Error&) {
    if (strict) throw;
    return written;
  }
}

/// Items that were put in or taken out of a list leave those before and after them as they were written.
Value keptItems(const Value& written, const Value& before, const Value& after) {
  const std::size_t fewer = std::min(before.size(), after.size());
  std::size_t front = 0, back = 0;
  while (front < fewer && before[front] == after[front]) ++front;
  while (back < fewer - front && before[before.size() - 1 - back] == after[after.size() - 1 - back]) ++back;
  Value all = after;
  for (std::size_t k = 0; k < front; ++k) all[k] = written[k];
  for (std::size_t k = 1; k <= back; ++k) all[after.size() - k] = written[written.size() - k];
  return all;
}

Value kept(const Value& written, const Value& before, const Value& after) {
  if (before == after) return written;
  const bool lists = after.is_array() && before.is_array() && written.is_array();
  if (lists && after.size() == before.size() && after.size() == written.size()) {
    Value all = Value::array();
    for (std::size_t k = 0; k < after.size(); ++k) all.push_back(kept(written[k], before[k], after[k]));
    return all;
  }
  if (lists && before.size() == written.size()) return keptItems(written, before, after);
  if (!after.is_object() || !before.is_object() || !written.is_object() || isNamedExpression(written)) return after;
  Value all = Value::object();
  for (const auto& [name, value] : after.items()) {
    const auto was = before.find(name), text = written.find(name);
    if (was != before.end() && text != written.end())
      all[name] = kept(*text, *was, value);
    else if (was == before.end() || *was != value)
      all[name] = value;
  }
  return all;
}

}  // namespace

bool usesNames(std::string_view text, const NamedNumbers& names) {
  const std::vector<std::string> words = wordsOf(text);
  return std::any_of(words.begin(), words.end(), [&](const std::string& word) { return names.contains(word); });
}

bool isNumeric(const ParameterSpec& spec) {
  return spec.kind == Count || spec.kind == Number || spec.kind == Ratio || spec.kind == Length || spec.kind == Angle;
}

bool isNamedExpression(const Value& value) {
  if (!value.is_object() || value.size() != 2) return false;
  const auto text = value.find("expression"), number = value.find("value");
  return text != value.end() && number != value.end() && text->is_string() && number->is_number();
}

Value writtenText(const ParameterSpec& spec, std::string_view text, const NamedNumbers& names) {
  Value value = parseText(spec, text, {}, names);
  if (isNumeric(spec)) return usesNames(text, names) ? pairOf(spec, std::string(text), names) : value;
  if (!hasCoordinates(spec) || text.find_first_of("[(") != std::string_view::npos || !usesNames(text, names)) return value;
  Value all = value;
  std::size_t from = 0;
  for (Value& coordinate : all) {
    const std::size_t to = std::min(text.find(',', from), text.size());
    if (from < text.size()) coordinate = writtenText(coordinateOf(spec), text.substr(from, to - from), names);
    from = to + 1;
  }
  return all;
}

Value withNames(const ParameterSpec& spec, const Value& written, const NamedNumbers& names, bool strict) {
  if (isNumeric(spec)) return numberWithNames(spec, written, names, strict);
  const bool items = spec.kind == List && written.is_array();
  if (items || (hasCoordinates(spec) && written.is_array())) {
    const ParameterSpec item = items ? spec.fields.at(0) : coordinateOf(spec);
    Value all = Value::array();
    for (const Value& each : written) all.push_back(withNames(item, each, names, strict));
    return all;
  }
  if (spec.kind != Record || !written.is_object()) return written;
  Value all = written;
  for (const ParameterSpec& field : spec.fields)
    if (const auto found = all.find(field.name); found != all.end()) *found = withNames(field, *found, names, strict);
  return all;
}

Value keepWritten(const std::vector<ParameterSpec>& specs, const Value& written, const Value& after) {
  try {
    return kept(written.is_object() ? written : Value::object(), completed(specs, written), after);
  } catch (const Error&) {
    return after;  // what was written had an error
  }
}

}  // namespace blossom
