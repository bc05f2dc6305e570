#include "geometry/planar/polygons/bounding_polyline.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <vector>

#include "geometry/planar/planar.h"
#include "geometry/planar/planar_bezier.h"

namespace blossom::planar {
namespace {

constexpr int maximumHalvings = 20;

/// The poles of a spline piece, seen from its chord.
class ChordView {
 public:
  explicit ChordView(const BezierPiece& piece) {
    for (const Vec3& pole : piece) {
      positive_ = positive_ && pole.z() > 0;
      if (poles_.empty() || poles_.back() != euclidean(pole)) poles_.push_back(euclidean(pole));
    }
    from_ = euclidean(piece.front());
    to_ = euclidean(piece.back());
    length_ = (to_ - from_).norm();
    if (length_ > 0) along_ = (to_ - from_) / length_;
    for (const Vec2& pole : poles_) {
      const Vec2 off = pole - from_;
      before_ = std::min(before_, off.dot(along_));
      beyond_ = std::max(beyond_, off.dot(along_) - length_);
      right_ = std::max(right_, off.dot(right()));
      left_ = std::max(left_, -off.dot(right()));
    }
  }

  /// Perpendicular lines meet the piece once, and it is no farther than this from its chord.
  [[nodiscard]] bool isTame(double reach) const {
    if (!positive_ || !(length_ > 0) || right_ > reach || left_ > reach) return false;
    for (std::size_t i = 1; i < poles_.size(); ++i)
      if ((poles_[i] - poles_[i - 1]).dot(along_) < 0) return false;
    return true;
  }
  [[nodiscard]] bool staysLeft() const { return right_ <= 1e-15 * length_; }
  [[nodiscard]] double reachRight() const { return right_; }

  /// Where the end tangents of a piece that bends to the left alone meet; nothing of others.
  [[nodiscard]] std::optional<Vec2> tangentsMeet() const {
    for (std::size_t i = 2; i < poles_.size(); ++i)
      if (cross(poles_[i - 1] - poles_[i - 2], Vec2(poles_[i] - poles_[i - 1])) < 0) return std::nullopt;
    const Vec2 first = poles_[1] - poles_[0], last = poles_.back() - poles_[poles_.size() - 2];
    const double turn = cross(first, last);
    if (turn <= 1e-9 * first.norm() * last.norm()) return std::nullopt;
    const Vec2 meeting = from_ + cross(to_ - from_, last) / turn * first;
    const double at = (meeting - from_).dot(along_);
    const bool over = at >= 0 && at <= length_ && (meeting - from_).dot(right()) >= right_ * (1 - 1e-12);
    return over ? std::optional(meeting) : std::nullopt;
  }

  /// The side of the poles' box that is to the right of the piece.
  [[nodiscard]] std::vector<Vec2> boxToTheRight() const {
    std::vector<Vec2> corners;
    const auto add = [&](double along, double off) { corners.emplace_back(from_ + along * along_ + off * right()); };
    if (before_ < 0) add(before_, 0);
    add(before_, right_);
    add(length_ + beyond_, right_);
    if (beyond_ > 0) add(length_ + beyond_, 0);
    return corners;
  }

 private:
  [[nodiscard]] Vec2 right() const { return {along_.y(), -along_.x()}; }

  std::vector<Vec2> poles_;  ///< those that follow one another differ
  Vec2 from_, to_, along_{1, 0};
  bool positive_ = true;  ///< all weights
  double length_ = 0, before_ = 0, beyond_ = 0, right_ = 0, left_ = 0;
};

/// The corners after the first point of a path, segment by segment.
class Walk {
 public:
  Walk(double tolerance, const Progress& progress) : tolerance_(tolerance), progress_(progress) {}

  void add(const Segment& segment) {
    goTo(startPoint(segment));
    std::visit([&](const auto& each) { addCorners(each); }, segment);
    goTo(endPoint(segment));
    afterTangents_ = false;
  }

  Loop closed() && {
    while (corners_.size() > 1 && corners_.front() == corners_.back()) corners_.pop_back();
    return std::move(corners_);
  }

 private:
  void goTo(const Vec2& p) {
    if (corners_.empty() || corners_.back() != p) corners_.push_back(p);
  }

  void addCorners(const Line2&) {}

  void addCorners(const Arc2& arc) {
    if (arc.sweep <= 0) {
      for (const Vec2& p : flatten(Segment(arc), tolerance_)) goTo(p);
      return;
    }
    // Tangents a step apart meet at r / cos(step / 2), at most a quarter of a turn apart.
    const double excess = tolerance_ / std::abs(arc.radius);
    const double most = std::min(4 * std::asin(std::sqrt(excess / (2 * (1 + excess)))), std::numbers::pi / 2);
    const double count = std::max(1.0, std::ceil(arc.sweep / most - 1e-9));
    const double step = arc.sweep / count, reach = arc.radius / std::cos(step / 2);
    for (double k = 0.5; k < count; k += 1) {
      progress_.check();
      const double angle = arc.start + k * step;
      goTo(arc.center + reach * Vec2(std::cos(angle), std::sin(angle)));
    }
  }

  void addCorners(const Spline2& spline) {
    for (const BezierPiece& piece : bezierPieces(spline)) addPiece(piece, maximumHalvings);
  }

  void addPiece(const BezierPiece& piece, int depth) {
    progress_.check();
    const ChordView view(piece);
    const Vec2 end = euclidean(piece.back());
    if (!view.isTame(tolerance_ / 2)) {
      if (depth > 0) {
        const auto [first, second] = halves(piece);
        addPiece(first, depth - 1);
        addPiece(second, depth - 1);
        return;
      }
      addBox(view);
    } else if (view.staysLeft()) {
      afterTangents_ = false;
    } else if (const auto meeting = view.tangentsMeet(); meeting && within(*meeting, piece)) {
      addTangents(*meeting);
    } else {
      addBox(view);
    }
    goTo(end);
  }

  [[nodiscard]] bool within(const Vec2& meeting, const BezierPiece& piece) const {
    const Vec2 from = euclidean(piece.front()), along = euclidean(piece.back()) - from;
    return cross(meeting - from, along) <= tolerance_ * along.norm();
  }

  /// The point between two pieces goes where their tangents are one line.
  void addTangents(const Vec2& meeting) {
    if (afterTangents_ && corners_.size() >= 2) {
      const Vec2 in = corners_.back() - corners_[corners_.size() - 2], out = meeting - corners_.back();
      if (std::abs(cross(in, out)) <= 1e-13 * in.norm() * out.norm() && in.dot(out) > 0) corners_.pop_back();
    }
    goTo(meeting);
    afterTangents_ = true;
  }

  void addBox(const ChordView& view) {
    for (const Vec2& p : view.boxToTheRight()) goTo(p);
    afterTangents_ = false;
  }

  double tolerance_;
  const Progress& progress_;
  Loop corners_;
  bool afterTangents_ = false;
};

}  // namespace

Loop polylineToTheRight(const Path& path, double tolerance, const Progress& progress) {
  Walk walk(tolerance, progress);
  for (const Segment& segment : path.segments) walk.add(segment);
  return std::move(walk).closed();
}

Loop polylineToTheLeft(const Path& path, double tolerance, const Progress& progress) {
  Loop loop = polylineToTheRight(blossom::reversed(path), tolerance, progress);
  std::reverse(loop.begin(), loop.end());
  return loop;
}

}  // namespace blossom::planar
