#include "kernel/setup/collision.h"

#include <algorithm>
#include <optional>

#include "core/error.h"
#include "core/parallel.h"
#include "kernel/setup/stage_distance.h"

namespace blossom::pocket {

namespace {

Box3 boxOf(const std::array<Vec3, 3>& triangle) {
  Box3 box;
  for (const Vec3& corner : triangle) box.extend(corner);
  return box;
}

/// Along a straight way, the convex function of the distance between a stage and a triangle.
class Approach {
 public:
  Approach(const ToolStage& stage, const std::array<Vec3, 3>& triangle, const Vec3& from, const Vec3& to, double resolution)
      : stage_(stage), triangle_(triangle), from_(from), along_(to - from), resolution_(resolution) {}

  /// The share of the way at the first contact.
  [[nodiscard]] std::optional<double> firstContact() const {
    const double begin = at(0);
    return begin == 0 ? std::optional(0.0) : between(0, begin, 1, at(1));
  }

 private:
  /// 0 where they touch.
  [[nodiscard]] double at(double share) const {
    const Vec3 tip = from_ + share * along_;
    const double distance = distanceTo(stage_, {triangle_[0] - tip, triangle_[1] - tip, triangle_[2] - tip});
    return distance > touching ? distance : 0;
  }

  /// The function is above 0 at `a`.
  [[nodiscard]] std::optional<double> between(double a, double ofA, double b, double ofB) const {
    const double length = (b - a) * along_.norm();
    if (ofB > 0 && ofA + ofB > length) return {};  // no distance falls faster than the way is long
    if (length <= resolution_) return ofB > 0 ? std::nullopt : std::optional(b);
    const double m = (a + b) / 2;
    const double ofM = at(m);
    if (ofM == 0) return between(a, ofA, m, ofM);
    if (ofB == 0) return between(m, ofM, b, ofB);
    // A convex function lies above its chords continued.
    const bool isClearBefore = std::min(ofM, 2 * ofM - ofB) > 0;
    const bool isClearAfter = std::min(ofM, 2 * ofM - ofA) > 0;
    if (!isClearBefore)
      if (const auto contact = between(a, ofA, m, ofM)) return contact;
    return isClearAfter ? std::nullopt : between(m, ofM, b, ofB);
  }

  /// mm, above the error of a distance: where a way runs along a surface nothing is gained by looking closer.
  static constexpr double touching = 1e-6;
  const ToolStage& stage_;
  const std::array<Vec3, 3>& triangle_;
  Vec3 from_, along_;
  double resolution_;
};

class Sweeping {
 public:
  Sweeping(const Toolpath& path, const ToolAssembly& tool, const Obstacles& obstacles, double allowed)
      : path_(path), obstacles_(obstacles), allowed_(allowed), stages_(stagesOf(tool, allowed)) {}

  std::vector<Collision> run(const Progress& progress) {
    constexpr std::size_t movesAtOnce = 16;
    std::vector<std::vector<Collision>> found(path_.moves.size());
    parallelFor(found.size(), movesAtOnce, progress, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) found[i] = during(i);
    });
    std::vector<Collision> all;
    for (const auto& each : found) all.insert(all.end(), each.begin(), each.end());
    return all;
  }

 private:
  /// Of each part of the tool the first contact of its stages.
  [[nodiscard]] std::vector<Collision> during(std::size_t move) const {
    const std::vector<Vec3> way = polylineOf(startOf(path_, move), path_.moves[move], allowed_ / 4);
    std::vector<Collision> found;
    for (const ToolPart part : {ToolPart::Flutes, ToolPart::Shank, ToolPart::Holder}) {
      std::optional<Collision> hit;
      for (std::size_t k = 1; k < way.size() && !hit; ++k) hit = firstHit(part, way[k - 1], way[k]);
      if (!hit) continue;
      hit->move = move;
      found.push_back(*hit);
    }
    return found;
  }

  [[nodiscard]] std::optional<Collision> firstHit(ToolPart part, const Vec3& from, const Vec3& to) const {
    std::optional<Collision> first;
    double share = 2;
    for (const ToolStage& stage : stages_)
      if (stage.part == part) lookFor(stage, from, to, share, first);
    return first;
  }

  /// @param share of the way at the first contact so far, lowered
  void lookFor(const ToolStage& stage, const Vec3& from, const Vec3& to, double& share,
               std::optional<Collision>& first) const {
    Box3 swept(Vec3(-stage.reach(), -stage.reach(), stage.low()), Vec3(stage.reach(), stage.reach(), stage.high()));
    swept = Box3(swept.min() + from.cwiseMin(to), swept.max() + from.cwiseMax(to));
    obstacles_.tree().meeting(swept, [&](std::size_t item) {
      const auto& triangle = obstacles_.triangles()[item];
      if (!boxOf(triangle).intersects(swept)) return;
      const auto contact = Approach(stage, triangle, from, to, allowed_ / 4).firstContact();
      if (!contact || *contact >= share) return;
      share = *contact;
      first = Collision{0, stage.part, from + share * (to - from), item};
    });
  }

  const Toolpath& path_;
  const Obstacles& obstacles_;
  double allowed_;
  std::vector<ToolStage> stages_;
};

}  // namespace

Obstacles::Obstacles(Triangles triangles, const Progress& progress) : triangles_(std::move(triangles)) {
  std::vector<Box3> boxes;
  boxes.reserve(triangles_.size());
  for (const auto& triangle : triangles_) boxes.push_back(boxOf(triangle));
  tree_ = BoxTree<3>(boxes, 4, progress);
}

std::vector<Collision> collisionsOf(const Toolpath& path, const ToolAssembly& tool, const Obstacles& obstacles,
                                    const CollisionOptions& options, const Progress& progress) {
  if (!(options.allowed > 0))
    throw Error(ErrorCode::InvalidParameter, "How deep a tool may enter must be above 0.", "Give the output's resolution.");
  if (options.allowed >= tool.cutter.diameter / 2)
    throw Error(ErrorCode::InvalidParameter, "The tolerance is larger than the cutter: nothing would be a collision.",
                "Give a smaller tolerance.");
  return Sweeping(path, tool, obstacles, options.allowed).run(progress);
}

}  // namespace blossom::pocket
