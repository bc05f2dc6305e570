// Where the tool goes: lines, arcs and NURBS.
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "exchange/gcode/gcode_parser.h"

namespace blossom {

Vec3 GcodeParser::target(const Block& b) const {
  if (absolute_) return {b.x.value_or(at_.x()), b.y.value_or(at_.y()), b.z.value_or(at_.z())};
  return at_ + Vec3(b.x.value_or(0), b.y.value_or(0), b.z.value_or(0));
}

void GcodeParser::countMove() {
  static constexpr const char* names[] = {"", "G0", "G1", "G2", "G3", "G5.2"};
  if (motion_ != GcodeMotion::None) count(program_.counts, names[static_cast<int>(motion_)]);
}

void GcodeParser::motionOf(const Block& block) {
  const bool plane = block.x || block.y;
  if (block.machine) return overTheMachine(block);
  if (block.unknownZ) cannotFollow("a height that is a parameter or an expression");
  if (block.namesAny() || block.i || block.j) watch_.moves();
  if (motion_ == GcodeMotion::Nurbs) return addNurbs(block, plane);
  const bool round = motion_ == GcodeMotion::Clockwise || motion_ == GcodeMotion::Counterclockwise;
  const bool upright = round && normal_ != 2;
  const bool centred = plane || block.i || block.j || (upright && (block.z || block.k));
  if (!centred && !block.z && !block.unknownZ) return;
  countMove();
  if (motion_ == GcodeMotion::None) {
    if (centred) damaged("coordinates without a motion (G0, G1, ..)");
    return cannotFollow("a height without a motion");
  }
  if (!absolute_) refuseFromNowhere(block);
  atWork_ = true;
  const Vec3 to = target(block);
  for (int axis = 0; axis < 3; ++axis)
    if (block.names(axis)) unknown_.reset(static_cast<std::size_t>(axis));
  if (round && !centred) damaged("an arc needs I, J or R");
  if (round && (block.weight.value_or(1) != 1 || block.order)) cannotFollow("an arc of several turns (P, L)");
  if (motion_ != GcodeMotion::Rapid) {
    if (left_ && unknown_.any()) cannotFollow("a cut from a place that the file does not tell (after G28, G30 or G53)");
    beginCutting();
    noteCoolant();
    watch_.cuts();
  }
  justStarted_ = justStarted_ && motion_ == GcodeMotion::Rapid;
  if (upright) return addUprightArc(block, to);
  const Vec2 middle = round ? center(block, at_.head<2>(), to.head<2>(), {block.i, block.j}) : Vec2(0, 0);
  if (round)
    arcs_.arc(lineNumber_, at_.head<2>(), to.head<2>(), middle, motion_ == GcodeMotion::Counterclockwise, !block.radius);
  else
    arcs_.straight(at_.head<2>(), to.head<2>());
  addMove(motion_, to, middle, centred);
}

void GcodeParser::addUprightArc(const Block& block, const Vec3& to) {
  const int a = (normal_ + 1) % 3, b = (normal_ + 2) % 3;
  const std::array<std::optional<double>, 3> offsets{block.i, block.j, block.k};
  const auto index = [](int axis) { return static_cast<std::size_t>(axis); };
  const auto flat = [&](const Vec3& p) { return Vec2(p[a], p[b]); };
  const Vec3 from = at_;
  const Vec2 middle = center(block, flat(from), flat(to), {offsets[index(a)], offsets[index(b)]});
  arcs_.straight(from.head<2>(), from.head<2>());  // its neighbours lie in another plane
  arcs_.arc(lineNumber_, flat(from), flat(to), middle, motion_ == GcodeMotion::Counterclockwise, !block.radius);
  arcs_.straight(from.head<2>(), from.head<2>());
  ToolMove turn;
  turn.to = {to[a], to[b], to[normal_]};
  turn.turn = motion_ == GcodeMotion::Clockwise ? -1 : 1;
  turn.center = middle;
  constexpr double chord = 1e-3;
  const GcodeMotion whole = std::exchange(motion_, GcodeMotion::Line);
  for (const Vec3& p : polylineOf({from[a], from[b], from[normal_]}, turn, chord)) {
    Vec3 next = at_;
    next[a] = p.x();
    next[b] = p.y();
    next[normal_] = p.z();
    if (next != at_) addMove(GcodeMotion::Line, next, {}, true);
  }
  motion_ = whole;
}

void GcodeParser::overTheMachine(const Block& block) {
  count(program_.skipped, "machine coordinates");
  if (!block.over && motion_ != GcodeMotion::Rapid && block.namesAny())
    cannotFollow("a cut in the machine's coordinates (G53)");
  const Vec3 to = block.over && block.namesAny() ? target(block) : at_;
  addMove(GcodeMotion::Rapid, to, {}, true);
  for (int axis = 0; axis < 3; ++axis)
    if (block.names(axis) || !block.namesAny()) unknown_.set(static_cast<std::size_t>(axis));
  program_.moves.back().unknown = unknown_;
  left_ = true;
}

void GcodeParser::refuseFromNowhere(const Block& block) {
  for (int axis = 0; axis < 3; ++axis)
    if (block.names(axis) && unknown_.test(static_cast<std::size_t>(axis)))
      cannotFollow("a relative move (G91) from a place that the file does not tell");
}

void GcodeParser::addMove(GcodeMotion motion, const Vec3& to, const Vec2& center, bool inPlane) {
  GcodeMove move{motion, at_, to, center, feed_, 0, lineNumber_, inPlane, unknown_};
  program_.movesInZ = program_.movesInZ || at_.z() != to.z();
  program_.moves.push_back(move);
  at_ = to;
}

Vec2 GcodeParser::center(const Block& b, const Vec2& from, const Vec2& to, const Offsets& offsets) {
  const auto& [first, second] = offsets;
  const bool clockwise = motion_ == GcodeMotion::Clockwise;
  if (b.radius) {
    const Vec2 chord = to - from;
    const double half = chord.norm() / 2;
    if (half == 0 || half > std::abs(*b.radius) * (1 + 1e-4)) damaged("the arc's radius R does not reach its end");
    const double height = std::sqrt(std::max(0.0, *b.radius * *b.radius - half * half));
    const Vec2 left = Vec2(-chord.y(), chord.x()) / (2 * half);
    return from + chord / 2 + left * height * ((clockwise != (*b.radius < 0)) ? -1 : 1);
  }
  if (!first && !second) damaged("an arc needs I, J or R");
  const Vec2 middle = absoluteCenters_ ? Vec2(first.value_or(from.x()), second.value_or(from.y()))
                                       : Vec2(from + Vec2(first.value_or(0), second.value_or(0)));
  const double radius = (from - middle).norm(), mismatch = std::abs((to - middle).norm() - radius);
  if (radius == 0) damaged("the arc has no radius");
  // What machines refuse: GRBL and LinuxCNC alike.
  if (mismatch > 0.5 || (mismatch > 0.005 && mismatch > 1e-3 * radius)) cannotFollow("an arc that misses its end");
  return middle;
}

void GcodeParser::addNurbs(const Block& b, bool plane) {
  if (nurbs_.empty()) {
    count(program_.counts, "G5.2");
    nurbs_.emplace_back(at_.x(), at_.y(), 1);  // the curve starts where the tool is
    order_ = 3;
  }
  if (b.order) order_ = static_cast<int>(std::clamp(*b.order, 2.0, 26.0));
  if (!plane) return;
  const Vec3 pole = target(b);
  const double w = b.weight.value_or(1);
  if (!(w > 0)) damaged("the weight P must be above 0");
  nurbs_.emplace_back(pole.x() * w, pole.y() * w, w);
  nurbsEnd_ = {pole.x(), pole.y(), at_.z()};
}

void GcodeParser::finishNurbs() {
  if (motion_ == GcodeMotion::Nurbs) motion_ = GcodeMotion::None;
  if (nurbs_.empty()) return;
  if (nurbs_.size() < 2) damaged("a G5.2 curve needs at least two control points");
  Spline2 spline;
  spline.degree = std::min(order_, static_cast<int>(nurbs_.size())) - 1;
  const auto poles = static_cast<int>(nurbs_.size());
  for (int k = 0; k <= poles + spline.degree; ++k)
    spline.knots.push_back(std::clamp(k - spline.degree, 0, poles - spline.degree));
  spline.poles = std::move(nurbs_);
  nurbs_.clear();
  addMove(GcodeMotion::Nurbs, nurbsEnd_, {}, true);
  program_.moves.back().spline = program_.splines.size();
  program_.splines.push_back(std::move(spline));
}

}  // namespace blossom
