#include "kernel/solid/solid_mesh.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "geometry/mesh/mesh_topology.h"
#include "geometry/numeric/point_merge.h"
#include "geometry/planar/area_triangulation.h"
#include "kernel/solid/face_rings.h"

namespace blossom::minkowski {
namespace {

std::size_t indexOf(int index) { return static_cast<std::size_t>(index); }

/// Space without the coordinate in which a plane is steepest, turned so that `normal` looks at the reader.
class Flat {
 public:
  explicit Flat(const Vec3& normal) {
    Eigen::Index steep = 0;
    normal.cwiseAbs().maxCoeff(&steep);
    x_ = (steep + 1) % 3;
    y_ = (steep + 2) % 3;
    if (normal[steep] < 0) std::swap(x_, y_);
  }
  [[nodiscard]] Vec2 operator()(const Vec3& p) const { return {p[x_], p[y_]}; }

 private:
  Eigen::Index x_ = 0, y_ = 1;
};

bool insideLoop(const Vec2& p, const Loop& loop) {
  bool inside = false;
  for (std::size_t k = 0; k < loop.size(); ++k) {
    const Vec2 &a = loop[k], &b = loop[(k + 1) % loop.size()];
    if ((a.y() > p.y()) != (b.y() > p.y()) && (cross(Vec2(b - a), Vec2(p - a)) > 0) == (b.y() > a.y())) inside = !inside;
  }
  return inside;
}

/// Adds the faces that the rings of one plane bound.
class FaceMaker {
 public:
  FaceMaker(Mesh& mesh, const Progress& progress) : mesh_(mesh), progress_(progress) {}

  void add(const RingsOfFace& face) {
    const Flat flat(face.normal);
    std::vector<Part> parts;
    std::vector<const CornerRing*> holes;
    for (const CornerRing& ring : face.rings) {
      if (ring.size() < 3) continue;
      const Loop loop = loopOf(ring, flat);
      if (signedArea(loop) > 0)
        parts.push_back({&ring, loop, {}});
      else
        holes.push_back(&ring);
    }
    for (const CornerRing* hole : holes) {
      Part* around = partAround(parts, (flat(point(hole->at(0))) + flat(point(hole->at(1)))) / 2);
      if (around)
        around->holes.push_back(hole);
      else
        mesh_.addFace(*hole);  // a sliver that rounding has turned over
    }
    for (const Part& part : parts)
      if (part.holes.empty() || !addTriangles(part, flat)) addBridged(part);
  }

 private:
  struct Part {
    const CornerRing* outer;
    Loop loop;
    std::vector<const CornerRing*> holes;
  };

  [[nodiscard]] const Vec3& point(int v) const { return mesh_.points[indexOf(v)]; }
  [[nodiscard]] Loop loopOf(const CornerRing& ring, const Flat& flat) const {
    Loop loop;
    for (const int v : ring) loop.push_back(flat(point(v)));
    return loop;
  }
  static Part* partAround(std::vector<Part>& parts, const Vec2& place) {
    Part* smallest = nullptr;
    for (Part& part : parts)
      if (insideLoop(place, part.loop) && (!smallest || signedArea(part.loop) < signedArea(smallest->loop)))
        smallest = &part;
    return smallest;
  }
  bool addTriangles(const Part& part, const Flat& flat) {
    std::vector<Loop> loops{part.loop};
    std::map<std::pair<double, double>, int> corners;
    const auto number = [&](const CornerRing& ring) {
      for (const int v : ring) corners[{flat(point(v)).x(), flat(point(v)).y()}] = v;
    };
    number(*part.outer);
    for (const CornerRing* hole : part.holes) {
      loops.push_back(loopOf(*hole, flat));
      number(*hole);
    }
    const AreaTriangles area = triangulateArea(loops, progress_);
    std::vector<std::array<int, 3>> triangles;
    for (const auto& triangle : area.triangles) {
      auto& made = triangles.emplace_back();
      for (std::size_t k = 0; k < 3; ++k) {
        const Vec2& p = area.points[indexOf(triangle[k])];
        const auto found = corners.find({p.x(), p.y()});
        if (found == corners.end()) return false;
        made[k] = found->second;
      }
    }
    for (const auto& triangle : triangles) mesh_.addFace(triangle);
    return true;
  }
  /// One polygon that runs to each hole and back.
  void addBridged(const Part& part) {
    CornerRing ring = *part.outer;
    for (const CornerRing* hole : part.holes) {
      std::size_t from = 0, to = 0;
      double least = HUGE_VAL;
      for (std::size_t a = 0; a < ring.size(); ++a)
        for (std::size_t b = 0; b < hole->size(); ++b)
          if (const double d = (point(ring[a]) - point((*hole)[b])).squaredNorm(); d < least) {
            least = d;
            from = a;
            to = b;
          }
      CornerRing round(hole->begin() + static_cast<std::ptrdiff_t>(to), hole->end());
      round.insert(round.end(), hole->begin(), hole->begin() + static_cast<std::ptrdiff_t>(to) + 1);
      round.push_back(ring[from]);
      ring.insert(ring.begin() + static_cast<std::ptrdiff_t>(from) + 1, round.begin(), round.end());
    }
    mesh_.addFace(ring);
  }

