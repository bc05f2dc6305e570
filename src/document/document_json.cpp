#include "document/document_json.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <optional>
#include <set>

#include "core/error.h"
#include "core/version.h"
#include "document/json_text.h"

namespace blossom {
namespace {

constexpr std::array<std::string_view, 7> featureKeys{"id", "type", "name", "inputs", "parameters", "visible", "suppressed"};

bool isFeatureKey(std::string_view key) {
  return std::find(featureKeys.begin(), featureKeys.end(), key) != featureKeys.end();
}

/// Reads the members of one feature; each wrong one is a problem and keeps its default.
class FeatureReader {
 public:
  FeatureReader(const Value& json, std::size_t number, Problems& problems)
      : json_(json), number_(number), problems_(problems) {}

  std::optional<Feature> read() {
    if (!json_.is_object()) {
      problems_.report(fmt::format("feature {} is no object", number_));
      return std::nullopt;
    }
    Feature feature;
    take("id", feature.id, &Value::is_string, "a text");
    take("type", feature.type, &Value::is_string, "a text");
    take("name", feature.name, &Value::is_string, "a text");
    take("parameters", feature.parameters, &Value::is_object, "an object");
    take("visible", feature.visible, &Value::is_boolean, "true or false");
    take("suppressed", feature.suppressed, &Value::is_boolean, "true or false");
    readInputs(feature);
    for (const auto& [key, value] : json_.items())
      if (!isFeatureKey(key)) feature.extra[key] = value;
    if (!feature.id.empty() && !feature.type.empty()) return feature;
    problems_.report(fmt::format("feature {} has no {}", number_, feature.id.empty() ? "id" : "type"));
    return std::nullopt;
  }

 private:
  template <class T>
  void take(const char* key, T& out, bool (Value::*isRight)() const noexcept, const char* form) {
    const auto found = json_.find(key);
    if (found == json_.end()) return;
    if (((*found).*isRight)())
      out = found->template get<T>();
    else
      problems_.report(fmt::format("\"{}\" of feature {} must be {}", key, number_, form));
  }

  void readInputs(Feature& feature) {
    const Value inputs = json_.value("inputs", Value::array());
    const auto isText = [](const Value& v) { return v.is_string(); };
    if (inputs.is_array() && std::all_of(inputs.begin(), inputs.end(), isText))
      feature.inputs = inputs.get<std::vector<FeatureId>>();
    else
      problems_.report(fmt::format("\"inputs\" of feature {} must be a list of ids", number_));
  }

  const Value& json_;
  std::size_t number_;
  Problems& problems_;
};

/// The second of two equal ids gets a new one: its parameters are worth keeping, references go to the first.
void separateIds(std::vector<Feature>& features, Problems& problems) {
  std::set<FeatureId> ids;
  for (const auto& feature : features) ids.insert(feature.id);
  std::set<FeatureId> seen;
  for (auto& feature : features) {
    if (seen.insert(feature.id).second) continue;
    problems.report(fmt::format("two features have the id \"{}\"", feature.id));
    for (std::size_t n = 2;; ++n) {
      const FeatureId id = fmt::format("{}-{}", feature.id, n);
      if (!ids.insert(id).second) continue;
      feature.id = id;
      seen.insert(id);
      break;
    }
  }
}

void dropMissingInputs(std::vector<Feature>& features, Problems& problems) {
  std::set<FeatureId> ids;
  for (const auto& feature : features) ids.insert(feature.id);
  for (auto& feature : features)
    std::erase_if(feature.inputs, [&](const FeatureId& input) {
      if (ids.contains(input)) return false;
      problems.report(fmt::format("the input \"{}\" of \"{}\" is missing", input, feature.id));
      return true;
    });
}

/// Places features whose inputs are placed; where only cycles are left, the first loses the inputs that are not.
void breakCycles(std::vector<Feature>& features, Problems& problems) {
  std::set<FeatureId> placed;
  const auto isPlaced = [&](const FeatureId& id) { return placed.contains(id); };
  while (placed.size() < features.size()) {
    const std::size_t before = placed.size();
    for (const auto& feature : features)
      if (std::all_of(feature.inputs.begin(), feature.inputs.end(), isPlaced)) placed.insert(feature.id);
    if (placed.size() > before) continue;
    const auto stuck = std::find_if(features.begin(), features.end(), [&](const Feature& f) { return !isPlaced(f.id); });
    problems.report(fmt::format("\"{}\" depends on itself", stuck->id));
    std::erase_if(stuck->inputs, [&](const FeatureId& input) { return !isPlaced(input); });
  }
}

void checkVersion(std::uint64_t version, const Problems& problems) {
  if (version <= documentFormatVersion) return;
  throw Error(ErrorCode::FormatTooNew,
              fmt::format("{} was written by a later Blossom (format {}; this one reads up to {}).", problems.subject(),
                          version, documentFormatVersion),
              "Install a newer Blossom to open it.");
}

/// The number after "blossom": in a text that is no longer JSON; 0 when it is not there.
std::uint64_t versionInText(const std::string& text) {
  std::size_t at = text.find("\"blossom\"");
  if (at == std::string::npos || (at = text.find_first_not_of(" :\t\r\n", at + 9)) == std::string::npos) return 0;
  std::uint64_t version = 0;
  std::from_chars(text.data() + at, text.data() + text.size(), version);
  return version;
}

/// The whole document as JSON, or what is complete of it.
Value parsedOrSalvaged(const std::string& text, Problems& problems) {
  try {
    return parseJson(text);
  } catch (const Error& e) {
    checkVersion(versionInText(text), problems);
    problems.report(e.message().substr(0, e.message().size() - 1));
  }
  Value features = Value::array();
  for (const auto& object : completeObjects(text, "features")) {
    try {
      features.push_back(parseJson(object));
    } catch (const Error&) {
      problems.report(fmt::format("what follows feature {} cannot be read", features.size()));
    }
  }
  if (features.empty()) problems.fail("no feature in it can be read");
  return {{"blossom", static_cast<unsigned>(documentFormatVersion)}, {"features", features}};
}

}  // namespace

void Problems::report(const std::string& what) {
  if (!salvage_) fail(what);
  std::string sentence = what + ".";
  sentence[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(sentence[0])));
  warnings.push_back(std::move(sentence));
}

