#include "exchange/svg/svg_path.h"

#include <2geom/path-sink.h>
#include <2geom/svg-path-parser.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/angle.h"
#include "core/error.h"
#include "exchange/format/text.h"
#include "geometry/planar/planar.h"
#include "geometry/planar/single_point.h"

namespace blossom::svg {
namespace {

constexpr double largestCoordinate = 1e12;

Spline2 bezier(std::initializer_list<Vec2> points) {
  Spline2 spline;
  spline.degree = static_cast<int>(points.size()) - 1;
  spline.knots.assign(points.size(), 0);
  spline.knots.insert(spline.knots.end(), points.size(), 1);
  for (const Vec2& p : points) spline.poles.emplace_back(p.x(), p.y(), 1);
  return spline;
}

/// Receives what lib2geom parses. It throws only when all has been parsed: lib2geom loses a piece that its receiver refuses.
class Builder final : public Geom::PathSink {
 public:
  using Geom::PathSink::feed;

  void moveTo(const Geom::Point& p) override {
    finish(false);
    start_ = at_ = checked(p);
  }
  void lineTo(const Geom::Point& p) override {
    const Vec2 to = checked(p);
    if (to != at_) current_.segments.push_back(Line2{at_, to});
    isPoint_ = to == at_;
    at_ = to;
  }
  void curveTo(const Geom::Point& a, const Geom::Point& b, const Geom::Point& p) override {
    addBezier({at_, checked(a), checked(b), checked(p)});
  }
  void quadTo(const Geom::Point& a, const Geom::Point& p) override { addBezier({at_, checked(a), checked(p)}); }
  void arcTo(double rx, double ry, double rotation, bool large, bool sweep, const Geom::Point& p) override {
    const Vec2 to = checked(p);
    checked({rx, ry});
    if (!allGood_) return;
    for (Segment& s : arcSegment(at_, to, rx, ry, rotation, large, sweep)) current_.segments.push_back(std::move(s));
    at_ = to;
  }
  void closePath() override {
    // Nearer than the digits of a file tell, no line is meant.
    constexpr double rounding = 1e-14;
    if ((at_ - start_).norm() > rounding * start_.cwiseAbs().maxCoeff()) current_.segments.push_back(Line2{at_, start_});
    at_ = start_;
    finish(true);
  }
  void flush() override { finish(false); }

  std::vector<Path> take() {
    finish(false);
    if (!allGood_) throw Error(ErrorCode::FormatDamaged, "A path has a coordinate that is not a number or too large.");
    return std::move(paths_);
  }

 private:
  Vec2 checked(const Geom::Point& p) {
    const Vec2 point(p.x(), p.y());
    const bool good = point.allFinite() && point.cwiseAbs().maxCoeff() <= largestCoordinate;
    allGood_ = allGood_ && good;
    return good ? point : at_;
  }

  void addBezier(std::initializer_list<Vec2> points) {
    const bool isPoint = std::all_of(points.begin(), points.end(), [&](const Vec2& p) { return p == at_; });
    if (!isPoint) current_.segments.push_back(bezier(points));
    at_ = *(points.end() - 1);
  }

  void finish(bool closed) {
    current_.closed = closed;
    if (current_.segments.empty() && isPoint_) current_ = pointDrawing(at_).paths.front();
    if (!current_.segments.empty()) paths_.push_back(std::move(current_));
    current_ = {};
    isPoint_ = false;
  }

  std::vector<Path> paths_;
  Path current_;
  Vec2 start_{0, 0}, at_{0, 0};
  bool isPoint_ = false;  ///< the last line has no length
  bool allGood_ = true;
};

}  // namespace

std::vector<Path> parsePathData(const std::string& data) {
  Builder builder;
  try {
    Geom::SVGPathParser(builder).parse(data);
  } catch (const std::exception&) {
    throw Error(ErrorCode::FormatDamaged, fmt::format("The path data {} cannot be understood.", parse::shown(data)));
  }
  return builder.take();
}

std::vector<Segment> arcSegment(const Vec2& from, const Vec2& to, double rx, double ry, double rotation, bool large,
                                bool sweep) {
  if (from == to) return {};
  rx = std::abs(rx);
  ry = std::abs(ry);
  // As thin as that, the ellipse is its chord; as small as that, it is scaled up anyway, but its squares would underflow.
  const double chord = (to - from).norm(), largest = std::max(rx, ry);
  if (!(std::min(rx, ry) > 1e-9 * largest)) return {Line2{from, to}};
  if (largest < 1e-3 * chord) {
    rx = rx / largest * (1e-3 * chord);
    ry = ry / largest * (1e-3 * chord);
  }
  const Vec2 along(std::cos(rotation), std::sin(rotation)), across(-along.y(), along.x());
  const Vec2 half = 0.5 * (from - to);
  // Into the frame where the ellipse is the unit circle: the centre then lies on the bisector of the chord.
  Vec2 p(along.dot(half) / rx, across.dot(half) / ry);
  if (!p.allFinite() || !(p.squaredNorm() > 0)) return {Line2{from, to}};
  const double size = p.norm();
  if (size > 1) {  // too small to reach: scaled up until it just does
    rx *= size;
    ry *= size;
    p /= size;
  }
  // Ends of a half circle are rounded to the digits of a file; the root of what is missing is a millionth of the radius.
  constexpr double rounding = 1e-12;
  const double missing = 1 / p.squaredNorm() - 1;
  const double offset = missing < rounding ? 0 : std::sqrt(missing) * (large == sweep ? -1 : 1);
  const Vec2 c = offset * Vec2(p.y(), -p.x());
  const Vec2 center = 0.5 * (from + to) + c.x() * rx * along + c.y() * ry * across;
  const double start = std::atan2(p.y() - c.y(), p.x() - c.x()), end = std::atan2(-p.y() - c.y(), -p.x() - c.x());
  double angle = std::fmod(end - start, fullTurn);
  if (sweep && angle <= 0) angle += fullTurn;
  if (!sweep && angle >= 0) angle -= fullTurn;
  if (rx == ry) return {Arc2{center, rx, start + rotation, angle}};
  return {ellipticArc(center, rx * along, ry / rx, start, angle)};
}

Segment ellipseSegment(const Vec2& center, double rx, double ry) {
  if (rx == ry) return Arc2{center, rx, 0, fullTurn};
  return ellipticArc(center, {rx, 0}, ry / rx, 0, fullTurn);
}

}  // namespace blossom::svg
