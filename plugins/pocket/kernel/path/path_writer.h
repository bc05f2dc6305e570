#pragma once
#include "geometry/shape/toolpath.h"
#include "kernel/path/pass.h"

namespace blossom::pocket {

struct PathHeights {
  double safe = 5;      ///< mm, of rapids across
  double approach = 1;  ///< mm above material, where rapids down end
};

/// Appends moves to a toolpath, each from the end of the one before.
class PathWriter {
 public:
  PathWriter(Toolpath& path, double feed, double plungeFeed, const PathHeights& heights)
      : path_(path), feed_(feed), plungeFeed_(plungeFeed), heights_(heights) {}

  [[nodiscard]] Vec2 place() const { return at_.head<2>(); }
  [[nodiscard]] double height() const { return at_.z(); }
  [[nodiscard]] bool isDown() const { return begun_ && at_.z() < heights_.safe; }

  void lift();
  /// Moves across at the safe height, rapidly down to just above `material`, and to it at the plunge feed.
  void approach(const Vec2&, double material);
  void straight(const Vec2& to, double z);
  void straight(const Vec2& to) { straight(to, at_.z()); }
  void along(const Stroke&, double z);
  void along(const Stroke& stroke) { along(stroke, at_.z()); }
  /// Follows a pass for a distance, descending linearly to `z`.
  void along(const Pass&, double from, double distance, double z);

 private:
  void add(MoveKind, const Vec3& to, double feed);

  Toolpath& path_;
  double feed_, plungeFeed_;
  PathHeights heights_;
  Vec3 at_ = Vec3::Zero();
  bool begun_ = false;
};

}  // namespace blossom::pocket
