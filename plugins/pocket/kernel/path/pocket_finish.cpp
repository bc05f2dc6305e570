// The last pass along the walls.
#include "kernel/path/pocket_cutter.h"

#include <algorithm>
#include <cmath>

#include "core/angle.h"

namespace blossom::pocket {

void PocketCutter::finish() {
  for (const std::size_t root : walls_.roots) {
    progress_.check();
    const PassNode& node = walls_.nodes[root];
    if (!isCleared(root)) {  // too narrow for the passes: nothing was cut there yet
      writer_.lift();
      atEachDepth([&] {
        clear(walls_, root);
        writer_.lift();
      });
      continue;
    }
    for (std::size_t i = 0; i < node.passes.size(); ++i) finish(node, i);
  }
}

bool PocketCutter::isCleared(std::size_t root) const {
  std::vector<Stroke> outline;
  for (const Pass& pass : walls_.nodes[root].passes)
    outline.insert(outline.end(), pass.strokes().begin(), pass.strokes().end());
  const InsideTest within(outline);
  return std::any_of(tree_.roots.begin(), tree_.roots.end(), [&](std::size_t cleared) {
    return within(tree_.nodes[cleared].passes.front().strokes().front().from);
  });
}

void PocketCutter::finish(const PassNode& node, std::size_t index) {
  const Pass& pass = node.passes[index];
  ++result_.loops;
  const auto [nearestPlace, farthest] = besidePasses(pass);
  const Beside nearest = nearestPlace;
  writer_.lift();
  if (nearest.distance > o_.finish + 2 * o_.tolerance) {  // all of it where the passes did not come
    atEachDepth([&] {
      runAround(node, index, entered(pass));
      writer_.lift();
    });
  } else if (farthest > o_.finish + radius_ / 2) {  // some of it runs through full material, so it goes down in steps
    atEachDepth([&] { finish(pass, nearest.at); });
  } else {
    finish(pass, nearest.at);
  }
}

std::pair<PocketCutter::Beside, double> PocketCutter::besidePasses(const Pass& pass) const {
  Beside nearest;
  double farthest = 0, begin = 0;
  const double apart = radius_ / 4;
  for (const Stroke& s : pass.strokes()) {
    const int steps = std::max(1, static_cast<int>(std::ceil(s.length() / apart)));
    for (int k = 0; k < steps; ++k) {
      const double share = (k + 0.5) / steps;
      const double away = rim_.nearest(s.at(share)).distance;
      if (away < nearest.distance) nearest = {begin + share * s.length(), away};
      farthest = std::max(farthest, away);
    }
    begin += s.length();
  }
  return {nearest, farthest};
}

void PocketCutter::plungeBeside(const Vec2& p) {
  writer_.approach(p, 0);
  writer_.straight(p, floor_);
}

void PocketCutter::finish(const Pass& pass, double nearest) {
  const double radius = std::max(o_.finish, radius_ / 4);
  const auto lead = leadPlace(pass, radius);
  writer_.lift();
  if (!lead) {
    Vec2 begin = pass.strokes().front().from;
    pass.walk(nearest, 1e-6, [&](const Stroke& s) { begin = s.from; });
    const Stroke& passed = rim_.strokes()[rim_.nearest(begin).stroke];
    plungeBeside(passed.at(passed.nearestShare(begin)));
    writer_.straight(begin);
    writer_.along(pass, nearest, pass.length(), floor_);
    return;
  }
  const auto [at, side] = *lead;
  Stroke tangent;
  pass.walk(at, 1e-6, [&](const Stroke& s) { tangent = s; });
  const Vec2 point = tangent.from, along = tangent.direction(0), in = side * Vec2(-along.y(), along.x());
  const Vec2 center = point + radius * in;
  const double angle = std::atan2(-in.y(), -in.x());
  const Stroke arrive = Stroke::arc(center, radius, angle - side * fullTurn / 4, side * fullTurn / 4);
  const Stroke leave = Stroke::arc(center, radius, angle, side * fullTurn / 4);
  plungeBeside(arrive.from);
  writer_.along(arrive);
  writer_.straight(point);
  writer_.along(pass, at, pass.length(), floor_);
  writer_.along(leave);
}

std::optional<std::pair<double, double>> PocketCutter::leadPlace(const Pass& pass, double radius) const {
  const double side = o_.climb ? 1 : -1;
  double begin = 0;
  for (const Stroke& s : pass.strokes()) {
    const double whole = s.length();
    if (whole > 1e-3) {
      const Vec2 along = s.direction(0.5), in = side * Vec2(-along.y(), along.x());
      const Vec2 center = s.at(0.5) + radius * in;
      constexpr double touching = 1e-6;
      const double needed = radius_ + o_.leaveWall + radius - 2 * o_.tolerance;
      if (diagram_.clearance(center) >= needed - touching && inside_(center + radius * along) &&
          inside_(center - radius * along))
        return std::pair(begin + whole / 2, side);
    }
    begin += whole;
  }
  return std::nullopt;
}

}  // namespace blossom::pocket
