#pragma once
#include <array>
#include <cstddef>
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

/// A triangle, or a strip of two between halves of long sides: four corners in order. The diagonal of a strip runs from its
/// first corner to the third.
struct SheetPatch {
  std::array<int, 4> corners{};
  std::array<Vec2, 4> at;  ///< parameters of the corners on the face
  int face = 0;
  std::size_t count = 3;  ///< of its corners

  [[nodiscard]] std::vector<SheetTriangle> triangles() const;
};

/// Triangles whose sides are halved on the smooth faces, round by round, until none is judged too long. What lies between
/// two halves of long sides stays a strip that is halved across: as triangles, which would be halved along their diagonals
/// as well, three would take the place of each where two are enough, in every round.
class TriangleDivision {
 public:
  /// Whether a triangle matters.
  using Wanted = std::function<bool(const std::array<Vec3, 3>&)>;

  /// Middles are appended to `points`, which must outlive this.
  /// @param fine mm: sides up to that length are left as they are without a look at the faces, which takes most of the time
  TriangleDivision(std::vector<Vec3>& points, const std::vector<SheetTriangle>&, const SmoothSheets&, SideJudge,
                   double fine = 0);

  /// One round over what is wanted and not finished; the rest of it is dropped. @returns whether there was any to divide.
  /// About O(n) for n unfinished ones.
  bool divideOnce(const Wanted&);
  [[nodiscard]] std::size_t count() const { return open_.size() + finished_.size(); }
  [[nodiscard]] std::vector<SheetTriangle> triangles(const Wanted&) const;

 private:
  [[nodiscard]] bool isWanted(const SheetPatch&, const Wanted&) const;

  std::vector<Vec3>& points_;
  const SmoothSheets& sheets_;
  SideJudge tooLong_;
  double fine_;
  DivisionMemory memory_;
  std::vector<SheetPatch> open_, finished_;
};

/// Halves once the sides of triangles that are judged too long, on the smooth face; a side that two triangles share is
/// halved for both. @returns whether there was any. About O(n).
bool divideOnce(std::vector<Vec3>& points, std::vector<SheetTriangle>& triangles, const SmoothSheets&, const SideJudge&,
                DivisionMemory&);

}  // namespace blossom
