#include "geometry/crossing/triangle_pairs.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <tuple>
#include <utility>

#include "geometry/mesh/common_area.h"
#include "geometry/mesh/triangle_distance.h"
#include "geometry/numeric/box_tree.h"

namespace blossom {
namespace {

constexpr std::size_t lyingKept = 64;

using Heights = std::array<double, 3>;

Heights heightsOver(const Triangle3& t, const Triangle3& ground, const Vec3& normal) {
  return {(t[0] - ground[0]).dot(normal), (t[1] - ground[0]).dot(normal), (t[2] - ground[0]).dot(normal)};
}

double largestOf(const Heights& h) { return std::max({std::abs(h[0]), std::abs(h[1]), std::abs(h[2])}); }

bool isOnOneSide(const Heights& h, double slack) {
  return std::min({h[0], h[1], h[2]}) > slack || std::max({h[0], h[1], h[2]}) < -slack;
}

/// Where a segment whose ends have these heights over the plane of a triangle meets it (Ericson, Real-Time Collision
/// Detection, section 5.3); borders count.
std::optional<Vec3> whereHit(const Vec3& p, double heightP, const Vec3& q, double heightQ, const Triangle3& t,
                             const Vec3& normal) {
  if (heightP * heightQ > 0 || heightP == heightQ) return {};
  constexpr double border = -1e-9;  // of the triangle's area
  const Vec3 x = p + heightP / (heightP - heightQ) * (q - p);
  const double whole = (t[1] - t[0]).cross(t[2] - t[0]).dot(normal);
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec3 &a = t[k], &b = t[(k + 1) % 3];
    if ((b - a).cross(x - a).dot(normal) < border * whole) return {};
  }
  return x;
}

struct CommonCorners {
  int count = 0;
  std::size_t inFirst = 0, inSecond = 0;
};

CommonCorners commonCorners(const SheetTriangle& a, const SheetTriangle& b) {
  CommonCorners shared;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      if (a.corners[i] == b.corners[j]) ++shared.count, shared.inFirst = i, shared.inSecond = j;
  return shared;
}

double roundOf(const std::vector<Vec3>& polygon) {
  double sum = 0;
  for (std::size_t k = 0; k < polygon.size(); ++k) sum += (polygon[(k + 1) % polygon.size()] - polygon[k]).norm();
  return sum;
}

class PairSearch {
 public:
  PairSearch(const SheetMesh& mesh, std::size_t most, const Progress& progress)
      : mesh_(mesh), most_(most), slack_(1e-12 * mesh.size), progress_(progress) {
    boxes_.reserve(mesh.triangles.size());
    for (const SheetTriangle& t : mesh.triangles) boxes_.push_back(boxOf(mesh.at(t)));
  }

  MeetingTriangles run() {
    std::vector<Box3> boxes;
    boxes.reserve(mesh_.blocks.size());
    for (std::size_t k = 0; k < mesh_.blocks.size(); ++k) {
      boxes.push_back(mesh_.blocks[k].box);
      if (!keepApart(k, k)) search(k, k);
    }
    forEachNearPair<3>(boxes, slack_, progress_, [&](std::size_t i, std::size_t j) {
      if (!keepApart(i, j) && !planeBetween(mesh_.blocks[i], mesh_.blocks[j])) search(i, j);
      return true;
    });
    keepGreatest(most_);
    return {std::move(found_), std::move(lying_), std::move(alike_)};
  }

 private:
  [[nodiscard]] static std::size_t apart(std::size_t a, std::size_t b, std::size_t count, bool closed) {
    const std::size_t d = a > b ? a - b : b - a;
    return closed ? std::min(d, count - d) : d;
  }

  /// Whether the cones prove that two blocks of a grid that touch, or one by itself, meet nowhere else.
  [[nodiscard]] bool keepApart(std::size_t i, std::size_t j) const {
    if (mesh_.blocksU == 0) return false;
    const std::size_t countU = mesh_.blocksU, countV = mesh_.blocksV;
    // Of a ring of two or three blocks, the way round is as near as the direct one.
    if (i != j && ((mesh_.closedU && countU < 4) || (mesh_.closedV && countV < 4))) return false;
    const std::size_t ui = i / countV, vi = i % countV, uj = j / countV, vj = j % countV;
    if (apart(ui, uj, countU, mesh_.closedU) > 1 || apart(vi, vj, countV, mesh_.closedV) > 1) return false;
    DirectionCone alongU = mesh_.blocks[i].alongU, alongV = mesh_.blocks[i].alongV;
    for (const std::size_t u : {ui, uj})
      for (const std::size_t v : {vi, vj}) {
        const SheetBlock& block = mesh_.blocks[u * countV + v];
        alongU = joinedCone(alongU, block.alongU);
        alongV = joinedCone(alongV, block.alongV);
      }
    constexpr double margin = 0.02;  // radians, for what the smooth surface does between the corners
    if (alongU.axis.isZero() || alongV.axis.isZero()) return false;
    const double between = std::acos(std::clamp(alongU.axis.dot(alongV.axis), -1.0, 1.0));
    const double both = alongU.halfAngle + alongV.halfAngle + margin;
    return both < between && between < std::numbers::pi - both;
  }

