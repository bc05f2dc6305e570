#include "kernel/separated.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <map>
#include <utility>
#include <vector>

#include "geometry/numeric/box_tree.h"
#include "geometry/numeric/point_merge.h"

namespace blossom::morphology {

namespace {

using Corners = std::array<int, 3>;
using EdgeKey = std::array<int, 2>;

EdgeKey keyOf(int a, int b) { return {std::min(a, b), std::max(a, b)}; }

/// The places on two segments, from 0 to 1, that are nearest to each other, were the segments lines.
struct Nearest {
  double first = 0, second = 0, distance = 0;
};
std::optional<Nearest> nearestOfLines(const Vec3& p, const Vec3& q, const Vec3& r, const Vec3& s) {
  const Vec3 d = q - p, e = s - r, w = p - r;
  const double dd = d.squaredNorm(), de = d.dot(e), ee = e.squaredNorm(), across = dd * ee - de * de;
  if (!(across > 0)) return std::nullopt;
  Nearest made;
  made.first = (de * e.dot(w) - ee * d.dot(w)) / across;
  made.second = (dd * e.dot(w) - de * d.dot(w)) / across;
  made.distance = (w + made.first * d - made.second * e).norm();
  return made;
}

bool isWithin(double t) { return t > 0 && t < 1; }

/// Brings near things together, one kind after the other, until none is left.
class Separation {
 public:
  /// @param keepsThinTriangles in late rounds
  Separation(const Mesh& triangles, double least, bool keepsThinTriangles, const Progress& progress)
      : points_(triangles.points),
        facesAtFirst_(triangles.faceCount()),
        pointsAtFirst_(triangles.points.size()),
        least_(least),
        keepsThinTriangles_(keepsThinTriangles),
        progress_(progress) {
    faces_.reserve(triangles.faceCount());
    for (std::size_t f = 0; f < triangles.faceCount(); ++f) {
      const auto face = triangles.face(f);
      faces_.push_back({face[0], face[1], face[2]});
    }
  }

  bool separate() {
    constexpr int mostRounds = 40, usualRounds = 5;
    for (int round = 0; round < mostRounds && !growsOn(); ++round) {
      progress_.check();
      isLate_ = round > usualRounds;
      uniteCorners();
      leaveOutBackToBack();
      if (!putCornersOnEdges() && !crossEdges() && !putCornersOnFaces()) return true;
    }
    return false;
  }

  [[nodiscard]] Mesh mesh() const {
    Mesh made;
    made.points = points_;
    for (const Corners& face : faces_) made.addFace(face);
    return made;
  }

 private:
  /// Sheets that lie on each other with edges of their own divide each other on and on.
  [[nodiscard]] bool growsOn() const {
    return faces_.size() > 3 * facesAtFirst_ + 500 || points_.size() > 3 * pointsAtFirst_ + 500;
  }
  [[nodiscard]] const Vec3& at(int point) const { return points_[static_cast<std::size_t>(point)]; }

  void uniteCorners() {
    const std::vector<int> first = mergeClosePoints(points_, 2 * least_);  // or edges might be divided for ever
    for (Corners& face : faces_)
      for (int& corner : face) corner = first[static_cast<std::size_t>(corner)];
    std::erase_if(faces_, [](const Corners& f) { return f[0] == f[1] || f[1] == f[2] || f[2] == f[0]; });
  }

  /// Of faces with the same corners those stay that turn one way more than the other.
  void leaveOutBackToBack() {
    std::map<Corners, int> balance;
    for (Corners face : faces_) {
      progress_.check();
      std::rotate(face.begin(), std::min_element(face.begin(), face.end()), face.end());
      if (face[1] < face[2])
        ++balance[face];
      else
        --balance[{face[0], face[2], face[1]}];
    }
    faces_.clear();
    for (const auto& [face, times] : balance)
      for (int k = 0; k < std::abs(times); ++k) faces_.push_back(times > 0 ? face : Corners{face[0], face[2], face[1]});
  }

