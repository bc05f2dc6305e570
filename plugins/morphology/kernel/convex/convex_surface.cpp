#include "kernel/convex/convex_surface.h"

#include <algorithm>
#include <array>
#include <optional>
#include <vector>

#include "kernel/convex/hull.h"

namespace blossom::morphology {

namespace {

using Corners = std::array<int, 3>;

std::vector<Corners> cornersOfFaces(const Mesh& mesh) {
  std::vector<Corners> faces;
  faces.reserve(mesh.faceCount());
  for (std::size_t f = 0; f < mesh.faceCount(); ++f) {
    const auto face = mesh.face(f);
    faces.push_back({face[0], face[1], face[2]});
  }
  return faces;
}

/// A side of a face, from one of its corners to the next.
struct Side {
  int to, opposite;  ///< the corner across
};

/// The sides that begin at each corner, by where they end.
class Sides {
 public:
  Sides(std::size_t points, const std::vector<Corners>& faces) : firsts_(points + 1, 0), sides_(3 * faces.size()) {
    for (const Corners& face : faces)
      for (const int from : face) ++firsts_[static_cast<std::size_t>(from) + 1];
    for (std::size_t i = 0; i < points; ++i) firsts_[i + 1] += firsts_[i];
    std::vector<std::size_t> next(firsts_.begin(), firsts_.end() - 1);
    for (const Corners& face : faces)
      for (std::size_t k = 0; k < 3; ++k)
        sides_[next[static_cast<std::size_t>(face[k])]++] = {face[(k + 1) % 3], face[(k + 2) % 3]};
    for (std::size_t i = 0; i < points; ++i) std::sort(begin(i), begin(i + 1), isBefore);
  }

  /// Whether some side is there twice.
  [[nodiscard]] bool repeat() {
    const auto equal = [](const Side& a, const Side& b) { return a.to == b.to; };
    for (std::size_t i = 0; i + 1 < firsts_.size(); ++i)
      if (std::adjacent_find(begin(i), begin(i + 1), equal) != begin(i + 1)) return true;
    return false;
  }

  /// The corner across the side `from to`; nothing where there is no such side.
  [[nodiscard]] std::optional<int> across(int from, int to) {
    const auto at = static_cast<std::size_t>(from);
    const auto found = std::lower_bound(begin(at), begin(at + 1), Side{to, 0}, isBefore);
    if (found == begin(at + 1) || found->to != to) return std::nullopt;
    return found->opposite;
  }

 private:
  static bool isBefore(const Side& a, const Side& b) { return a.to < b.to; }
  std::vector<Side>::iterator begin(std::size_t point) {
    return sides_.begin() + static_cast<std::ptrdiff_t>(firsts_[point]);
  }

  std::vector<std::size_t> firsts_;
  std::vector<Side> sides_;
};

class ConvexCheck {
 public:
  explicit ConvexCheck(const Mesh& mesh) : points_(mesh.points), faces_(cornersOfFaces(mesh)) {
    for (const Vec3& p : points_) middle_ += p;
    middle_ /= static_cast<double>(points_.size());
  }

  [[nodiscard]] bool passes() const { return isBehindAll() && hasConvexEdges() && isCoveredOnce(); }

 private:
  [[nodiscard]] const Vec3& at(int corner) const { return points_[static_cast<std::size_t>(corner)]; }

  /// Whether the middle lies strictly behind every face.
  [[nodiscard]] bool isBehindAll() const {
    return std::all_of(faces_.begin(), faces_.end(), [&](const Corners& f) { return sideOf(f, middle_) < 0; });
  }
  [[nodiscard]] int sideOf(const Corners& f, const Vec3& p) const { return sideOfPlane(at(f[0]), at(f[1]), at(f[2]), p); }

  /// Closed, with no reflex edge and three edges at least at each corner that are not flat.
  [[nodiscard]] bool hasConvexEdges() const {
    Sides sides(points_.size(), faces_);
    if (sides.repeat()) return false;
    std::vector<int> sharp(points_.size(), 0);
    for (const Corners& f : faces_)
      for (std::size_t k = 0; k < 3; ++k) {
        const int from = f[k], to = f[(k + 1) % 3];
        const std::optional<int> beyond = sides.across(to, from);
        if (!beyond) return false;
        const int side = sideOf(f, at(*beyond));
        if (side > 0) return false;
        if (side < 0) ++sharp[static_cast<std::size_t>(from)];
      }
    return std::all_of(sharp.begin(), sharp.end(), [](int edges) { return edges >= 3; });
  }

  /// Whether a ray from the middle through the inside of some face meets no other one.
  [[nodiscard]] bool isCoveredOnce() const {
    for (const Corners& met : faces_) {
      const Vec3 through = (at(met[0]) + at(met[1]) + at(met[2])) / 3;
      if (!isMet(through, met, 1)) continue;  // rounding has moved it out of a sliver
      const auto touches = [&](const Corners& f) { return isMet(through, f, 0); };
      return std::count_if(faces_.begin(), faces_.end(), touches) == 1;
    }
    return false;
  }
  /// Whether the ray passes the face on the inner side of all its edges. @param least 0: or through an edge or a corner
  [[nodiscard]] bool isMet(const Vec3& through, const Corners& f, int least) const {
    for (std::size_t k = 0; k < 3; ++k)
      if (sideOfPlane(middle_, through, at(f[k]), at(f[(k + 1) % 3])) < least) return false;
    return true;
  }

  const std::vector<Vec3>& points_;
  std::vector<Corners> faces_;
  Vec3 middle_ = Vec3::Zero();
};

}  // namespace

bool isConvexSurface(const Mesh& mesh) {
  const std::size_t count = mesh.faceCount();
  if (count < 4 || mesh.faceVertices.size() != 3 * count || count + 4 != 2 * mesh.points.size()) return false;
  return ConvexCheck(mesh).passes();
}

}  // namespace blossom::morphology
