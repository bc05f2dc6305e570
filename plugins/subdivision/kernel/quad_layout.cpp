#include "kernel/quad_layout.h"

#include <algorithm>
#include <deque>
#include <limits>
#include <map>
#include <set>

#include "geometry/mesh/mesh_topology.h"

namespace blossom::subdivision {
namespace {

/// A half-edge is named by its place in faceVertices: 4 f + k runs from corner k of face f to the next.
class Layout {
 public:
  Layout(const Mesh& mesh, const Progress& progress) : mesh_(mesh), progress_(progress) {
    findTwins();
    findSharp();
    findIrregular();
  }

  std::vector<LayoutCell> run() {
    for (std::size_t h = 0; h < twin_.size(); ++h)
      if (sharp_[h] || twin_[h] < 0) marked_[h] = true;
    for (std::size_t h = 0; h < twin_.size(); ++h)
      if (irregular_[from(h)]) drawLines(h);
    return collect();
  }
  [[nodiscard]] std::size_t looked() const { return looked_; }

 private:
  [[nodiscard]] std::size_t from(std::size_t h) const { return static_cast<std::size_t>(mesh_.faceVertices[h]); }
  [[nodiscard]] static std::size_t next(std::size_t h) { return h % 4 == 3 ? h - 3 : h + 1; }
  [[nodiscard]] static std::size_t previous(std::size_t h) { return h % 4 == 0 ? h + 3 : h - 1; }

  void findTwins() {
    twin_.assign(mesh_.faceVertices.size(), -1);
    sharp_.assign(twin_.size(), false);
    marked_.assign(twin_.size(), false);
    for (const MeshEdge& edge : meshTopology(mesh_, progress_).edges) {
      if (!edge.manifold()) continue;
      twin_[static_cast<std::size_t>(edge.corners[0])] = edge.corners[1];
      twin_[static_cast<std::size_t>(edge.corners[1])] = edge.corners[0];
    }
  }

  void findSharp() {
    std::set<std::pair<int, int>> creased;
    for (const Crease& crease : mesh_.creases)
      if (crease.sharpness > 0) creased.insert(std::minmax(crease.from, crease.to));
    for (std::size_t h = 0; h < sharp_.size(); ++h)
      sharp_[h] = creased.count(std::minmax(mesh_.faceVertices[h], mesh_.faceVertices[next(h)])) > 0;
  }

  /// The half-edge that leaves where `h` ends, straight on; -1 at the rim.
  [[nodiscard]] long straightOn(std::size_t h) const {
    const long across = twin_[next(h)];
    return across < 0 ? -1 : static_cast<long>(next(static_cast<std::size_t>(across)));
  }

  void findIrregular() {
    const std::size_t count = mesh_.points.size();
    std::vector<int> faces(count), rims(count), sharpEdges(count);
    std::vector<bool> straightCrease(count);
    for (std::size_t h = 0; h < twin_.size(); ++h) {
      ++faces[from(h)];
      rims[from(h)] += twin_[h] < 0 ? 1 : 0;
      if (twin_[h] < 0 || !sharp_[h]) continue;
      ++sharpEdges[from(h)];  // of every edge one half-edge leaves the vertex
      if (const long on = straightOn(h); on >= 0 && sharp_[static_cast<std::size_t>(on)])
        straightCrease[from(next(h))] = true;
    }
    irregular_.assign(count, false);
    for (std::size_t v = 0; v < count; ++v) {
      if (rims[v] > 0)
        irregular_[v] = sharpEdges[v] > 0 || faces[v] > 2;
      else
        irregular_[v] = faces[v] != 4 || (sharpEdges[v] > 0 && !(sharpEdges[v] == 2 && straightCrease[v]));
    }
    for (const Corner& corner : mesh_.corners)
      if (corner.sharpness > 0) irregular_[static_cast<std::size_t>(corner.vertex)] = true;
    for (const std::string& tag : mesh_.otherTags)  // corners of the rim that are rounded
      if (tag.find("interpolateboundary 1/0/0 2") != std::string::npos)
        for (std::size_t v = 0; v < count; ++v)
          if (rims[v] > 0 && faces[v] == 1) irregular_[v] = true;
  }

  /// Marks the line that begins with h; it ends at irregular vertices, at the rim and where it is marked already.
  void drawLine(std::size_t h) {
    for (bool first = true;; first = false) {
      if (twin_[h] < 0) return;
      const auto other = static_cast<std::size_t>(twin_[h]);
      const bool known = marked_[h] && !sharp_[h];
      if (!marked_[h]) fresh_.insert(fresh_.end(), {h, other});
      marked_[h] = marked_[other] = true;
      if ((known && !first) || irregular_[from(next(h))]) return;
      const long on = straightOn(h);
      // At the rim, next(h) is a side of the rim itself and the line has come across.
      if (on < 0 || onRim(next(h))) return;
      h = static_cast<std::size_t>(on);
    }
  }

  [[nodiscard]] bool onRim(std::size_t h) const {
    std::size_t at = h;  // turns round the vertex that h leaves
    do {
      if (twin_[at] < 0) return true;
      at = next(static_cast<std::size_t>(twin_[at]));
    } while (at != h);
    return false;
  }

  /// The lines along h, and back from where it begins.
  void drawLines(std::size_t h) {
    drawLine(h);
    if (const long before = twin_[previous(h)]; before >= 0) drawLine(static_cast<std::size_t>(before));
  }

  struct Place {
    int column = 0, row = 0, turn = 0;
    auto operator<=>(const Place&) const = default;
  };

