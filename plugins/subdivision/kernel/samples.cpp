#include "kernel/samples.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/error.h"
#include "geometry/shape/bounds.h"
#include "geometry/tessellate/tessellate.h"

namespace blossom::subdivision {
namespace {

constexpr std::size_t maximumSamples = 20000;

double lengthOf(const std::vector<Vec3>& line) {
  double length = 0;
  for (std::size_t i = 0; i + 1 < line.size(); ++i) length += (line[i + 1] - line[i]).norm();
  return length;
}

/// `count` points at equal distances along a polyline, both ends among them; of a closed one the end is left out.
void addEven(const std::vector<Vec3>& line, std::size_t count, std::vector<Vec3>& samples) {
  const double length = lengthOf(line);
  const bool closed = (line.back() - line.front()).norm() <= 1e-9 * length;
  const double step = length / static_cast<double>(closed ? count : count - 1);
  double done = 0;
  std::size_t made = 0;
  for (std::size_t i = 0; i + 1 < line.size(); ++i) {
    const double piece = (line[i + 1] - line[i]).norm();
    while (made < count && static_cast<double>(made) * step <= done + piece) {
      const double share = piece > 0 ? (static_cast<double>(made) * step - done) / piece : 0;
      samples.emplace_back(line[i] + share * (line[i + 1] - line[i]));
      ++made;
    }
    done += piece;
  }
  if (made < count && !closed) samples.push_back(line.back());  // rounding kept it out
}

}  // namespace

std::vector<Vec3> samplesOf(const Shape& target, int count, const Progress& progress) {
  std::vector<Vec3> samples;
  if (const Mesh* mesh = target.get<Mesh>()) {
    samples = mesh->points;
  } else {
    const double chord = std::max(1e-5 * bounds(target).diagonal(), 1e-9);
    std::vector<std::vector<Vec3>> lines = tessellate(target, {.chord = chord}, progress).edges;
    std::erase_if(lines, [](const auto& line) { return line.size() < 2 || !(lengthOf(line) > 0); });
    double total = 0;
    for (const auto& line : lines) total += lengthOf(line);
    for (const auto& line : lines)
      addEven(line, std::max<std::size_t>(2, static_cast<std::size_t>(std::lround(count * lengthOf(line) / total))),
              samples);
  }
  if (samples.empty())
    throw Error(ErrorCode::InvalidInput, "The target has no point.", "Give a drawn curve or at least one point.");
  if (samples.size() > maximumSamples)
    throw Error(ErrorCode::InvalidInput,
                fmt::format("The target has {} points; {} are the most.", samples.size(), maximumSamples),
                "Thin the points out: a few hundred are enough for a smooth shape.");
  return samples;
}

}  // namespace blossom::subdivision
