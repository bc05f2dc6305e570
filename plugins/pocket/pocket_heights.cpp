#include "pocket_heights.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/error.h"
#include "core/units.h"
#include "solid_around.h"

namespace blossom::pocket {

namespace {

constexpr double sameHeight = 1e-4;  // mm

bool isFloor(const SolidAround& around, FaceIs wanted) {
  if (wanted == FaceIs::Top) return false;
  if (wanted == FaceIs::Automatic) return around.enclosed;
  if (around.box.high.z() > sameHeight) return true;
  throw Error(ErrorCode::InvalidInput,
              "The face is asked to be the floor of a pocket, and nothing of the solid rises above it.",
              "Choose the pocket's floor, or take the face as its top.");
}

/// Where the pocket opens above its floor: where its walls end, or the solid when not all of them rise.
double openingOf(const SolidAround& around) { return around.enclosed ? around.opening : around.box.high.z(); }

Vec3 placed(const Vec3& p, const gp_Trsf& placing) {
  const gp_Pnt at = gp_Pnt(p.x(), p.y(), p.z()).Transformed(placing);
  return {at.X(), at.Y(), at.Z()};
}

}  // namespace

PocketHeights heightsOf(const Shape& shape, const SubShapeValue& face, const Part& part, const HeightsWanted& wanted,
                        std::vector<std::string>& warnings, const Progress& progress) {
  PocketHeights heights;
  heights.depth = wanted.depth;
  const Brep* brep = shape.get<Brep>();
  if (!brep || face.index < 0) return heights;
  heights.chord = std::clamp(wanted.tolerance, 0.002, 0.02);
  SolidAround around = solidAround(*brep, face.index, part.placing.Inverted(), heights.chord, progress);
  if (isFloor(around, wanted.faceIs)) {
    heights.depth = openingOf(around);
    heights.face = -heights.depth;
    if (std::abs(heights.depth - wanted.depth) > sameHeight)
      warnings.push_back(
          fmt::format("The face is the floor of a pocket {:.3f} mm deep, which is cut from its opening down to the "
                      "face; the depth of {} mm is not used.",
                      heights.depth, formatNumber(wanted.depth)));
  }
  for (auto& triangle : around.triangles)
    for (Vec3& corner : triangle) corner.z() += heights.face;
  around.box.low.z() += heights.face;
  around.box.high.z() += heights.face;
  heights.triangles = std::move(around.triangles);
  heights.box = around.box;
  heights.above = std::max(0.0, around.box.high.z());
  heights.bottom = around.box.low.z();
  if (heights.face == 0 && heights.depth > -heights.bottom + sameHeight)
    warnings.push_back(
        fmt::format("The pocket is {} mm deep and goes through the solid, which is {:.3f} mm thick below the face.",
                    formatNumber(heights.depth), -heights.bottom));
  return heights;
}

void refuseHits(const Toolpath& path, const PocketHeights& heights, const Part& part, double tolerance,
                const Progress& progress) {
  const ObstacleOptions options{.above = heights.face + 1e-3, .margin = tolerance + 2 * heights.chord};
  const auto hit = obstacleHit(path, heights.triangles, options, progress);
  if (!hit) return;
  const Vec3 at = placed(hit->tip - Vec3(0, 0, heights.face), part.placing);
  throw Error(
      ErrorCode::InvalidInput,
      fmt::format("The tool would hit the solid by {:.2f} mm near ({:.2f}, {:.2f}, {:.2f}): something of it stands over "
                  "the face there.",
                  hit->depth, at.x(), at.y(), at.z()),
      "Mill this face from a side where nothing stands over it, or leave more on the walls.");
}

}  // namespace blossom::pocket
