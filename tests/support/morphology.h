#pragma once
#include "morphology/kernel/morphology.h"
#include "support/polyhedra.h"

/// Morphology of meshes in one word each.
namespace blossom::test {

constexpr double tiny = 1e-9;  // relative, of volumes

inline morphology::Operand bodyOf(const Mesh& mesh) { return morphology::operandOf(mesh, {.name = "The solid"}); }
inline Mesh solidSumOf(const Mesh& a, const Mesh& b) { return morphology::solidSum(bodyOf(a), bodyOf(b)).solids.front(); }
inline Mesh solidDifferenceOf(const Mesh& a, const Mesh& b) {
  return morphology::solidDifference(bodyOf(a), bodyOf(b)).solids.front();
}
inline Mesh openingOf(const Mesh& a, const Mesh& b) { return morphology::solidOpening(bodyOf(a), bodyOf(b)).solids.front(); }
inline Mesh closingOf(const Mesh& a, const Mesh& b) { return morphology::solidClosing(bodyOf(a), bodyOf(b)).solids.front(); }
/// The in-between solids with these weights of the second one.
inline morphology::MorphologyResult morphOf(const Mesh& a, const Mesh& b, const std::vector<double>& weights) {
  std::vector<std::vector<double>> rows;
  for (const double w : weights) rows.push_back({1 - w, w});
  return morphology::solidMorph({bodyOf(a), bodyOf(b)}, rows);
}
inline Mesh ballOf(double radius, int subdivisions = 1) { return morphology::ball({radius, subdivisions}).mesh; }

}  // namespace blossom::test
