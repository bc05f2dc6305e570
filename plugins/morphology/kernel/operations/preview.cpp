#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "core/error.h"
#include "geometry/mesh/mesh_topology.h"
#include "geometry/shape/bounds.h"
#include "kernel/manifold.h"
#include "kernel/morphology.h"
#include "kernel/operations/work.h"
#include "kernel/preview/field_sum.h"
#include "kernel/solid_check.h"
#include "kernel/turned_shells.h"

namespace blossom::morphology {

namespace {

/// An operand with its weight, about its own middle.
struct WeightedShape {
  Mesh triangles;
  std::vector<std::vector<Vec3>> pieces;
  double weight = 1;
  Vec3 middle = Vec3::Zero();
};

WeightedShape centred(const Operand& operand, double weight, const Progress& progress) {
  if (operand.form == Operand::Form::Body) refuseUnusable(operand.mesh, {operand.name});
  CheckedSolid solid{triangulated(operand.mesh, progress).first, {}};
  if (solid.triangles.faceCount() > 0) turnOutwards(solid, {operand.name}, progress);
  WeightedShape shape{std::move(solid.triangles), operand.pieces, weight, operand.bounds().center()};
  for (Vec3& p : shape.triangles.points) p -= shape.middle;
  for (auto& piece : shape.pieces)
    for (Vec3& p : piece) p -= shape.middle;
  return shape;
}

}  // namespace

MorphologyResult previewOfSum(const std::vector<Operand>& shapes, const std::vector<double>& weights, int cells,
                              const MorphOptions& options, const Progress& progress) {
  std::vector<WeightedShape> terms;
  Vec3 middle = Vec3::Zero();
  double volume = 0;
  for (std::size_t k = 0; k < shapes.size(); ++k) {
    if (!(weights[k] > 0)) continue;
    terms.push_back(centred(shapes[k], weights[k], progress));
    middle += weights[k] * terms.back().middle;
    volume += weights[k] * signedVolume(terms.back().triangles);
  }
  const auto solid = std::find_if(terms.begin(), terms.end(), [](const auto& t) { return t.triangles.faceCount() > 0; });
  if (solid == terms.end())
    throw Error(ErrorCode::InvalidInput, "None of the shapes is a solid.", "Choose a solid or a closed mesh.");
  std::iter_swap(terms.begin(), solid);
  Mesh made = terms.front().triangles;
  for (Vec3& p : made.points) p *= terms.front().weight;
  for (std::size_t k = 1; k < terms.size(); ++k) {
    const double share = 1.0 / static_cast<double>(terms.size() - 1), from = share * static_cast<double>(k - 1);
    made = triangulated(fieldSum({made, {}, 1}, {terms[k].triangles, terms[k].pieces, terms[k].weight}, cells,
                                 progress.part(from, from + share)))
               .first;
  }
  const double cell = (bounds(made).high - bounds(made).low).maxCoeff() / cells;
  const double own = signedVolume(made), factor = options.volumePreserving && own > 0 ? std::cbrt(volume / own) : 1;
  for (Vec3& p : made.points) p = middle + factor * p;
  made = manifoldOfTriangles(made, progress);
  MorphologyResult result{{std::move(made)}, {}, {}};
  result.stats.way = Way::Field;
  result.warnings.push_back(
      fmt::format("This is a preview on a grid of {} along its longest side: it is off by about {:.2g} mm.", cells, cell));
  return result;
}

}  // namespace blossom::morphology