  Mesh& mesh_;
  const Progress& progress_;
};

/// Without corners that no face has.
Mesh compacted(const Mesh& mesh) {
  Mesh result;
  std::vector<int> numbers(mesh.points.size(), -1);
  result.faceStarts = mesh.faceStarts;
  for (const int v : mesh.faceVertices) {
    if (numbers[indexOf(v)] < 0) {
      numbers[indexOf(v)] = static_cast<int>(result.points.size());
      result.points.push_back(mesh.points[indexOf(v)]);
    }
    result.faceVertices.push_back(numbers[indexOf(v)]);
  }
  return result;
}

}  // namespace

Vec3 LoftPlacement::point(const LoftPredicates::Place& place) const {
  const double t = std::ldexp(static_cast<double>(place[2]), -60);
  const Vec2 p =
      bottom.unit * Vec2(std::ldexp(static_cast<double>(place[0]), -12), std::ldexp(static_cast<double>(place[1]), -12));
  const Vec2 origin = t == 0 ? bottom.origin : t == 1 ? top.origin : Vec2((1 - t) * bottom.origin + t * top.origin);
  return {origin.x() + p.x(), origin.y() + p.y(), t * height};
}

Mesh meshOfSides(std::span<const LoftSide> sides, const LoftPlacement& placement, double tolerance,
                 const Progress& progress) {
  Mesh mesh;
  std::map<LoftPredicates::Place, int> corners;
  std::map<std::pair<int, bool>, int> faces;
  const auto corner = [&](const LoftPredicates::Place& place) {
    const auto [found, isNew] = corners.try_emplace(place, static_cast<int>(mesh.points.size()));
    if (isNew) mesh.points.push_back(placement.point(place));
    return found->second;
  };
  std::vector<FaceSide> ofFaces;
  for (const LoftSide& side : sides) {
    const int face = faces.try_emplace({side.plane, side.outsideLeft}, static_cast<int>(faces.size())).first->second;
    const int from = corner(side.from), to = corner(side.to);
    ofFaces.push_back({face, from, to});
  }
  const std::vector<int> first = mergeClosePoints(mesh.points, tolerance);
  for (FaceSide& side : ofFaces) side = {side.face, first[indexOf(side.from)], first[indexOf(side.to)]};
  ofFaces = withoutPairs(std::move(ofFaces));
  joinFlat(ofFaces, mesh.points, tolerance, progress);
  std::vector<RingsOfFace> rings = ringsOf(ofFaces, mesh.points, progress);
  dropStraightCorners(rings, mesh.points, tolerance);
  dropBackToBack(rings);
  dropStraightCorners(rings, mesh.points, tolerance);  // those that kept slivers from being left out
  FaceMaker maker(mesh, progress);
  for (const RingsOfFace& face : rings) {
    progress.check();
    maker.add(face);
  }
  return compacted(mesh);
}

}  // namespace blossom::minkowski
