#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "core/error.h"
#include "kernel/ball.h"
#include "kernel/morphology.h"
#include "kernel/operations/erosion.h"
#include "kernel/operations/pair.h"

namespace blossom::morphology {

namespace {

Operand elementOf(const GrowOptions& options, double size) {
  if (!options.element) {
    Operand made;
    made.mesh = ball({size, options.subdivisions, options.fit}).mesh;
    made.name = "The ball";
    return made;
  }
  Operand made = *options.element;
  for (Vec3& p : made.mesh.points) p *= size;
  for (auto& piece : made.pieces)
    for (Vec3& p : piece) p *= size;
  return made;
}

/// A solid and what it is grown or melted by, at any size.
class Growth {
 public:
  Growth(const Operand& solid, const GrowOptions& options, double largest, const Progress& progress)
      : work_(progress), given_(solid), options_(options) {
    requireSolid(solid);
    grid_ = gridFor(solid.bounds(), elementOf(options, largest > 0 ? largest : 1).bounds());
    solid_ = work_.united(work_.prepare(solid, grid_, 0, 0.08), grid_, 0.08, 0.1);
  }

  struct Made {
    Mesh mesh;
    Vec3 moved = Vec3::Zero();  ///< of its origin from that of the solid
  };

  Made inflated(double size, double from, double to) {
    const Prepared element = elementAt(size);
    return {sumOfAny(work_, solid_, 1, element, 1, grid_, from, to), element.centre};
  }

  /// Without faces when nothing is left.
  /// @param way to the largest size, as a share: rounding would keep as much as it takes, so it ends there, late
  Made melted(double size, double way, double from, double to) {
    const double rounding = options_.rounding, back = rounding * (1 - std::pow(way, 4)),
                 most = rounding > 0 ? (from + to) / 2 : to;
    const Prepared element = elementAt((1 + rounding) * size);
    Made made{eroded(work_, solid_, element, grid_, from, most), -element.centre};
    constexpr double least = 1e-6;  // of the size
    if (made.mesh.faceCount() == 0 || !(back > least)) return made;
    const Prepared core = work_.asOperand(made.mesh, given_.name, grid_, most, most);
    const Prepared rounder = elementAt(back * size);
    return {sumOfAny(work_, core, 1, rounder, 1, grid_, most, to), made.moved + core.centre + rounder.centre};
  }

  /// The largest size at which something is left, or a little less.
  double largest() {
    constexpr double precise = 1e-3;
    const Bounds& box = solid_.bounds;
    const Bounds element = elementOf(options_, 1).bounds();
    const Vec3 room = box.high - box.low, need = (1 + options_.rounding) * (element.high - element.low);
    double above = HUGE_VAL;
    for (Eigen::Index k = 0; k < 3; ++k)
      if (need[k] > 0) above = std::min(above, room[k] / need[k]);
    if (!std::isfinite(above))
      throw Error(ErrorCode::InvalidInput, "A single point melts nothing away: there is no largest size.",
                  "Choose an element that has an extent, or give the size.");
    double below = 0;
    const double start = above;
    while (above - below > precise * above && above > precise * precise * start) {
      work_.progress().report(0.1, "Looking for the largest size");
      const double middle = (below + above) / 2;
      (melted(middle, 1, 0.1, 0.1).mesh.faceCount() > 0 ? below : above) = middle;
    }
    return work_.stats().largestSize = below;
  }

  void frames(const std::vector<double>& sizes, const std::function<Made(double size, double from, double to)>& step) {
    constexpr double most = 0.9;
    std::size_t made = 0;
    for (std::size_t k = 0; k < sizes.size(); ++k) {
      work_.startFrame(k, sizes.size());
      if (!(sizes[k] > 0)) {
        work_.finish(solid_, grid_, 0, 1);
        continue;
      }
      const Made frame = step(sizes[k], 0, most);
      if (frame.mesh.faceCount() == 0) return tellEnd(sizes, k, made);
      ++made;
      work_.finish(frame.mesh, solid_.centre + frame.moved, most, 1);
    }
  }

  MorphologyResult result() { return work_.result(); }

 private:
  [[nodiscard]] Prepared elementAt(double size) const {
    return prepared(elementOf(options_, size), grid_, work_.progress().part(0, 0));
  }

  /// A sequence of the solid alone, which was asked to melt, tells nothing.
  void tellEnd(const std::vector<double>& sizes, std::size_t frame, std::size_t made) {
    if (made == 0 && (frame == 0 || sizes.size() == 2))
      nothingLeft(given_, elementOf(options_, 1).name, "Choose a smaller radius or size.");
    work_.warn(fmt::format("Nothing is left from a {} of {:.6g}{} on; the sequence ends after {} frames.",
                           options_.element ? "size" : "radius", sizes[frame], options_.element ? "" : " mm", frame));
  }

  Work work_;
  const Operand& given_;
  const GrowOptions& options_;
  CommonGrid grid_;
  Prepared solid_;
};

double largestOf(const std::vector<double>& sizes) {
  return sizes.empty() ? 0 : *std::max_element(sizes.begin(), sizes.end());
}

}  // namespace

MorphologyResult inflated(const Operand& a, const GrowOptions& options, const Progress& progress) {
  Growth growth(a, options, largestOf(options.sizes), progress);
  growth.frames(options.sizes, [&](double size, double from, double to) { return growth.inflated(size, from, to); });
  return growth.result();
}

MorphologyResult melted(const Operand& a, const GrowOptions& options, const Progress& progress) {
  Growth growth(a, options, options.untilNothing ? 0 : (1 + options.rounding) * largestOf(options.sizes), progress);
  std::vector<double> sizes = options.sizes;
  const double largest = options.untilNothing ? growth.largest() : 0;
  if (options.untilNothing)
    for (double& size : sizes) size *= largest;
  growth.frames(sizes, [&](double size, double from, double to) {
    return growth.melted(size, largest > 0 ? size / largest : 0, from, to);
  });
  return growth.result();
}

}  // namespace blossom::morphology