  [[nodiscard]] std::vector<EdgeKey> edges() const {
    std::vector<EdgeKey> made;
    made.reserve(3 * faces_.size());
    for (const Corners& face : faces_)
      for (std::size_t k = 0; k < 3; ++k) made.push_back(keyOf(face[k], face[(k + 1) % 3]));
    std::sort(made.begin(), made.end());
    made.erase(std::unique(made.begin(), made.end()), made.end());
    return made;
  }

  [[nodiscard]] std::vector<int> usedPoints() const {
    std::vector<int> made;
    for (const Corners& face : faces_) made.insert(made.end(), face.begin(), face.end());
    std::sort(made.begin(), made.end());
    made.erase(std::unique(made.begin(), made.end()), made.end());
    return made;
  }

  /// Boxes of items, as large as makes near ones meet. @param cornersOf (item) -> its points
  template <class Items, class CornersOf>
  [[nodiscard]] std::vector<Box3> boxesOf(const Items& items, const CornersOf& cornersOf) const {
    std::vector<Box3> boxes;
    boxes.reserve(items.size());
    for (const auto& item : items) {
      Box3 box;
      for (const int corner : cornersOf(item)) box.extend(at(corner));
      box.min().array() -= least_;
      box.max().array() += least_;
      boxes.push_back(box);
    }
    return boxes;
  }
  [[nodiscard]] std::vector<Box3> boxesOf(const std::vector<EdgeKey>& edges) const {
    return boxesOf(edges, [](const EdgeKey& edge) { return edge; });
  }

  /// Where along an edge each new corner lies.
  using Places = std::map<EdgeKey, std::vector<std::pair<double, int>>>;

  bool putCornersOnEdges() {
    const std::vector<EdgeKey> all = edges();
    const BoxTree<3> tree(boxesOf(all), 4, progress_);
    Places places;
    for (const int point : usedPoints()) {
      progress_.check();
      const Vec3& p = at(point);
      tree.meeting(Box3(p, p), [&](std::size_t e) {
        const auto& [from, to] = all[e];
        if (point == from || point == to) return;
        const Vec3 along = at(to) - at(from);
        const double t = (p - at(from)).dot(along) / along.squaredNorm();
        if (isWithin(t) && (p - at(from) - t * along).squaredNorm() < least_ * least_) places[all[e]].emplace_back(t, point);
      });
    }
    if (isLate_ && keepsThinTriangles_) keepThinTriangles(all, places);
    return divideEdges(places);
  }

  /// From a corner on one side of a narrow strip edges fan out to near corners on the other side, near which these lie. To
  /// put them there makes flat triangles, and these make fans again, for ever: such corners stay where they are, if they are
  /// not quite on the edge.
  void keepThinTriangles(const std::vector<EdgeKey>& edges, Places& places) const {
    constexpr double flat = 1e-3;  // of the least distance
    const auto isEdge = [&](int a, int b) { return std::binary_search(edges.begin(), edges.end(), keyOf(a, b)); };
    for (auto& [edge, along] : places) {
      const auto& [from, to] = edge;
      const Vec3 &start = at(from), way = at(to) - start;
      std::erase_if(along, [&, first = from, last = to](const auto& place) {
        const auto& [t, point] = place;
        const bool isFan = isEdge(first, point) || isEdge(last, point);
        return isFan && (at(point) - start - t * way).norm() >= flat * least_;
      });
    }
    std::erase_if(places, [](const auto& entry) { return entry.second.empty(); });
  }

  bool crossEdges() {
    const std::vector<EdgeKey> all = edges();
    const std::vector<Box3> boxes = boxesOf(all);
    Places places;
    forEachNearPair<3>(boxes, 0, progress_, [&](std::size_t i, std::size_t j) {
      const auto& [a, b] = all[i];
      const auto& [c, d] = all[j];
      if (a == c || a == d || b == c || b == d) return true;
      const auto near = nearestOfLines(at(a), at(b), at(c), at(d));
      if (!near || !isWithin(near->first) || !isWithin(near->second) || near->distance >= least_) return true;
      const Vec3 onFirst = at(a) + near->first * (at(b) - at(a)), onSecond = at(c) + near->second * (at(d) - at(c));
      const int middle = static_cast<int>(points_.size());
      points_.emplace_back((onFirst + onSecond) / 2);
      places[all[i]].emplace_back(near->first, middle);
      places[all[j]].emplace_back(near->second, middle);
      return !growsOn();
    });
    return divideEdges(places);
  }

