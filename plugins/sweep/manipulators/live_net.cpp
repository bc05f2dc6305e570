#include "manipulators/live_net.h"

namespace blossom::sweep {

namespace {

bool differs(const MotionGrid& a, const MotionGrid& b, std::size_t k, std::size_t l) {
  const std::size_t i = k * a.countV + l;
  return a.point[0][i] != b.point[0][i] || a.point[1][i] != b.point[1][i] || a.point[2][i] != b.point[2][i];
}

/// The runs of changed points of one line of the grid, each with the points beside it, where the surface is as it was.
template <class Changed, class At>
void addRuns(std::size_t count, const Changed& changed, const At& at, std::vector<std::vector<Vec3>>& lines) {
  std::vector<Vec3> run;
  for (std::size_t i = 0; i < count; ++i) {
    const bool near = changed(i) || (i > 0 && changed(i - 1)) || (i + 1 < count && changed(i + 1));
    if (near) run.push_back(at(i));
    if (near && i + 1 < count) continue;
    if (run.size() > 1) lines.push_back(std::move(run));
    run.clear();
  }
}

}  // namespace

std::vector<std::vector<Vec3>> changedNet(const MotionGrid& before, const MotionGrid& now, std::size_t every) {
  std::vector<std::vector<Vec3>> lines;
  // The last row and column are drawn, too: the border of an open surface.
  const auto drawn = [every](std::size_t i, std::size_t count) { return i % every == 0 || i + 1 == count; };
  for (std::size_t k = 0; k < now.countU; ++k)
    if (drawn(k, now.countU))
      addRuns(
          now.countV, [&](std::size_t l) { return differs(before, now, k, l); },
          [&](std::size_t l) { return now.pointAt(k, l); }, lines);
  for (std::size_t l = 0; l < now.countV; ++l)
    if (drawn(l, now.countV))
      addRuns(
          now.countU, [&](std::size_t k) { return differs(before, now, k, l); },
          [&](std::size_t k) { return now.pointAt(k, l); }, lines);
  return lines;
}

}  // namespace blossom::sweep
