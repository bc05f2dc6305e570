#include "cli/feature_table.h"

#include <fmt/format.h>

#include <ostream>

#include "cli/report.h"

namespace blossom {
namespace {

Value featureJson(const Feature& feature, const FeatureResult* result, const Progress& progress) {
  Value row{{"id", feature.id}, {"type", feature.type}, {"name", feature.name}, {"state", "suppressed"}};
  if (!result) return row;
  row["state"] = result->error ? "failed" : "done";
  row["kernel_ms"] = result->kernelMs;
  if (result->error) {
    row["error"] = toJson(*result->error);
    return row;
  }
  row["result"] = resultJson(measured(result->evaluated, progress));
  row["stats"] = result->evaluated.stats;
  row["warnings"] = result->evaluated.warnings;
  return row;
}

}  // namespace

Value featuresJson(const Document& document, const Results& results, const Progress& progress) {
  Value rows = Value::array();
  for (const auto& feature : document.features()) {
    const auto found = results.find(feature->id);
    rows.push_back(
        featureJson(*feature, found == results.end() || feature->suppressed ? nullptr : found->second.get(), progress));
  }
  return rows;
}

std::string shortResult(const Value& result) {
  std::string text = result.value("kind", "");
  for (const char* name :
       {"degree_u", "degree_v", "poles_u", "poles_v", "faces", "loops", "curves", "frames", "area", "volume"}) {
    const auto found = result.find(name);
    if (found == result.end()) continue;
    const std::string value = found->is_number_float() ? fmt::format("{:.6g}", found->get<double>()) : found->dump();
    text += fmt::format(", {} {}", rowsOf(Value{{name, 0}}).front().name, value);
  }
  return text;
}

void printFeatureTable(std::ostream& out, const Value& features) {
  std::vector<std::vector<std::string>> lines;
  for (const Value& row : features) {
    const std::string time = row.contains("kernel_ms") ? fmt::format("{:.1f} ms", row["kernel_ms"].get<double>()) : "";
    std::string outcome = row.contains("result") ? shortResult(row["result"]) : "";
    if (row.contains("error")) outcome = row["error"]["message"].get<std::string>();
    lines.push_back({row["id"], row["name"], row["state"], time, outcome});
  }
  printTable(out, {"FEATURE", "NAME", "STATE", "TIME", "RESULT"}, lines);
}

}  // namespace blossom
