#include "kernel/solid/blend.h"

#include <fmt/format.h>

#include <Standard_Failure.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <algorithm>
#include <optional>

#include "core/error.h"
#include "core/units.h"
#include "geometry/occt/sub_shape.h"
#include "kernel/parts/finished_solid.h"
#include "kernel/parts/largest_size.h"
#include "kernel/parts/shape_parts.h"
#include "kernel/parts/sharp_edges.h"

namespace blossom::modeling {

namespace {

class Blender {
 public:
  Blender(const TopoDS_Shape& shape, double size, const BlendWords& words, const BlendAttempt& attempt,
          const Progress& progress)
      : shape_(shape), size_(size), words_(words), attempt_(attempt), progress_(progress) {
    TopExp::MapShapes(shape, TopAbs_EDGE, numbers_);
  }

  [[nodiscard]] std::vector<TopoDS_Edge> chosen(const std::vector<int>& indices) const {
    if (indices.empty()) return allSharp();
    const EdgeSorter sorter(shape_);
    const Brep brep(shape_);
    TopTools_IndexedMapOfShape seen;
    std::vector<TopoDS_Edge> edges;
    for (const int index : indices) {
      const TopoDS_Edge edge = edgeOf(brep, index);
      checkSort(index, sorter.sort(edge));
      const int known = seen.Extent();
      if (seen.Add(edge) > known) edges.push_back(edge);
    }
    return edges;
  }

  /// Null when it fails or the solid is invalid.
  [[nodiscard]] TopoDS_Shape tried(const std::vector<TopoDS_Edge>& edges, double size) const {
    try {
      const TopoDS_Shape made = attempt_(shape_, edges, size);
      return isGoodSolid(made) ? made : TopoDS_Shape();
    } catch (const Standard_Failure&) {
      return {};
    }
  }

  /// Looks for an edge that fails by itself and for the size that would do for all.
  [[noreturn]] void explain(const std::vector<TopoDS_Edge>& edges) const {
    progress_.report(0.4, "Looking for the edge that fails");
    const TopoDS_Edge* failing = &edges.front();
    for (std::size_t i = 0; edges.size() > 1; ++i) {
      progress_.check();
      failing = i < std::min(edges.size(), maximumTried) ? &edges[i] : nullptr;
      if (!failing || tried({*failing}, size_).IsNull()) break;
    }
    progress_.report(0.6, fmt::format("Looking for the largest {}", words_.size));
    const auto largest = largestSize(
        size_, [&](double size) { return !tried(edges, size).IsNull(); }, progress_);
    throw Error(ErrorCode::InvalidInput, whatFails(failing) + whatWorks(largest, edges.size() > 1),
                fmt::format("Use a smaller {}, or leave edges out.", words_.size));
  }

 private:
  static constexpr std::size_t maximumTried = 60;  ///< above, the search would take longer than it is worth

  static std::string mm(double size) { return formatNumber(size); }
  [[nodiscard]] int numberOf(const TopoDS_Edge& edge) const { return numbers_.FindIndex(edge) - 1; }

  [[nodiscard]] std::vector<TopoDS_Edge> allSharp() const {
    auto edges = sharpEdges(shape_);
    if (edges.empty())
      throw Error(ErrorCode::InvalidInput, fmt::format("The shape has no edge that could be {}.", words_.done),
                  "All its faces meet smoothly.");
    return edges;
  }

  void checkSort(int index, EdgeSort sort) const {
    if (sort == EdgeSort::Sharp) return;
    const char* why = sort == EdgeSort::Smooth ? "its faces meet smoothly there"
                      : sort == EdgeSort::Seam ? "it is only the seam of one face"
                                               : "it does not lie between two faces";
    throw Error(ErrorCode::InvalidInput, fmt::format("Edge {} cannot be {}: {}.", index, words_.done, why),
                "Choose an edge where two faces meet at an angle.");
  }

  [[nodiscard]] std::string whatFails(const TopoDS_Edge* edge) const {
    if (edge) return fmt::format("Edge {} cannot be {} with {} mm", numberOf(*edge), words_.done, mm(size_));
    return fmt::format("The edges cannot all be {} with {} mm", words_.done, mm(size_));
  }

  [[nodiscard]] std::string whatWorks(const std::optional<double>& largest, bool several) const {
    if (!largest) return fmt::format(", nor with a much smaller {}.", words_.size);
    return fmt::format(": the largest {} {} is about {} mm.", words_.size, several ? "for all these edges" : "here",
                       roundedDown(*largest));
  }

  const TopoDS_Shape& shape_;
  double size_;
  const BlendWords& words_;
  const BlendAttempt& attempt_;
  const Progress& progress_;
  TopTools_IndexedMapOfShape numbers_;
};

}  // namespace

BlendResult blend(const TopoDS_Shape& shape, const std::vector<int>& indices, double size, const BlendWords& words,
                  const BlendAttempt& attempt, const Progress& progress) {
  if (subShapesOf(shape, TopAbs_SOLID).empty())
    throw Error(ErrorCode::InvalidInput, fmt::format("Only edges of a solid can be {}; the input is none.", words.done),
                "Extrude it, or close its surfaces to a solid.");
  if (!(size > 1e-6))
    throw Error(ErrorCode::InvalidParameter,
                fmt::format("The {} must be above 0; it is {} mm.", words.size, formatNumber(size)));
  const Blender blender(shape, size, words, attempt, progress);
  const auto edges = blender.chosen(indices);
  progress.report(0.1, "Working on the edges");
  const TopoDS_Shape made = blender.tried(edges, size);
  if (made.IsNull()) blender.explain(edges);
  return {finishedSolid(made, {fmt::format("The edges cannot be {}.", words.done), ""}), static_cast<int>(edges.size())};
}

}  // namespace blossom::modeling
