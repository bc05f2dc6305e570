#include "kernel/path/path_writer.h"

#include <algorithm>

namespace blossom::pocket {

namespace {

/// Arcs shorter than this are written as lines, because their ends cannot be distinguished.
constexpr double shortestArc = 1e-4;

}  // namespace

void PathWriter::add(MoveKind kind, const Vec3& to, double feed) {
  if (to == at_) return;
  ToolMove move;
  move.kind = kind;
  move.to = to;
  move.feed = feed;
  path_.moves.push_back(move);
  at_ = to;
}

void PathWriter::lift() {
  if (begun_) add(MoveKind::Rapid, {at_.x(), at_.y(), heights_.safe}, 0);
}

void PathWriter::approach(const Vec2& p, double material) {
  if (begun_) {
    lift();
    add(MoveKind::Rapid, {p.x(), p.y(), heights_.safe}, 0);
  } else {
    at_ = path_.start = {p.x(), p.y(), heights_.safe};
    begun_ = true;
  }
  const double gap = material + heights_.approach;
  if (gap < heights_.safe) add(MoveKind::Rapid, {p.x(), p.y(), gap}, 0);
  add(MoveKind::Plunge, {p.x(), p.y(), material}, plungeFeed_);
}

void PathWriter::straight(const Vec2& to, double z) {
  const bool falls = z < at_.z();
  add(falls ? MoveKind::Plunge : MoveKind::Feed, {to.x(), to.y(), z}, falls ? plungeFeed_ : feed_);
}

void PathWriter::along(const Stroke& stroke, double z) {
  if (!stroke.round || stroke.length() < shortestArc) return straight(stroke.to, z);
  const bool falls = z < at_.z();
  ToolMove move;
  move.kind = falls ? MoveKind::Plunge : MoveKind::Feed;
  move.feed = falls ? plungeFeed_ : feed_;
  move.to = {stroke.to.x(), stroke.to.y(), z};
  move.turn = stroke.sweep > 0 ? 1 : -1;
  move.center = stroke.center;
  path_.moves.push_back(move);
  at_ = move.to;
}

void PathWriter::along(const Pass& pass, double from, double distance, double z) {
  const double begin = at_.z();
  double gone = 0;
  pass.walk(from, distance, [&](const Stroke& stroke) {
    gone += stroke.length();
    along(stroke, begin + (z - begin) * std::min(1.0, gone / distance));
  });
  if (at_.z() != z) straight(at_.head<2>(), z);
}

}  // namespace blossom::pocket
