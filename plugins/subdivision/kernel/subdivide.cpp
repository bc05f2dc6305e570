#include "kernel/subdivide.h"

#include <fmt/format.h>
#include <opensubdiv/far/primvarRefiner.h>

#include <algorithm>
#include <cmath>

#include "core/error.h"
#include "kernel/cage.h"
#include "kernel/limit_surface.h"
#include "kernel/refiner.h"

namespace blossom::subdivision {
namespace {

using namespace OpenSubdiv;

/// A point as OpenSubdiv interpolates it.
struct Blend {
  Vec3 at = Vec3::Zero();
  void Clear() { at.setZero(); }
  void AddWithWeight(const Blend& other, double weight) { at += weight * other.at; }
};
using Points = std::vector<Blend>;

void checkSize(const Mesh& cage, int levels) {
  if (levels < 0) throw Error(ErrorCode::InvalidParameter, "The number of levels is below 0.", "Give 0 or more.");
  const auto faces = static_cast<double>(cage.faceVertices.size());
  if (levels == 0 || faces * std::pow(4.0, levels - 1) <= kMaximumFaces) return;
  const int most = std::max(0, static_cast<int>(std::floor(std::log(kMaximumFaces / faces) / std::log(4.0))) + 1);
  throw Error(ErrorCode::LimitExceeded,
              fmt::format("{} levels would make more than {} million faces.", levels, kMaximumFaces / 1e6),
              fmt::format("This cage can be refined {} times.", most));
}

/// Faces, and the sharpness that is left, of one level.
Mesh topologyOf(const Far::TopologyLevel& level, const Mesh& cage, const Progress& progress) {
  Mesh mesh;
  mesh.name = cage.name;
  mesh.color = cage.color;
  mesh.otherTags = cage.otherTags;
  for (int f = 0; f < level.GetNumFaces(); ++f) {
    if (f % 65536 == 0) progress.check();
    const Far::ConstIndexArray face = level.GetFaceVertices(f);
    mesh.addFace(std::span(&face[0], static_cast<std::size_t>(face.size())));
  }
  for (int e = 0; e < level.GetNumEdges(); ++e) {
    const Far::ConstIndexArray ends = level.GetEdgeVertices(e);
    if (level.GetEdgeSharpness(e) > 0 && !level.IsEdgeBoundary(e))  // boundaries are sharp without a tag
      mesh.creases.push_back({ends[0], ends[1], static_cast<double>(level.GetEdgeSharpness(e))});
  }
  for (int v = 0; v < level.GetNumVertices(); ++v)
    if (level.GetVertexSharpness(v) > 0) mesh.corners.push_back({v, static_cast<double>(level.GetVertexSharpness(v))});
  return mesh;
}

/// Vertices whose limit masks do not apply yet: they become smooth some levels later, or a face there is no quad.
std::vector<bool> unsettled(const Mesh& mesh, Scheme scheme) {
  std::vector<bool> marked(mesh.points.size());
  const auto mark = [&](int v) { marked[static_cast<std::size_t>(v)] = true; };
  for (const Crease& crease : mesh.creases) {
    if (crease.sharpness >= 10) continue;
    mark(crease.from);
    mark(crease.to);
  }
  for (const Corner& corner : mesh.corners)
    if (corner.sharpness < 10) mark(corner.vertex);
  if (scheme == Scheme::Loop) return marked;
  for (std::size_t f = 0; f < mesh.faceCount(); ++f)
    if (mesh.face(f).size() != 4)
      for (const int v : mesh.face(f)) mark(v);
  return marked;
}

/// One face round each vertex that is marked; the limit point is the same seen from any of them.
std::vector<bool> facesThatTell(const Mesh& mesh, std::vector<bool> vertices) {
  std::vector<bool> faces(mesh.faceCount());
  for (std::size_t f = 0; f < faces.size(); ++f)
    for (const int v : mesh.face(f)) {
      if (!vertices[static_cast<std::size_t>(v)]) continue;
      faces[f] = true;
      vertices[static_cast<std::size_t>(v)] = false;
    }
  return faces;
}

/// @returns how many faces had their limit surface made.
std::size_t moveToLimit(Mesh& mesh, Scheme scheme, const Points& masks, const Progress& progress) {
  std::size_t made = 0;
  std::vector<bool> later = unsettled(mesh, scheme);
  std::vector<Vec3> limit(mesh.points.size());
  for (std::size_t v = 0; v < limit.size(); ++v) limit[v] = masks[v].at;
  if (std::find(later.begin(), later.end(), true) != later.end()) {
    const std::vector<bool> telling = facesThatTell(mesh, later);
    const LimitSurface surface(mesh, scheme, telling, progress);
    made = surface.madeFaces();
    for (std::size_t f = 0; f < mesh.faceCount(); ++f) {
      const auto face = mesh.face(f);
      if (f % 1024 == 0) progress.check();
      if (!telling[f]) continue;
      for (std::size_t k = 0; k < face.size(); ++k)
        if (const auto v = static_cast<std::size_t>(face[k]); later[v]) {
          limit[v] = combined(surface.cornerRow(f, k), mesh.points);
          later[v] = false;
        }
    }
  }
  mesh.points = std::move(limit);
  mesh.creases.clear();  // these are points of the surface, no cage any more
  mesh.corners.clear();
  mesh.otherTags.clear();
  return made;
}

}  // namespace

SubdivideResult subdivide(const Mesh& cage, const SubdivideOptions& options, const Progress& progress) {
  progress.report(0, "Refining");
  checkCage(cage, options.scheme, progress);
  checkSize(cage, options.levels);
  const auto refiner = makeRefiner(cage, options.scheme);
  if (options.levels > 0) {
    Far::TopologyRefiner::UniformOptions uniform(options.levels);
    uniform.fullTopologyInLastLevel = true;
    refiner->RefineUniform(uniform);
  }
  const Far::PrimvarRefinerReal<double> primvar(*refiner);
  Points points(cage.points.size());
  for (std::size_t i = 0; i < points.size(); ++i) points[i].at = cage.points[i];
  for (int level = 1; level <= options.levels; ++level) {
    progress.report(0.4 + 0.4 * level / (options.levels + 1), "Refining");
    Points finer(static_cast<std::size_t>(refiner->GetLevel(level).GetNumVertices()));
    primvar.Interpolate(level, points, finer);
    points = std::move(finer);
  }
  progress.report(0.8, "Refining");
  SubdivideResult result{topologyOf(refiner->GetLevel(options.levels), cage, progress)};
  result.mesh.points.resize(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) result.mesh.points[i] = points[i].at;
  if (options.limit) {
    Points limit(points.size());
    primvar.Limit(points, limit);
    result.limitSurfaces = moveToLimit(result.mesh, options.scheme, limit, progress);
  }
  progress.report(1, "Refining");
  return result;
}

}  // namespace blossom::subdivision
