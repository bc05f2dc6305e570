#include "document/named_numbers.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "core/error.h"
#include "core/expression.h"
#include "feature/registry.h"
#include "parameter/written.h"

namespace blossom {

namespace {

constexpr const char* key = "numbers";

void checkNames(const std::vector<NamedNumber>& table) {
  std::set<std::string> seen;
  for (const NamedNumber& row : table) {
    if (const std::string problem = nameProblem(row.name); !problem.empty())
      throw Error(ErrorCode::InvalidParameter, problem);
    if (!seen.insert(row.name).second)
      throw Error(ErrorCode::InvalidParameter, fmt::format("The name \"{}\" is there twice.", row.name));
  }
}

bool uses(const NamedNumber& row, const std::string& name) {
  const std::vector<std::string> words = wordsOf(row.value);
  return std::find(words.begin(), words.end(), name) != words.end();
}

/// Rows that need no other of those that are left are computed until none can be; the rest is returned. O(rows^2).
std::vector<const NamedNumber*> compute(const std::vector<NamedNumber>& table, NamedNumbers& values, bool strict) {
  std::vector<const NamedNumber*> left;
  left.reserve(table.size());
  for (const NamedNumber& row : table) left.push_back(&row);
  for (bool progress = true; progress;) {
    progress = false;
    std::vector<const NamedNumber*> waiting;
    for (const NamedNumber* row : left) {
      const bool needs =
          std::any_of(left.begin(), left.end(), [&](const NamedNumber* other) { return uses(*row, other->name); });
      if (needs) {
        waiting.push_back(row);
        continue;
      }
      progress = true;
      try {
        values[row->name] = evaluateQuantity(row->value, {}, values);
      } catch (const Error& error) {
        if (strict) throw Error(error.code(), fmt::format("{}: {}", row->name, error.message()), error.hint());
      }
    }
    left = std::move(waiting);
  }
  return left;
}

Value tableValue(const std::vector<NamedNumber>& table) {
  Value rows = Value::array();
  for (const NamedNumber& row : table) rows.push_back({{"name", row.name}, {"value", row.value}});
  return rows;
}

Document withTable(const Document& document, const std::vector<NamedNumber>& table) {
  Value extra = document.extra();
  if (table.empty())
    extra.erase(key);
  else
    extra[key] = tableValue(table);
  return document.withExtra(std::move(extra));
}

/// Calls a function with each parameter of the features whose types are there; it returns the new value.
template <class F>
Document withParameters(Document document, const Registry& registry, const F& function) {
  const auto features = document.features();
  const std::vector<std::shared_ptr<const Feature>> all(features.begin(), features.end());
  for (const auto& feature : all) {
    const auto type = registry.find(feature->type);
    if (!type || !feature->parameters.is_object()) continue;
    Feature changed = *feature;
    for (const ParameterSpec& spec : type->parameters)
      if (const auto found = changed.parameters.find(spec.name); found != changed.parameters.end())
        *found = function(*feature, spec, *found);
    if (changed.parameters != feature->parameters) document = document.with(std::move(changed));
  }
  return document;
}

/// The words of every expression with names in a written value.
void addWords(const Value& value, std::set<std::string>& words) {
  if (isNamedExpression(value)) {
    const std::vector<std::string> more = wordsOf(value.at("expression").get<std::string>());
    words.insert(more.begin(), more.end());
  } else if (value.is_structured()) {
    for (const Value& each : value) addWords(each, words);
  }
}

void refuseLost(const Document& document, const NamedNumbers& before, const NamedNumbers& after) {
  for (const auto& feature : document.features()) {
    std::set<std::string> words;
    addWords(feature->parameters, words);
    for (const std::string& word : words)
      if (before.contains(word) && !after.contains(word))
        throw Error(ErrorCode::InUse, fmt::format("\"{}\" uses the number \"{}\".", shownName(*feature), word),
                    "Give that parameter another value first.");
  }
}

Value renamedIn(const Value& value, const std::string& from, const std::string& to) {
  if (isNamedExpression(value)) {
    Value renamed = value;
    renamed["expression"] = withWord(value.at("expression").get<std::string>(), from, to);
    return renamed;
  }
  Value all = value;
  if (all.is_structured())
    for (Value& each : all) each = renamedIn(each, from, to);
  return all;
}

}  // namespace

std::vector<NamedNumber> numbersOf(const Document& document) {
  std::vector<NamedNumber> table;
  const auto rows = document.extra().find(key);
  if (rows == document.extra().end() || !rows->is_array()) return table;
  for (const Value& row : *rows) {
    if (!row.is_object()) continue;
    const Value name = row.value("name", Value()), value = row.value("value", Value());
    if (name.is_string() && (value.is_string() || value.is_number()))
      table.push_back({name.get<std::string>(), value.is_string() ? value.get<std::string>() : value.dump()});
  }
  return table;
}

NamedNumbers valuesOf(const std::vector<NamedNumber>& table) {
  checkNames(table);
  NamedNumbers values;
  const auto left = compute(table, values, true);
  if (!left.empty())
    throw Error(ErrorCode::InvalidParameter, fmt::format("{} = {} needs itself.", left.front()->name, left.front()->value),
                "Write one of the numbers that need each other as a number.");
  return values;
}

NamedNumbers namedNumbersOf(const Document& document) {
  NamedNumbers values;
  std::vector<NamedNumber> table = numbersOf(document);
  std::erase_if(table, [](const NamedNumber& row) { return !nameProblem(row.name).empty(); });
  compute(table, values, false);
  return values;
}

Document withNumbers(const Document& document, const Registry& registry, const std::vector<NamedNumber>& table) {
  const NamedNumbers values = valuesOf(table);
  refuseLost(document, namedNumbersOf(document), values);
  const Document changed = withTable(document, table);
  return withParameters(changed, registry, [&](const Feature& feature, const ParameterSpec& spec, const Value& written) {
    try {
      return withNames(spec, written, values, true);
    } catch (const Error& error) {
      throw Error(error.code(), fmt::format("\"{}\": {}", shownName(feature), error.message()), error.hint());
    }
  });
}

Document withNumberRenamed(const Document& document, const Registry& registry, const std::string& from,
                           const std::string& to) {
  std::vector<NamedNumber> table = numbersOf(document);
  const auto found = std::find_if(table.begin(), table.end(), [&](const NamedNumber& row) { return row.name == from; });
  if (found == table.end()) throw Error(ErrorCode::NotFound, fmt::format("The document has no number \"{}\".", from));
  found->name = to;
  for (NamedNumber& row : table) row.value = withWord(row.value, from, to);
  (void)valuesOf(table);
  Document renamed = withTable(document, table);
  renamed = withParameters(renamed, registry, [&](const Feature&, const ParameterSpec&, const Value& written) {
    return renamedIn(written, from, to);
  });
  return withNumbers(renamed, registry, table);
}

Document withNumbersApplied(const Document& document, const Registry& registry) {
  const NamedNumbers values = namedNumbersOf(document);
  if (values.empty()) return document;
  return withParameters(document, registry, [&](const Feature&, const ParameterSpec& spec, const Value& written) {
    return withNames(spec, written, values, false);
  });
}

}  // namespace blossom
