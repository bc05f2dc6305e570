#include "kernel/refiner.h"

#include <fmt/format.h>
#include <opensubdiv/far/topologyDescriptor.h>

#include <algorithm>
#include <sstream>

#include "core/error.h"

namespace blossom::subdivision {
namespace {

using namespace OpenSubdiv;

Sdc::Options::VtxBoundaryInterpolation boundaryRule(const std::string& value) {
  if (value == "1") return Sdc::Options::VTX_BOUNDARY_EDGE_AND_CORNER;
  if (value == "2") return Sdc::Options::VTX_BOUNDARY_EDGE_ONLY;
  throw Error(ErrorCode::InvalidInput, fmt::format("The cage asks for the boundary rule {}, which is not known.", value),
              "The tag interpolateboundary takes 1, which keeps corners, or 2, which rounds them.");
}

Sdc::Options optionsOf(const Mesh& mesh) {
  Sdc::Options options;
  options.SetVtxBoundaryInterpolation(Sdc::Options::VTX_BOUNDARY_EDGE_AND_CORNER);
  for (const std::string& tag : mesh.otherTags) {
    std::istringstream words(tag);
    std::string t, name, counts, value;
    words >> t >> name >> counts >> value;
    if (name == "interpolateboundary") options.SetVtxBoundaryInterpolation(boundaryRule(value));
    if (name == "creasemethod" && value == "chaikin") options.SetCreasingMethod(Sdc::Options::CREASE_CHAIKIN);
  }
  return options;
}

/// OpenSubdiv wants sharpness as float, 10 at most.
float sharpnessOf(double sharpness) { return static_cast<float>(std::min(sharpness, 10.0)); }

}  // namespace

std::unique_ptr<Far::TopologyRefiner> makeRefiner(const Mesh& mesh, Scheme scheme) {
  std::vector<int> sizes, pairs, vertices;
  std::vector<float> creases, corners;
  for (std::size_t f = 0; f < mesh.faceCount(); ++f) sizes.push_back(static_cast<int>(mesh.face(f).size()));
  for (const Crease& crease : mesh.creases) {
    pairs.insert(pairs.end(), {crease.from, crease.to});
    creases.push_back(sharpnessOf(crease.sharpness));
  }
  for (const Corner& corner : mesh.corners) {
    vertices.push_back(corner.vertex);
    corners.push_back(sharpnessOf(corner.sharpness));
  }
  Far::TopologyDescriptor descriptor;
  descriptor.numVertices = static_cast<int>(mesh.points.size());
  descriptor.numFaces = static_cast<int>(mesh.faceCount());
  descriptor.numVertsPerFace = sizes.data();
  descriptor.vertIndicesPerFace = mesh.faceVertices.data();
  descriptor.numCreases = static_cast<int>(creases.size());
  descriptor.creaseVertexIndexPairs = pairs.data();
  descriptor.creaseWeights = creases.data();
  descriptor.numCorners = static_cast<int>(corners.size());
  descriptor.cornerVertexIndices = vertices.data();
  descriptor.cornerWeights = corners.data();
  using Factory = Far::TopologyRefinerFactory<Far::TopologyDescriptor>;
  const Sdc::SchemeType type = scheme == Scheme::Loop ? Sdc::SCHEME_LOOP : Sdc::SCHEME_CATMARK;
  std::unique_ptr<Far::TopologyRefiner> refiner(Factory::Create(descriptor, Factory::Options(type, optionsOf(mesh))));
  if (!refiner)
    throw Error(ErrorCode::InvalidInput, "OpenSubdiv does not accept the topology of the cage.",
                "Look for faces that share an edge in an unusual way.");
  return refiner;
}

}  // namespace blossom::subdivision
