#include "feature/frame_keys.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include "core/error.h"

namespace blossom {
namespace {

constexpr std::array<std::string_view, 5> eases{"linear", "in", "out", "in-out", "hold"};  // as Ease, and then hold

ParameterSpec fieldOf(std::string name, ParameterSpec spec, Value fallback, std::string help) {
  spec.name = std::move(name);
  spec.help = std::move(help);
  spec.fallback = std::move(fallback);
  return spec;
}

FrameKey keyOf(const Value& value) {
  FrameKey key;
  key.frame = value.at("frame").get<int>();
  key.t = value.at("t").get<double>();
  const auto name = static_cast<std::size_t>(
      std::find(eases.begin(), eases.end(), value.at("ease").get_ref<const std::string&>()) - eases.begin());
  key.hold = name >= eases.size() - 1;
  if (!key.hold) key.ease = static_cast<Ease>(name);
  return key;
}

Value valueOf(const FrameKey& key) {
  const std::size_t name = key.hold ? eases.size() - 1 : static_cast<std::size_t>(key.ease);
  return {{"frame", static_cast<std::int64_t>(key.frame)}, {"t", key.t}, {"ease", eases.at(name)}};
}

/// A place that was told by a quotient may lie beside its frame, and a key there must not be missed.
double frameAt(double place, int frames) {
  constexpr double rounding = 1e-9;
  const double frame = 1 + place * std::max(frames - 1, 0), whole = std::round(frame);
  return std::abs(frame - whole) < rounding ? whole : frame;
}

double evenPlace(int frame, int frames) { return frames < 2 ? 0 : static_cast<double>(frame - 1) / (frames - 1); }

}  // namespace

ParameterSpec frameKeys() {
  return whenNone(list(record({fieldOf("frame", count(1), std::int64_t{1}, "Frame of the sequence, counted from 1."),
                               fieldOf("t", ratio(), 0.5, "t of that frame."),
                               fieldOf("ease", choice({eases.begin(), eases.end()}), "linear",
                                       "How it goes on to the next key: in begins slowly, out ends slowly, hold stays.")})),
                  "evenly from 0 to 1");
}

bool isFrameKeys(const ParameterSpec& spec) {
  if (spec.kind != ParameterKind::List || spec.fields.size() != 1) return false;
  const std::vector<ParameterSpec> wanted = frameKeys().fields.front().fields, &fields = spec.fields.front().fields;
  return std::equal(wanted.begin(), wanted.end(), fields.begin(), fields.end(),
                    [](const auto& a, const auto& b) { return a.name == b.name && a.kind == b.kind; });
}

std::vector<FrameKey> frameKeysOf(const Value& keys) {
  std::vector<FrameKey> sorted;
  for (const Value& key : keys) sorted.push_back(keyOf(key));
  std::stable_sort(sorted.begin(), sorted.end(), [](const auto& a, const auto& b) { return a.frame < b.frame; });
  const auto twice =
      std::adjacent_find(sorted.begin(), sorted.end(), [](const auto& a, const auto& b) { return a.frame == b.frame; });
  if (twice != sorted.end())
    throw Error(ErrorCode::InvalidParameter, fmt::format("Two keys are at frame {}.", twice->frame),
                "Remove one, or move it to another frame.");
  return sorted;
}

double keyedTime(const std::vector<FrameKey>& sorted, double place, int frames) {
  if (sorted.empty()) return place;
  const double frame = frameAt(place, frames);
  const auto next = std::find_if(sorted.begin(), sorted.end(), [&](const FrameKey& key) { return key.frame > frame; });
  if (next == sorted.begin()) return sorted.front().t;
  const FrameKey& before = *std::prev(next);
  if (next == sorted.end() || before.hold) return before.t;
  return std::lerp(before.t, next->t, easedWay(before.ease, (frame - before.frame) / (next->frame - before.frame)));
}

Value withKeyAt(const Value& keys, int frame, int frames) {
  std::vector<FrameKey> sorted = frameKeysOf(keys);
  Value all = keys;
  const auto add = [&](const FrameKey& key) {
    if (std::none_of(all.begin(), all.end(), [&](const Value& each) { return each.at("frame") == key.frame; }))
      all.push_back(valueOf(key));
  };
  if (sorted.empty()) {
    sorted = {{1, 0}, {std::max(frames, 2), 1}};
    for (const FrameKey& key : sorted) add(key);
  }
  FrameKey key{frame, keyedTime(sorted, evenPlace(frame, frames), frames)};
  for (const FrameKey& before : sorted)
    if (before.frame < frame) key.ease = before.ease, key.hold = before.hold;
  add(key);
  std::stable_sort(all.begin(), all.end(), [](const Value& a, const Value& b) { return a.at("frame") < b.at("frame"); });
  return all;
}

Value withKeyMoved(const Value& keys, std::size_t key, int frame, int frames) {
  const int from = keys.at(key).at("frame").get<int>();
  int lowest = 1, highest = std::max(frames, 1);
  for (const Value& other : keys) {
    const int at = other.at("frame").get<int>();
    if (at < from) lowest = std::max(lowest, at + 1);
    if (at > from) highest = std::min(highest, at - 1);
  }
  Value all = keys;
  all[key]["frame"] = static_cast<std::int64_t>(std::clamp(frame, lowest, std::max(lowest, highest)));
  return all;
}

}  // namespace blossom
