#pragma once
#include <cstdint>
#include <functional>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include "geometry/crossing/sheet_mesh.h"
#include "geometry/crossing/smooth_sheets.h"

namespace blossom {

/// Whether a side is to be halved: its ends, and the point of the smooth face at the mean of their parameters.
using SideJudge = std::function<bool(const Vec3& from, const Vec3& to, const Vec3& middle)>;

/// What rounds of division over the same points and sheets, by the same judge, know from earlier ones: nearly all of their
/// time goes into the smooth faces.
class DivisionMemory {
 public:
  /// Of a side, its corners.
  using Key = std::uint64_t;

  /// @returns the frame of the sheets, evaluated at most once
  const SurfaceFrame& frame(const SmoothSheets&, int face, const Vec2& at);
  void setShort(Key side) { short_.insert(side); }
  [[nodiscard]] bool isShort(Key side) const { return short_.contains(side); }

 private:
  struct Place {
    int face;
    double u, v;
    friend bool operator==(const Place&, const Place&) = default;
  };
  struct HashOfPlace {
    std::size_t operator()(const Place&) const;
  };
  std::unordered_map<Place, SurfaceFrame, HashOfPlace> frames_;
  std::unordered_set<Key> short_;  ///< sides that are not too long
};

/// Halves once the sides of triangles that are judged too long, on the smooth face; a side that two triangles share is
/// halved for both. @returns whether there was any. About O(n).
bool divideOnce(std::vector<Vec3>& points, std::vector<SheetTriangle>& triangles, const SmoothSheets&, const SideJudge&,
                DivisionMemory&);

}  // namespace blossom
