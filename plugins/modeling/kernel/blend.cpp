#include "kernel/blend.h"

#include <fmt/format.h>

#include <Standard_Failure.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>

#include "core/error.h"
#include "core/units.h"
#include "geometry/sub_shape.h"
#include "kernel/finished_solid.h"
#include "kernel/largest_size.h"
#include "kernel/shape_parts.h"
#include "kernel/sharp_edges.h"

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

  /// Null when it fails or gives no good solid.
  [[nodiscard]] TopoDS_Shape tried(const std::vector<TopoDS_Edge>& edges, double size) const {
    try {
      const TopoDS_Shape made = attempt_(shape_, edges, size);
      return isGoodSolid(made) ? made : TopoDS_Shape();
    } catch (const Standard_Failure&) {
      return {};
    }
  }

  /// Looks for the edge that fails alone and for what it could take.
  [[noreturn]] void explain(const std::vector<TopoDS_Edge>& edges) const {
    progress_.report(0.5, "Looking for the edge that fails");
    for (std::size_t i = 0; i < edges.size() && i < mostTried; ++i) {
      progress_.check();
      if (edges.size() == 1 || tried({edges[i]}, size_).IsNull()) explain(edges[i]);
    }
    const auto largest = largestSize(
        size_, [&](double size) { return !tried(edges, size).IsNull(); }, progress_);
    const std::string message = fmt::format(
        "The edges cannot all be {} with {} mm: where they meet there is not enough room.", words_.done, mm(size_));
    throw Error(ErrorCode::InvalidInput,
                largest
                    ? message + fmt::format(" The largest {} for all is about {} mm.", words_.size, roundedDown(*largest))
                    : message,
                fmt::format("Use a smaller {}, or choose fewer edges.", words_.size));
  }

 private:
  static constexpr std::size_t mostTried = 60;  ///< above, the search would take longer than it is worth

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

  [[noreturn]] void explain(const TopoDS_Edge& edge) const {
    const auto largest = largestSize(
        size_, [&](double size) { return !tried({edge}, size).IsNull(); }, progress_);
    if (!largest)
      throw Error(ErrorCode::InvalidInput,
                  fmt::format("Edge {} cannot be {} with {} mm, nor with a much smaller {}.", numberOf(edge), words_.done,
                              mm(size_), words_.size),
                  "The faces beside it leave no room. Choose other edges.");
    throw Error(ErrorCode::InvalidInput,
                fmt::format("Edge {} cannot be {} with {} mm: the largest {} here is about {} mm.", numberOf(edge),
                            words_.done, mm(size_), words_.size, roundedDown(*largest)),
                fmt::format("Use a smaller {}, or leave this edge out.", words_.size));
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
  if (partsOf(shape, TopAbs_SOLID).empty())
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
