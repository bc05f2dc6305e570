#include "kernel/arrangement/tight_faces.h"

#include <algorithm>
#include <set>
#include <utility>

#include "geometry/numeric/union_find.h"

namespace blossom::morphology::arrangement {

namespace {

constexpr std::size_t mostEdges = 8;  ///< of a face that is tested

using Ends = std::pair<Grid3, Grid3>;

Ends endsOf(const Features& shape, const Features::Edge& edge) {
  const Grid3 &p = shape.points[static_cast<std::size_t>(edge.from)], &q = shape.points[static_cast<std::size_t>(edge.to)];
  return p < q ? Ends{p, q} : Ends{q, p};
}

/// The largest difference of the values that are added, of which 0 is one.
struct Extent {
  Int128 low = 0, high = 0;

  void add(Int128 value) {
    low = std::min(low, value);
    high = std::max(high, value);
  }
  [[nodiscard]] Int128 width() const { return high - low; }
};

/// Widths in a plane, across one of its directions, in the drawing without the axis along which its normal is largest.
class Across {
 public:
  Across(const Bounded3& normal, const Grid3& along) : along_(along) {
    for (std::size_t k = 1; k < 3; ++k)
      if (std::abs(normal[k].value) > std::abs(normal[axis_].value)) axis_ = k;
  }
  [[nodiscard]] Int128 operator()(const Grid3& d) const {
    const std::size_t u = (axis_ + 1) % 3, v = (axis_ + 2) % 3;
    return Int128(along_[u]) * d[v] - Int128(along_[v]) * d[u];
  }

 private:
  Grid3 along_;
  std::size_t axis_ = 0;
};

/// Triangles of a solid in one plane that have edges in common.
struct FlatFace {
  std::vector<Ends> border;
  bool isIsland = true;  ///< around it the solid falls off everywhere
};

class FlatFaces {
 public:
  explicit FlatFaces(const Features& complement) : faces_(complement.faces.size()), groups_(complement.faces.size()) {
    std::set<Ends> seen, shared;  // edges where the solid touches itself are there twice
    for (const Features::Edge& edge : complement.edges) {
      const Ends ends = endsOf(complement, edge);
      if (!seen.insert(ends).second) shared.insert(ends);
      if (!edge.isConvex && !isReflex(complement, edge))
        groups_.unite(static_cast<std::size_t>(edge.left), static_cast<std::size_t>(edge.right));
    }
    for (const Features::Edge& edge : complement.edges) {
      const bool fallsOff = isReflex(complement, edge);
      if (!edge.isConvex && !fallsOff) continue;
      const Ends ends = endsOf(complement, edge);
      for (const int face : {edge.left, edge.right}) {
        FlatFace& flat = faces_[groups_.find(static_cast<std::size_t>(face))];
        flat.isIsland = flat.isIsland && fallsOff && flat.border.size() < mostEdges && !shared.contains(ends);
        if (flat.isIsland) flat.border.push_back(ends);
      }
    }
  }

  [[nodiscard]] const FlatFace& of(int face) { return faces_[groups_.find(static_cast<std::size_t>(face))]; }

 private:
  std::vector<FlatFace> faces_;
  UnionFind groups_;
};

/// @param slides directions in the plane of the face
bool isTight(const FlatFace& flat, const Bounded3& normal, const std::vector<Grid3>& slides) {
  return std::any_of(flat.border.begin(), flat.border.end(), [&](const Ends& edge) {
    const Across across(normal, edge.second - edge.first);
    Extent face, element;
    for (const auto& [p, q] : flat.border)
      for (const Grid3& end : {p, q}) face.add(across(end - edge.first));
    for (const Grid3& d : slides) element.add(across(d));
    return element.width() >= face.width();
  });
}

}  // namespace

void leaveOutTightFaces(FeaturePairs& pairs, const Features& complement, const Features& element) {
  FlatFaces flatFaces(complement);
  const auto makesNothing = [&](const FeaturePairs::Pair& pair) {
    const Features::Face& face = complement.faces[static_cast<std::size_t>(pair[0])];
    const FlatFace& flat = flatFaces.of(pair[0]);
    if (!flat.isIsland) return false;
    std::vector<Grid3> slides;
    for (const Grid3& d : element.corners[static_cast<std::size_t>(pair[1])].around)
      if (slope(face.normal, face.about, d) == 0) slides.push_back(d);
    return !slides.empty() && isTight(flat, face.about, slides);
  };
  std::erase_if(pairs.facesAndCorners, makesNothing);
}

}  // namespace blossom::morphology::arrangement
