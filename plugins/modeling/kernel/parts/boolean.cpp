#include "kernel/parts/boolean.h"

#include <fmt/format.h>

#include <BRepAlgoAPI_Common.hxx>
#include <BRepAlgoAPI_Cut.hxx>
#include <BRepAlgoAPI_Fuse.hxx>
#include <BRepBuilderAPI_Copy.hxx>
#include <TopTools_ListOfShape.hxx>
#include <memory>

#include "core/error.h"
#include "core/place_text.h"
#include "geometry/occt/joined_faces.h"
#include "geometry/occt/occt_progress.h"
#include "geometry/shape/compound.h"
#include "kernel/parts/boolean_check.h"
#include "kernel/parts/finished_solid.h"
#include "kernel/parts/guarded.h"
#include "kernel/parts/shape_parts.h"

namespace blossom::modeling {

namespace {

const char* nameOf(BooleanOperation operation) {
  switch (operation) {
    case BooleanOperation::Union:
      return "union";
    case BooleanOperation::Difference:
      return "difference";
    case BooleanOperation::Intersection:
      return "intersection";
  }
  return "";
}

/// True when solids are combined, false for faces.
bool checkInputs(const std::vector<TopoDS_Shape>& shapes) {
  if (shapes.size() < 2)
    throw Error(ErrorCode::InvalidInput, "A Boolean operation needs at least two shapes.", "Add another input.");
  const bool solids = !subShapesOf(shapes.front(), TopAbs_SOLID).empty();
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    // Solids without loose faces, or faces alone.
    const bool hasSolids = !subShapesOf(shapes[i], TopAbs_SOLID).empty();
    const bool hasLooseFaces = !looseParts(shapes[i], TopAbs_FACE, TopAbs_SOLID).empty();
    if (hasSolids == solids && hasLooseFaces == !solids) continue;
    throw Error(ErrorCode::InvalidInput,
                fmt::format("Input {} is not {}.", i + 1, solids ? "a closed solid" : "a flat region"),
                solids ? "Close its surfaces to a solid first." : "Combine solids with solids and regions with regions.");
  }
  return solids;
}

std::unique_ptr<BRepAlgoAPI_BooleanOperation> algorithm(BooleanOperation operation) {
  switch (operation) {
    case BooleanOperation::Union:
      return std::make_unique<BRepAlgoAPI_Fuse>();
    case BooleanOperation::Difference:
      return std::make_unique<BRepAlgoAPI_Cut>();
    case BooleanOperation::Intersection:
      return std::make_unique<BRepAlgoAPI_Common>();
  }
  return {};
}

class Combiner {
 public:
  Combiner(const BooleanOptions& options, bool solids) : options_(options), solids_(solids) {}

  TopoDS_Shape run(const TopoDS_Shape& first, const TopTools_ListOfShape& others, const Progress& progress) const {
    const auto operation = algorithm(options_.operation);
    TopTools_ListOfShape arguments;
    arguments.Append(first);
    operation->SetArguments(arguments);
    operation->SetTools(others);
    operation->SetNonDestructive(Standard_True);
    operation->SetRunParallel(Standard_True);
    if (options_.fuzzy > 0) operation->SetFuzzyValue(options_.fuzzy);
    const Handle(OcctProgress) watcher = new OcctProgress(progress, "Combining");
    operation->Build(watcher->Start());
    progress.check();
    if (operation->HasErrors() || operation->Shape().IsNull()) throwFailed();
    return operation->Shape();
  }

  /// Null when nothing is left.
  [[nodiscard]] TopoDS_Shape finished(const TopoDS_Shape& shape) const {
    const TopAbs_ShapeEnum kind = solids_ ? TopAbs_SOLID : TopAbs_FACE;
    const auto parts = subShapesOf(shape, kind);
    if (parts.empty()) return {};
    return solids_ ? finishedSolid(compoundOf(parts), complaint()) : finishedSheet(compoundOf(parts), complaint());
  }

 private:
  [[nodiscard]] Complaint complaint() const {
    return {
        fmt::format("The {} of these shapes gives no good result.", nameOf(options_.operation)),
        "Faces that nearly touch are the usual cause: move one shape a little, or set a fuzzy distance such as 0.01 mm."};
  }
  [[noreturn]] void throwFailed() const { throw Error(ErrorCode::Degenerate, complaint().message, complaint().hint); }
  const BooleanOptions& options_;
  bool solids_;
};

TopTools_ListOfShape listOf(std::vector<TopoDS_Shape>::const_iterator from, std::vector<TopoDS_Shape>::const_iterator to) {
  TopTools_ListOfShape list;
  for (; from != to; ++from) list.Append(*from);
  return list;
}

/// Several tools of a common mean their union to OCCT; what all have in common is made one by one. Null when nothing is
/// left.
TopoDS_Shape combined(const Combiner& combiner, const std::vector<TopoDS_Shape>& shapes, BooleanOperation operation,
                      const Progress& progress) {
  if (operation != BooleanOperation::Intersection)
    return combiner.finished(combiner.run(shapes.front(), listOf(shapes.begin() + 1, shapes.end()), progress));
  TopoDS_Shape common = shapes.front();
  for (std::size_t i = 1; i < shapes.size() && !common.IsNull(); ++i) {
    const double count = static_cast<double>(shapes.size() - 1), from = static_cast<double>(i - 1) / count;
    const auto each = shapes.begin() + static_cast<std::ptrdiff_t>(i);
    common = combiner.finished(combiner.run(common, listOf(each, each + 1), progress.part(from, from + 1 / count)));
  }
  return common;
}

}  // namespace

