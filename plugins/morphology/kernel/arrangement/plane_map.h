#pragma once
#include <algorithm>
#include <array>
#include <unordered_map>
#include <vector>

#include "kernel/arrangement/candidates.h"
#include "kernel/arrangement/points.h"

namespace blossom::morphology::arrangement {

/// How many facets of one plane cover a place: those that face where its normal points to, and the others.
struct Cover {
  int sameWay = 0, otherWay = 0;
  friend bool operator==(const Cover&, const Cover&) = default;
};

/// One plane, divided by segments: a triangulation of exact points in which segments are unions of edges. Where two segments
/// cross, the plane and those they lie in meet in a new point.
class PlaneMap {
 public:
  /// Of a single facet, or of a triangle around several.
  PlaneMap(int plane, const std::vector<const Facet*>&, Planes&, Points&);

  /// A segment in which the plane meets another one, or a single point. @pre both ends lie in the facets
  void cut(int from, int to, int otherPlane);

  /// A triangle, counter-clockwise in the drawing of the plane.
  struct Piece {
    std::array<int, 3> corners{};
    std::array<bool, 3> isCut{};  ///< whether the edge from corner k on is part of a segment, or bounds a facet
    int patch = 0;                ///< pieces between the same segments have the same
  };
  /// Pieces with their patches, of which each has one cover.
  struct Divided {
    std::vector<Piece> pieces;
    std::vector<Cover> covers;  ///< by patch
  };
  [[nodiscard]] Divided divided() const;

 private:
  static constexpr int none = -1;
  struct Side {
    int beyond = none;  ///< the triangle on the other side of the edge
    int line = none;    ///< a plane that meets this one in the edge, if that is part of a segment
    Cover gain;         ///< facets that cover this triangle but not the one beyond
  };
  struct Triangle {
    std::array<int, 3> corners{};
    std::array<Side, 3> sides;  ///< of the edge from corner k to the next
  };
  struct EdgeOf {
    int triangle = none;
    std::size_t side = 0;
  };
  /// A segment on its way from one point to another.
  struct Segment {
    int from = 0, to = 0, line = 0;
    int way = 0;  ///< the sign of the way along the axis of the line in which both planes meet
    std::size_t axis = 0;
    int left = 1;  ///< the side of the plane `line` that is left of the segment
    Cover gain;    ///< of what is left of it
  };

  [[nodiscard]] Triangle& at(int triangle) { return triangles_[static_cast<std::size_t>(triangle)]; }
  [[nodiscard]] const Triangle& at(int triangle) const { return triangles_[static_cast<std::size_t>(triangle)]; }
  int turn(int a, int b, int c) { return points_.turn(plane_, a, b, c); }
  [[nodiscard]] bool isFrame(int point) const { return std::find(frame_.begin(), frame_.end(), point) != frame_.end(); }

  void startWith(const Facet&);
  void startAround(const std::vector<const Facet*>&);
  void insert(int point);
  void divideTriangle(int triangle, int point);
  void divideEdge(EdgeOf, int point);
  void flip(EdgeOf);
  void replaceBeyond(int triangle, int before, int after);
  void remember(int triangle);
  [[nodiscard]] std::vector<EdgeOf> edgesFrom(int point) const;
  [[nodiscard]] EdgeOf edge(int from, int to) const;

  void add(const Segment&);
  [[nodiscard]] Segment segment(int from, int to, int line, Cover gain);
  [[nodiscard]] int sideOf(const Segment&, int point);
  [[nodiscard]] bool isAhead(const Segment&, int here, int point);
  int advanced(const Segment&, int here);
  int wayThrough(const Segment&, int here, EdgeOf first);
  void clear(const Segment&, int here, int target, std::vector<std::array<int, 2>> crossed);
  void mark(const Segment&, int here, int next);

  int plane_;
  Planes& planes_;
  Points& points_;
  std::vector<Triangle> triangles_;
  std::unordered_map<int, int> triangleAt_;     ///< of each point, one of its triangles
  std::array<int, 3> frame_{none, none, none};  ///< points around all facets, where there are several
  Cover first_;                                 ///< of the first triangle
  int last_ = 0;                                ///< where a search begins
  std::uint32_t random_ = 1;
};

}  // namespace blossom::morphology::arrangement