  /// The parts between the marks. Those without corners, such as a torus, are cut open; every cut marks more edges, so this
  /// ends. A cut may run on into parts that were rectangles already: those alone are looked at again.
  std::vector<LayoutCell> collect() {
    part_.assign(mesh_.faceCount(), none);
    std::map<std::size_t, LayoutCell> cells;  // by their lowest face
    for (std::size_t f = 0; f < part_.size();) {
      if (f % 256 == 0) progress_.check();
      if (part_[f] != none) {
        ++f;
        continue;
      }
      std::map<std::size_t, Place> places;
      const bool plain = growFrom(f, places);
      looked_ += places.size();
      if (!plain || !isRectangle(places)) {
        fresh_.clear();
        cut(places);
        f = std::min(f, reopened(cells));
        continue;
      }
      for (const auto& [face, place] : places) part_[face] = f;
      cells.emplace(f, cellOf(places));
    }
    std::vector<LayoutCell> all;
    all.reserve(cells.size());
    for (auto& [lowest, cell] : cells) all.push_back(std::move(cell));
    return all;
  }

  /// Gives up the cells that new marks run through. @returns the lowest face of them.
  std::size_t reopened(std::map<std::size_t, LayoutCell>& cells) {
    std::size_t lowest = none;
    for (const std::size_t h : fresh_) {
      const std::size_t part = part_[h / 4];
      if (part == none) continue;
      for (const PlacedFace& placed : cells.at(part).faces) part_[static_cast<std::size_t>(placed.face)] = none;
      cells.erase(part);
      lowest = std::min(lowest, part);
    }
    return lowest;
  }

  /// Gives every face that is reached without crossing a mark its place; false when one would have two, or two one.
  bool growFrom(std::size_t start, std::map<std::size_t, Place>& places) const {
    std::set<std::pair<int, int>> taken{{0, 0}};
    std::deque<std::size_t> queue{start};
    places[start] = {};
    bool plain = true;
    for (; !queue.empty(); queue.pop_front()) {
      const std::size_t f = queue.front();
      const Place here = places.at(f);
      for (int side = 0; side < 4; ++side) {  // below, right, above, left
        const std::size_t h = 4 * f + static_cast<std::size_t>((here.turn + side) % 4);
        if (marked_[h]) continue;
        const auto other = static_cast<std::size_t>(twin_[h]);
        constexpr std::array<int, 4> stepColumn{0, 1, 0, -1}, stepRow{-1, 0, 1, 0};
        const auto s = static_cast<std::size_t>(side);
        const Place there{here.column + stepColumn[s], here.row + stepRow[s],
                          (static_cast<int>(other % 4) - (side + 2) + 8) % 4};
        const auto [found, fresh] = places.try_emplace(other / 4, there);
        if (!fresh) {
          plain = plain && found->second == there;
          continue;
        }
        plain = taken.insert({there.column, there.row}).second && plain;
        queue.push_back(other / 4);
      }
    }
    return plain;
  }

  static bool isRectangle(const std::map<std::size_t, Place>& places) {
    const auto [low, high] = extent(places);
    return static_cast<std::size_t>(high.column - low.column + 1) * static_cast<std::size_t>(high.row - low.row + 1) ==
           places.size();
  }

  static std::pair<Place, Place> extent(const std::map<std::size_t, Place>& places) {
    constexpr int most = std::numeric_limits<int>::max();
    Place low{most, most, 0}, high{-most, -most, 0};
    for (const auto& [face, place] : places) {
      low = {std::min(low.column, place.column), std::min(low.row, place.row), 0};
      high = {std::max(high.column, place.column), std::max(high.row, place.row), 0};
    }
    return {low, high};
  }

  /// Draws lines along an edge that is not marked yet, or, where that adds nothing, along all of them.
  void cut(const std::map<std::size_t, Place>& places) {
    for (const int across : {0, 1})
      for (const auto& [face, place] : places) {
        const std::size_t h = 4 * face + static_cast<std::size_t>((place.turn + across) % 4);
        if (marked_[h]) continue;
        drawLine(h);
        drawLine(static_cast<std::size_t>(twin_[h]));
        break;
      }
  }

  [[nodiscard]] LayoutCell cellOf(const std::map<std::size_t, Place>& places) const {
    const auto [low, high] = extent(places);
    LayoutCell cell;
    cell.columns = high.column - low.column + 1;
    cell.rows = high.row - low.row + 1;
    cell.faces.resize(places.size());
    for (const auto& [face, place] : places)
      cell.faces[static_cast<std::size_t>((place.row - low.row) * cell.columns + place.column - low.column)] = {
          static_cast<int>(face), place.turn};
    const std::array<PlacedFace, 4> ends{cell.at(0, 0), cell.at(cell.columns - 1, 0),
                                         cell.at(cell.columns - 1, cell.rows - 1), cell.at(0, cell.rows - 1)};
    for (std::size_t k = 0; k < 4; ++k) {
      cell.corners[k] = mesh_.face(static_cast<std::size_t>(ends[k].face))[(static_cast<std::size_t>(ends[k].turn) + k) % 4];
      cell.irregularCorner[k] = irregular_[static_cast<std::size_t>(cell.corners[k])];
    }
    return cell;
  }

  static constexpr std::size_t none = std::numeric_limits<std::size_t>::max();

  const Mesh& mesh_;
  const Progress& progress_;
  std::vector<long> twin_;
  std::vector<bool> sharp_, marked_, irregular_;
  std::vector<std::size_t> part_;   ///< of each face the lowest face of its cell
  std::vector<std::size_t> fresh_;  ///< half-edges that the last cut marked
  std::size_t looked_ = 0;
};

}  // namespace

std::vector<LayoutCell> quadLayout(const Mesh& mesh, const Progress& progress, std::size_t* looked) {
  Layout layout(mesh, progress);
  std::vector<LayoutCell> cells = layout.run();
  if (looked) *looked = layout.looked();
  return cells;
}

}  // namespace blossom::subdivision