void Problems::fail(const std::string& what) const {
  throw Error(ErrorCode::FormatDamaged, fmt::format("{} is damaged: {}.", subject_, what),
              salvage_ ? "Nothing in it can be recovered." : "What is readable of it can be recovered and opened.");
}

Document readDocumentJson(const std::string& text, Problems& problems) {
  const Value root = parsedOrSalvaged(text, problems);
  if (!root.is_object()) problems.fail("it holds no object");
  const Value version = root.value("blossom", Value());
  if (version.is_number_unsigned() && version != 0u)
    checkVersion(version.get<std::uint64_t>(), problems);
  else
    problems.report("it does not tell its format version");
  const Value list = root.value("features", Value());
  if (!list.is_array()) problems.fail("it has no list of features");
  if (list.size() > maximumFeatures)
    throw Error(ErrorCode::LimitExceeded,
                fmt::format("{} has {} features; the limit is {}.", problems.subject(), list.size(), maximumFeatures));

  std::vector<Feature> features;
  for (std::size_t i = 0; i < list.size(); ++i)
    if (auto feature = FeatureReader(list[i], i + 1, problems).read()) features.push_back(std::move(*feature));
  separateIds(features, problems);
  dropMissingInputs(features, problems);
  breakCycles(features, problems);

  Value extra = Value::object();
  for (const auto& [key, value] : root.items())
    if (key != "blossom" && key != "features") extra[key] = value;
  return Document::of(std::move(features)).withExtra(std::move(extra));
}

Value featureJson(const Feature& feature) {
  Value json{{"id", feature.id}, {"type", feature.type}, {"name", feature.name}, {"inputs", feature.inputs}};
  json["parameters"] = feature.parameters.is_object() ? feature.parameters : Value::object();
  if (!feature.visible) json["visible"] = false;
  if (feature.suppressed) json["suppressed"] = true;
  for (const auto& [key, value] : feature.extra.items())
    if (!isFeatureKey(key)) json[key] = value;
  return json;
}

Value documentJson(const Document& document) {
  Value json{{"blossom", documentFormatVersion}, {"features", Value::array()}};
  for (const auto& feature : document.features()) json["features"].push_back(featureJson(*feature));
  for (const auto& [key, value] : document.extra().items())
    if (!json.contains(key)) json[key] = value;
  return json;
}

std::string toJson(const Document& document) { return prettyJson(documentJson(document)); }

OpenedDocument fromJson(const std::string& json, bool salvage) {
  Problems problems("The document", salvage);
  OpenedDocument opened;
  opened.document = readDocumentJson(json, problems);
  opened.warnings = std::move(problems.warnings);
  return opened;
}

}  // namespace blossom