  bool putCornersOnFaces() {
    const BoxTree<3> tree(boxesOf(faces_, [](const Corners& face) { return face; }), 4, progress_);
    std::vector<std::pair<std::size_t, int>> near;  // face, point
    for (const int point : usedPoints()) {
      progress_.check();
      const Vec3& p = at(point);
      tree.meeting(Box3(p, p), [&](std::size_t f) {
        if (std::find(faces_[f].begin(), faces_[f].end(), point) == faces_[f].end() && isOnFace(faces_[f], p))
          near.emplace_back(f, point);
      });
    }
    std::sort(near.begin(), near.end());
    for (std::size_t k = 0; k < near.size(); ++k) {
      const auto [f, point] = near[k];
      if (k > 0 && near[k - 1].first == f) continue;  // the others in the next round
      const auto [a, b, c] = faces_[f];
      faces_[f] = {a, b, point};
      faces_.push_back({b, c, point});
      faces_.push_back({c, a, point});
    }
    return !near.empty();
  }

  [[nodiscard]] bool isOnFace(const Corners& face, const Vec3& p) const {
    const Vec3 &a = at(face[0]), &b = at(face[1]), &c = at(face[2]);
    const Vec3 normal = (b - a).cross(c - a).normalized();
    if (std::abs((p - a).dot(normal)) >= least_) return false;
    const auto isLeft = [&](const Vec3& from, const Vec3& to) { return (to - from).cross(p - from).dot(normal) > 0; };
    return isLeft(a, b) && isLeft(b, c) && isLeft(c, a);
  }

  /// Corners to be put on the edges of this round; edges that this makes wait for the next one.
  bool divideEdges(Places& places) {
    if (places.empty()) return false;
    for (auto& [edge, along] : places) std::sort(along.begin(), along.end());
    std::vector<Part> open;
    for (const Corners& face : std::exchange(faces_, {})) open.push_back({face, {true, true, true}});
    while (!open.empty()) {
      progress_.check();
      const Part part = open.back();
      open.pop_back();
      if (!divide(part, places, open)) faces_.push_back(part.corners);
    }
    return true;
  }

  /// A part of a face, and which of its edges from corner k on are whole edges of the face.
  struct Part {
    Corners corners{};
    std::array<bool, 3> isEdge{};
  };

  /// Divides a part along the first of its edges on which corners are to be put.
  static bool divide(const Part& part, const Places& places, std::vector<Part>& parts) {
    for (std::size_t k = 0; k < 3; ++k) {
      const int from = part.corners[k], to = part.corners[(k + 1) % 3], other = part.corners[(k + 2) % 3];
      const auto found = part.isEdge[k] ? places.find(keyOf(from, to)) : places.end();
      if (found == places.end()) continue;
      std::vector<int> chain{std::min(from, to)};
      for (const auto& [t, point] : found->second) chain.push_back(point);
      chain.push_back(std::max(from, to));
      if (from > to) std::reverse(chain.begin(), chain.end());
      for (std::size_t i = 0; i + 1 < chain.size(); ++i) {
        const bool isFirst = i == 0, isLast = i + 2 == chain.size();
        if (chain[i] != other && chain[i + 1] != other && chain[i] != chain[i + 1])
          parts.push_back({{chain[i], chain[i + 1], other},
                           {false, isLast && part.isEdge[(k + 1) % 3], isFirst && part.isEdge[(k + 2) % 3]}});
      }
      return true;
    }
    return false;
  }

  std::vector<Vec3> points_;
  std::vector<Corners> faces_;
  std::size_t facesAtFirst_, pointsAtFirst_;
  double least_;
  bool keepsThinTriangles_, isLate_ = false;
  const Progress& progress_;
};

}  // namespace

std::optional<Mesh> separated(const Mesh& triangles, double least, const Progress& progress) {
  for (const bool keepsThinTriangles : {true, false}) {
    Separation separation(triangles, least, keepsThinTriangles, progress);
    if (separation.separate()) return separation.mesh();
  }
  return std::nullopt;
}

}  // namespace blossom::morphology
