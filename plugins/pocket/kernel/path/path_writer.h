#pragma once
#include "geometry/shape/toolpath.h"
#include "kernel/path/pass.h"

namespace blossom::pocket {

struct PathHeights {
  double safe = 5;      ///< mm, of rapids across
  double approach = 1;  ///< mm above material, where rapids down end
};

/// Adds moves to a toolpath, each from where the last one ended.
class PathWriter {
 public:
  PathWriter(Toolpath& path, double feed, double plungeFeed, const PathHeights& heights)
      : path_(path), feed_(feed), plungeFeed_(plungeFeed), heights_(heights) {}

  [[nodiscard]] Vec2 place() const { return at_.head<2>(); }
  [[nodiscard]] double height() const { return at_.z(); }
  [[nodiscard]] bool isDown() const { return begun_ && at_.z() < heights_.safe; }

  void lift();
  /// Across at the safe height, quickly down to just above `material`, and slowly to it.
  void approach(const Vec2&, double material);
  void straight(const Vec2& to, double z);
  void straight(const Vec2& to) { straight(to, at_.z()); }
  void along(const Stroke&, double z);
  void along(const Stroke& stroke) { along(stroke, at_.z()); }
  /// A way along a pass, falling evenly to `z`.
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