  [[nodiscard]] std::pair<double, double> extent(const SheetBlock& block, const Vec3& along) const {
    double low = std::numeric_limits<double>::max(), high = std::numeric_limits<double>::lowest();
    for (std::uint32_t k = block.first; k < block.first + block.count; ++k)
      for (const int corner : mesh_.triangles[k].corners) {
        const double x = along.dot(mesh_.points[static_cast<std::size_t>(corner)]);
        low = std::min(low, x), high = std::max(high, x);
      }
    return {low, high};
  }

  [[nodiscard]] bool planeBetween(const SheetBlock& a, const SheetBlock& b) const {
    for (const Vec3& normal : {a.normal, b.normal}) {
      if (normal.isZero()) continue;
      const auto [lowA, highA] = extent(a, normal);
      const auto [lowB, highB] = extent(b, normal);
      if (highA + slack_ < lowB || highB + slack_ < lowA) return true;
    }
    return false;
  }

  void search(std::size_t i, std::size_t j) {
    progress_.check();
    const SheetBlock &a = mesh_.blocks[i], &b = mesh_.blocks[j];
    for (std::uint32_t k = a.first; k < a.first + a.count; ++k) {
      if (!boxes_[k].intersects(b.box)) continue;
      for (std::uint32_t l = i == j ? k + 1 : b.first; l < b.first + b.count; ++l)
        if (boxes_[k].intersects(boxes_[l])) test(k, l);
    }
  }

  void test(std::uint32_t k, std::uint32_t l) {
    const SheetTriangle &first = mesh_.triangles[k], &second = mesh_.triangles[l];
    const CommonCorners shared = commonCorners(first, second);
    if (shared.count > 1) return;
    const Triangle3 a = mesh_.at(first), b = mesh_.at(second);
    const Vec3 normalA = (a[1] - a[0]).cross(a[2] - a[0]).normalized(),
               normalB = (b[1] - b[0]).cross(b[2] - b[0]).normalized();
    const Heights ofA = heightsOver(a, b, normalB);
    if (isOnOneSide(ofA, slack_)) return;
    const Heights ofB = heightsOver(b, a, normalA);
    if (isOnOneSide(ofB, slack_)) return;
    const double height = std::min(largestOf(ofA), largestOf(ofB));
    if (height <= 1e-9 * mesh_.size) {
      addLying(k, l, a, b, normalA.dot(normalB));
      return;
    }
    for (std::size_t side = 0; side < 3; ++side) {
      const std::size_t from = (side + 1) % 3, to = (side + 2) % 3;  // across from corner `side`
      if (shared.count == 0 || side == shared.inFirst)
        if (const auto place = whereHit(a[from], ofA[from], a[to], ofA[to], b, normalB)) return add({k, l, *place, height});
      if (shared.count == 0 || side == shared.inSecond)
        if (const auto place = whereHit(b[from], ofB[from], b[to], ofB[to], a, normalA)) return add({k, l, *place, height});
    }
  }

  /// Triangles of one plane that cover the same places.
  void addLying(std::uint32_t k, std::uint32_t l, const Triangle3& a, const Triangle3& b, double cosine) {
    constexpr double parallel = 1 - 1e-9, visible = 1e-8, wide = 1e-4;
    const bool opposite = cosine < 0;
    std::vector<TrianglePair>& found = opposite ? lying_ : alike_;
    if (!(std::abs(cosine) >= parallel) || found.size() >= lyingKept) return;
    const std::vector<Vec3> common = commonPolygon(a, b);
    const double area = areaOf(common);
    if (!(area > visible * mesh_.size * mesh_.size)) return;
    // What parts that are not quite flush have in common is a strip.
    if (!opposite && !(area > wide * mesh_.size * roundOf(common))) return;
    Vec3 middle = Vec3::Zero();
    for (const Vec3& p : common) middle += p / static_cast<double>(common.size());
    found.push_back({k, l, middle, 0});
  }

  void add(const TrianglePair& pair) {
    found_.push_back(pair);
    if (found_.size() >= 8 * most_) keepGreatest(4 * most_);
  }

  void keepGreatest(std::size_t count) {
    const auto before = [](const TrianglePair& a, const TrianglePair& b) {
      return std::tuple(b.height, a.first, a.second) < std::tuple(a.height, b.first, b.second);
    };
    std::sort(found_.begin(), found_.end(), before);
    if (found_.size() > count) found_.resize(count);
  }

  const SheetMesh& mesh_;
  std::size_t most_;
  double slack_;
  const Progress& progress_;
  std::vector<Box3> boxes_;
  std::vector<TrianglePair> found_, lying_, alike_;
};

}  // namespace

MeetingTriangles meetingTriangles(const SheetMesh& mesh, std::size_t most, const Progress& progress) {
  return PairSearch(mesh, most, progress).run();
}

}  // namespace blossom