void refuseNothingLeft(BooleanOperation operation) {
  if (operation == BooleanOperation::Difference)
    throw Error(ErrorCode::Degenerate, "Nothing is left: the other shapes cover the first one completely.",
                "The order of the inputs counts: the first one keeps what the others leave of it.");
  throw Error(ErrorCode::Degenerate, "The shapes have no space in common, so their intersection is empty.",
              "Move them so that they overlap.");
}

namespace {

void tellUnasked(const std::vector<std::size_t>& unasked, BooleanResult& told) {
  for (const std::size_t k : unasked)
    told.warnings.push_back(fmt::format(
        "It is not known whether shape {} counts as it should: it is too small or too thin beside the others to be judged.",
        k + 1));
}

[[noreturn]] void refuseWrong(const BooleanOptions& options, const Vec3& place) {
  throw Error(
      ErrorCode::Degenerate,
      fmt::format("The {} of these shapes{} comes out wrong near {}.", nameOf(options.operation),
                  options.fuzzy > 0 ? fmt::format(", with a fuzzy distance of {:g} mm,", options.fuzzy) : std::string(),
                  placeText(place)),
      options.fuzzy > 0 ? "Try it without a fuzzy distance, or with a smaller one."
                        : "Move or turn one shape a little, so that its faces do not lie along an edge of the other.");
}

/// The result; with faces that nearly touch taken as touching, which is told, where it comes out wrong otherwise.
TopoDS_Shape checkedResult(const std::vector<TopoDS_Shape>& shapes, const BooleanOptions& options, BooleanResult& told,
                           const Progress& progress) {
  const auto attempt = [&](double fuzzy) {
    BooleanOptions wider = options;
    wider.fuzzy = fuzzy;
    const TopoDS_Shape made = combined(Combiner(wider, true), shapes, options.operation, progress);
    return std::pair(made, checkBoolean(shapes, options.operation, made, fuzzy, progress));
  };
  const auto [made, check] = attempt(options.fuzzy);
  if (!check.wrongAt) {
    tellUnasked(check.unasked, told);
    return made;
  }
  double size = 0;
  for (const TopoDS_Shape& shape : shapes) size = std::max(size, diagonalOf(shape));
  for (const double share : {1e-5, 1e-4, 3e-4}) {
    const double fuzzy = share * size;
    if (fuzzy <= options.fuzzy) continue;
    try {
      const auto [again, checkAgain] = attempt(fuzzy);
      if (checkAgain.wrongAt) continue;
      told.warnings.push_back(fmt::format(
          "Faces within {:.2g} mm were taken as touching: the result of the shapes as they are comes out wrong.", fuzzy));
      tellUnasked(checkAgain.unasked, told);
      return again;
    } catch (const Error& error) {
      if (error.code() != ErrorCode::Degenerate) throw;
    }
  }
  refuseWrong(options, *check.wrongAt);
}

/// The shape with faces of one surface joined; null where that spoils it.
TopoDS_Shape simplified(const TopoDS_Shape& shape, bool solids) {
  // Of a copy: joining, and the mending after it, change edges that the given shape shares even where they fail.
  TopoDS_Shape simple = withJoinedFaces(BRepBuilderAPI_Copy(shape).Shape(), JoinedEdges::Join);
  if (simple.IsNull() || !solids) return simple;
  constexpr double rounding = 1e-5;  // of the volume, as it is integrated
  const double volume = volumeOf(shape);
  return isGoodSolid(simple) && std::abs(volumeOf(simple) - volume) <= rounding * std::abs(volume) ? simple : TopoDS_Shape();
}

}  // namespace

BooleanResult combine(const std::vector<TopoDS_Shape>& shapes, const BooleanOptions& o, const Progress& progress) {
  const bool solids = checkInputs(shapes);
  const Combiner combiner(o, solids);
  return guarded(
      fmt::format("The {} of these shapes cannot be computed.", nameOf(o.operation)),
      "Move one shape a little, or set a fuzzy distance such as 0.01 mm.", [&] {
        BooleanResult result;
        const Progress part = progress.part(0, 0.85);
        result.shape = solids ? checkedResult(shapes, o, result, part) : combined(combiner, shapes, o.operation, part);
        if (result.shape.IsNull()) refuseNothingLeft(o.operation);
        if (!o.simplify) return result;
        progress.report(0.9, "Joining faces");
        const TopoDS_Shape simple = simplified(result.shape, solids);
        // Joining is a convenience: where it spoils the shape, the shape stays as it was.
        if (!simple.IsNull())
          result.shape = combiner.finished(simple);
        else
          result.warnings.emplace_back("Faces of one surface could not be joined; the shape has more faces than it needs.");
        return result;
      });
}

}  // namespace blossom::modeling
