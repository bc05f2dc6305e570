// How the tool gets down into the material, and from pass to pass.
#include "kernel/path/pocket_cutter.h"

#include <algorithm>
#include <cmath>

#include "core/angle.h"

namespace blossom::pocket {

namespace {

/// Of the tool's radius: a tool that winds down on a smaller circle drills, whatever its way is called.
constexpr double minimumTurn = 0.4;

}  // namespace

double PocketCutter::linked(const Pass::Foot& foot) {
  writer_.straight(foot.point);
  return foot.at;
}

bool PocketCutter::mayStayDown(const Vec2& from, const Vec2& to) const {
  const double way = (to - from).norm();
  if (way > 2 * radius_ + o_.stepover) return false;
  constexpr double margin = 1e-4;  // the ends may lie on the rim
  if (way <= 2 * margin) return true;
  const Vec2 inwards = (to - from) * (std::min(margin, way / 4) / way);
  const Stroke link = Stroke::line(from + inwards, to - inwards);
  return inside_(link.at(0.5)) && rim_.nearest(link, 1).distance > 1e-9;
}

double PocketCutter::entered(const Pass& pass) {
  ++result_.entries;
  const Vec2 start = pass.strokes().front().from;
  writer_.approach(start, above_);
  const double distance = (above_ - floor_) / std::tan(o_.rampAngle);
  constexpr double maximumTurns = 40;
  const bool room = pass.length() > fullTurn * minimumTurn * radius_ && distance < maximumTurns * pass.length();
  if (o_.entry == Entry::Plunge || !room) {
    if (o_.entry != Entry::Plunge) ++result_.plunged;
    writer_.straight(start, floor_);
    return 0;
  }
  writer_.along(pass, 0, distance, floor_);
  return std::fmod(distance, pass.length());
}

bool PocketCutter::helix(const PassNode& node) {
  const auto [middle, clearance] = widest(node);
  const double room = clearance - radius_ - o_.leaveWall - o_.finish;
  const double turn = std::min(0.8 * radius_, room);
  if (turn < minimumTurn * radius_) return false;
  ++result_.entries;
  const double side = o_.climb ? 1 : -1;
  const Stroke there = Stroke::arc(middle, turn, 0, side * fullTurn / 2);
  const Stroke back = Stroke::arc(middle, turn, fullTurn / 2, side * fullTurn / 2);
  writer_.approach(there.from, above_);
  const double fall = above_ - floor_;
  const int halves = std::max(2, static_cast<int>(std::ceil(fall / (std::tan(o_.rampAngle) * there.length()))));
  for (int i = 1; i <= halves; ++i) writer_.along(i % 2 == 1 ? there : back, above_ - fall * i / halves);
  if (halves % 2 == 1) writer_.along(back);
  writer_.along(there);
  writer_.along(back);
  Pass::Foot nearest;
  for (const Pass& pass : node.passes)
    if (const Pass::Foot foot = pass.nearest(writer_.place()); foot.distance < nearest.distance) nearest = foot;
  // Around a corner: from the middle of the disc, the way to the nearest pass is free.
  if (!mayStayDown(writer_.place(), nearest.point)) writer_.straight(middle);
  return true;
}

std::pair<Vec2, double> PocketCutter::widest(const PassNode& node) {
  if (!axis_) axis_ = diagram_.medialAxis(progress_);
  std::vector<Stroke> rim;
  for (const Pass& pass : node.passes) rim.insert(rim.end(), pass.strokes().begin(), pass.strokes().end());
  const InsideTest within(rim);
  std::pair<Vec2, double> best{Vec2::Zero(), 0};
  const auto take = [&](const Vec2& p, double clearance) {
    if (clearance > best.second && within(p)) best = {p, clearance};
  };
  for (const MedialVertex& v : axis_->vertices) take(v.at, v.clearance);
  for (const MedialEdge& edge : axis_->edges)
    for (const Vec3& p : edge.points) take(p.head<2>(), p.z());
  take(diagram_.largestCenter(), diagram_.largestClearance());
  return best;
}

}  // namespace blossom::pocket
