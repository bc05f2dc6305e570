#include "feature/frame_summary.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <set>

#include "parameter/wording.h"

namespace blossom {
namespace {

constexpr std::size_t warningsTold = 20;

/// "2 to 5", "9": runs of numbers, each counted from 1.
std::vector<std::string> runsOf(const std::vector<std::size_t>& frames) {
  std::vector<std::string> runs;
  for (std::size_t i = 0; i < frames.size();) {
    std::size_t end = i + 1;
    while (end < frames.size() && frames[end] == frames[end - 1] + 1) ++end;
    if (end - i > 2)
      runs.push_back(fmt::format("{} to {}", frames[i] + 1, frames[end - 1] + 1));
    else
      for (std::size_t k = i; k < end; ++k) runs.push_back(std::to_string(frames[k] + 1));
    i = end;
  }
  return runs;
}

std::string framesText(const std::vector<std::size_t>& frames, std::size_t all) {
  if (frames.size() == all) return all == 1 ? "Frame 1" : "Every frame";
  return (frames.size() == 1 ? "Frame " : "Frames ") + enumerated(runsOf(frames), "and");
}

/// "deviation_mm", "least" -> "deviation_least_mm"
std::string withEnd(const std::string& name, const char* end) {
  constexpr std::array<std::string_view, 4> units{"_ms", "_mm", "_mm2", "_s"};
  for (const std::string_view unit : units)
    if (name.size() > unit.size() && name.ends_with(unit))
      return name.substr(0, name.size() - unit.size()) + '_' + end + std::string(unit);
  return name + '_' + end;
}

void addStat(Value& stats, const std::string& name, const std::vector<Value>& values, std::size_t frames) {
  const bool numbers = std::all_of(values.begin(), values.end(), [](const Value& each) { return each.is_number(); });
  const bool same = std::all_of(values.begin(), values.end(), [&](const Value& each) { return each == values.front(); });
  if (numbers && name.ends_with("_ms")) {
    double sum = 0;
    for (const Value& each : values) sum += each.get<double>();
    stats[name] = sum;
  } else if (same && values.size() == frames) {
    stats[name] = values.front();
  } else if (numbers) {
    const auto [least, most] = std::minmax_element(values.begin(), values.end());
    stats[withEnd(name, "least")] = *least;
    stats[withEnd(name, "most")] = *most;
  }
}

bool isNumber(const Measure& measure) {
  return std::holds_alternative<double>(measure.value) || std::holds_alternative<std::int64_t>(measure.value);
}

void addFigure(std::vector<Measure>& figures, const std::string& name, const std::vector<Measure>& values,
               std::size_t frames) {
  const Measure& first = values.front();
  const auto same = [&](const Measure& each) { return each.value == first.value; };
  if (values.size() == frames && std::all_of(values.begin(), values.end(), same)) return figures.push_back(first);
  const auto alike = [&](const Measure& each) { return isNumber(each) && each.value.index() == first.value.index(); };
  if (!std::all_of(values.begin(), values.end(), alike)) return;
  const auto less = [](const Measure& a, const Measure& b) { return a.value < b.value; };
  const auto [least, most] = std::minmax_element(values.begin(), values.end(), less);
  figures.push_back({withEnd(name, "least"), least->value, first.unit});
  figures.push_back({withEnd(name, "most"), most->value, first.unit});
}

}  // namespace

void FrameSummary::add(Evaluated made) {
  if (made.stats.is_object())
    for (const auto& [name, value] : made.stats.items()) stats_[name].push_back(value);
  for (const Measure& figure : made.figures) {
    auto& values = figures_[figure.name];
    if (values.empty()) figureNames_.push_back(figure.name);
    values.push_back(figure);
  }
  for (const std::string& warning : made.warnings) {
    auto& frames = warned_[warning];
    if (frames.empty()) texts_.push_back(warning);
    if (frames.empty() || frames.back() != frames_) frames.push_back(frames_);
  }
  ++frames_;
}

std::vector<std::string> FrameSummary::warnings() const {
  std::vector<std::string> told;
  std::set<std::size_t> others;
  for (std::size_t i = 0; i < texts_.size(); ++i) {
    const auto& frames = warned_.at(texts_[i]);
    if (i < warningsTold)
      told.push_back(fmt::format("{}: {}", framesText(frames, frames_), texts_[i]));
    else
      others.insert(frames.begin(), frames.end());
  }
  if (!others.empty())
    told.push_back(fmt::format("There are more warnings in {} {}.", others.size(), others.size() == 1 ? "frame" : "frames"));
  return told;
}

Evaluated FrameSummary::told() const {
  Evaluated all;
  for (const auto& [name, values] : stats_) addStat(all.stats, name, values, frames_);
  for (const std::string& name : figureNames_) addFigure(all.figures, name, figures_.at(name), frames_);
  all.warnings = warnings();
  return all;
}

}  // namespace blossom
