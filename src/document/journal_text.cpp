#include "document/journal_text.h"

#include <fmt/format.h>
#include <zlib.h>

#include <charconv>
#include <map>

#include "core/error.h"
#include "document/document_json.h"

namespace blossom {
namespace {

constexpr std::size_t checksumDigits = 8;

std::uint32_t checksumOf(std::string_view text) {
  return static_cast<std::uint32_t>(
      ::crc32_z(0, reinterpret_cast<const unsigned char*>(text.data()), text.size()));  // NOLINT: zlib's own type of byte
}

std::vector<FeatureId> idsOf(const Document& document) {
  std::vector<FeatureId> ids;
  ids.reserve(document.features().size());
  for (const auto& feature : document.features()) ids.push_back(feature->id);
  return ids;
}

[[noreturn]] void misfit(const std::string& why) {
  throw Error(ErrorCode::FormatDamaged, fmt::format("A step of the journal does not fit: {}.", why));
}

const std::string& idOf(const Value& feature) {
  if (!feature.is_object() || !feature.contains("id") || !feature.at("id").is_string()) misfit("a feature has no id");
  return feature.at("id").get_ref<const std::string&>();
}

}  // namespace

std::string journalLine(const Value& value) {
  const std::string json = value.dump(-1, ' ', false, Value::error_handler_t::replace);
  return fmt::format("{:08x} {}\n", checksumOf(json), json);
}

std::optional<Value> readJournalLine(std::string_view line) {
  if (line.size() <= checksumDigits + 1 || line[checksumDigits] != ' ') return std::nullopt;
  std::uint32_t told = 0;
  const auto read = std::from_chars(line.data(), line.data() + checksumDigits, told, 16);
  if (read.ec != std::errc() || read.ptr != line.data() + checksumDigits) return std::nullopt;
  const std::string_view json = line.substr(checksumDigits + 1);
  if (checksumOf(json) != told) return std::nullopt;
  try {
    return parseJson(json);
  } catch (const Error&) {
    return std::nullopt;
  }
}

Value journalStep(const Document& before, const Document& after) {
  std::map<std::string_view, const Feature*> known;
  for (const auto& feature : before.features()) known.emplace(feature->id, feature.get());
  Value step = Value::object();
  Value put = Value::array();
  for (const auto& feature : after.features()) {
    const auto found = known.find(feature->id);
    const bool same = found != known.end() && (found->second == feature.get() || *found->second == *feature);
    if (!same) put.push_back(featureJson(*feature));
  }
  if (!put.empty()) step["put"] = std::move(put);
  if (auto order = idsOf(after); order != idsOf(before)) step["order"] = std::move(order);
  if (before.extra() != after.extra()) step["extra"] = after.extra();
  return step;
}

void applyJournalStep(Value& document, const Value& step) {
  std::map<std::string, Value> features;
  Value order = Value::array();
  for (Value& feature : document.at("features")) {
    const std::string id = idOf(feature);
    order.push_back(id);
    features[id] = std::move(feature);
  }
  if (const auto put = step.find("put"); put != step.end())
    for (const Value& feature : *put) features[idOf(feature)] = feature;
  if (const auto given = step.find("order"); given != step.end()) order = *given;
  Value list = Value::array();
  for (const Value& id : order) {
    const auto found = id.is_string() ? features.find(id.get<std::string>()) : features.end();
    if (found == features.end()) misfit("it names a feature that is not there");
    list.push_back(std::move(found->second));
    features.erase(found);
  }
  if (const auto extra = step.find("extra"); extra != step.end()) {
    const Value version = document.at("blossom");
    document = Value{{"blossom", version}};
    document.update(*extra);
    document["blossom"] = version;
  }
  document["features"] = std::move(list);
}

}  // namespace blossom
