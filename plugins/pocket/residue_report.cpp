#include "residue_report.h"

#include <fmt/format.h>

namespace blossom::pocket {

void reportResidue(const SimulationResult& result, const Vec3& place, Toolpath& path, Evaluated& out) {
  for (const Vec2& at : result.residueAt)
    path.marks.push_back({Vec3(at.x() + place.x(), at.y() + place.y(), place.z()), MarkKind::Missed});
  if (!result.residue || !(*result.residue > 0) || result.residueAt.empty()) return;
  const Vec2 first = result.residueAt.front() + place.head<2>();
  out.warnings.push_back(
      fmt::format("{:.3f} mm² that the tool could reach are left{} near ({:.2f}, {:.2f}); red dots show where.",
                  *result.residue, result.residueAt.size() == 1 ? "" : ", the first", first.x(), first.y()));
}

}  // namespace blossom::pocket
