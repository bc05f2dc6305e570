#include "kernel/limit_surface.h"

#include <opensubdiv/bfr/refinerSurfaceFactory.h>
#include <opensubdiv/bfr/surface.h>

#include <array>

#include "core/error.h"
#include "kernel/refiner.h"

namespace blossom::subdivision {
namespace {

using namespace OpenSubdiv;
using PatchSurface = Bfr::Surface<double>;

constexpr int isolation = 10;

struct Patch {
  int face = 0;
  int part = -1;  ///< which corner of a polygon that is no quad; -1: the whole face
};

}  // namespace

struct LimitSurface::Data {
  std::unique_ptr<Far::TopologyRefiner> refiner;
  std::unique_ptr<Bfr::RefinerSurfaceFactory<>> factory;
  std::vector<PatchSurface> surfaces;  ///< one for each face
  std::vector<Patch> patches;
  std::vector<int> firstPatch;  ///< of each face
  std::size_t made = 0;         ///< faces that have their surface
  Scheme scheme = Scheme::CatmullClark;

  [[nodiscard]] const PatchSurface& surface(std::size_t face) const { return surfaces[face]; }

  [[nodiscard]] std::array<double, 2> coordinates(const Foot& foot) const {
    const Patch& patch = patches[static_cast<std::size_t>(foot.patch)];
    std::array<double, 2> in{foot.u, foot.v}, out = in;
    if (patch.part >= 0)
      surface(static_cast<std::size_t>(patch.face))
          .GetParameterization()
          .ConvertNormalizedSubFaceToCoord(patch.part, in.data(), out.data());
    return out;
  }

  [[nodiscard]] static std::vector<int> indicesOf(const PatchSurface& surface) {
    std::vector<int> indices(static_cast<std::size_t>(surface.GetNumControlPoints()));
    surface.GetControlPointIndices(indices.data());
    return indices;
  }

  [[nodiscard]] static Row rowAt(const PatchSurface& surface, const std::array<double, 2>& uv) {
    const std::vector<int> indices = indicesOf(surface);
    std::vector<double> weights(indices.size());
    surface.EvaluateStencil(uv.data(), weights.data());
    Row row;
    for (std::size_t i = 0; i < indices.size(); ++i) {
      if (weights[i] == 0) continue;
      row.indices.push_back(indices[i]);
      row.weights.push_back(weights[i]);
    }
    return row;
  }
};

LimitSurface::LimitSurface(const Mesh& cage, Scheme scheme, const Progress& progress)
    : LimitSurface(cage, scheme, std::vector<bool>(cage.faceCount(), true), progress) {}

LimitSurface::LimitSurface(const Mesh& cage, Scheme scheme, const std::vector<bool>& faces, const Progress& progress)
    : data_(std::make_unique<Data>()) {
  data_->scheme = scheme;
  data_->refiner = makeRefiner(cage, scheme);
  Bfr::RefinerSurfaceFactory<>::Options options;
  options.SetApproxLevelSmooth(isolation).SetApproxLevelSharp(isolation);
  data_->factory = std::make_unique<Bfr::RefinerSurfaceFactory<>>(*data_->refiner, options);
  data_->surfaces.resize(cage.faceCount());
  const std::size_t whole = scheme == Scheme::Loop ? 3 : 4;
  for (std::size_t f = 0; f < cage.faceCount(); ++f) {
    if (f % 256 == 0) progress.check();
    const int face = static_cast<int>(f);
    if (faces[f]) {
      if (!data_->factory->InitVertexSurface(face, &data_->surfaces[f]))
        throw Error(ErrorCode::InvalidInput, "A face of the cage has no limit surface.", "Look for degenerate faces.");
      ++data_->made;
    }
    const std::size_t size = cage.face(f).size();
    data_->firstPatch.push_back(static_cast<int>(data_->patches.size()));
    if (size == whole)
      data_->patches.push_back({face, -1});
    else
      for (std::size_t part = 0; part < size; ++part) data_->patches.push_back({face, static_cast<int>(part)});
  }
}

LimitSurface::~LimitSurface() = default;

Domain LimitSurface::domain(int) const { return data_->scheme == Scheme::Loop ? Domain::Triangle : Domain::Square; }

Row LimitSurface::row(const Foot& foot) const {
  const Patch& patch = data_->patches[static_cast<std::size_t>(foot.patch)];
  return Data::rowAt(data_->surface(static_cast<std::size_t>(patch.face)), data_->coordinates(foot));
}

Row LimitSurface::cornerRow(std::size_t face, std::size_t k) const {
  const PatchSurface& surface = data_->surface(face);
  std::array<double, 2> uv{};
  surface.GetParameterization().GetVertexCoord(static_cast<int>(k), uv.data());
  return Data::rowAt(surface, uv);
}

std::size_t LimitSurface::patchCount() const { return data_->patches.size(); }
std::size_t LimitSurface::madeFaces() const { return data_->made; }

std::vector<int> LimitSurface::controlPoints(int patch) const {
  return Data::indicesOf(data_->surface(static_cast<std::size_t>(data_->patches[static_cast<std::size_t>(patch)].face)));
}

Foot LimitSurface::cornerFoot(std::size_t face, std::size_t k) const {
  const int first = data_->firstPatch[face];
  if (data_->patches[static_cast<std::size_t>(first)].part >= 0) return {first + static_cast<int>(k), 0, 0};
  if (data_->scheme == Scheme::Loop) return {first, k == 1 ? 1.0 : 0.0, k == 2 ? 1.0 : 0.0};
  return {first, k == 1 || k == 2 ? 1.0 : 0.0, k >= 2 ? 1.0 : 0.0};
}

Frame LimitSurface::frame(const Foot& foot, std::span<const Vec3> points) const {
  const Patch& patch = data_->patches[static_cast<std::size_t>(foot.patch)];
  const PatchSurface& surface = data_->surface(static_cast<std::size_t>(patch.face));
  const std::vector<int> indices = Data::indicesOf(surface);
  const std::size_t n = indices.size();
  std::vector<double> w(6 * n);
  const std::array<double, 2> uv = data_->coordinates(foot);
  surface.EvaluateStencil(uv.data(), &w[0], &w[n], &w[2 * n], &w[3 * n], &w[4 * n], &w[5 * n]);
  Frame frame;
  const std::array<Vec3*, 6> parts{&frame.at, &frame.du, &frame.dv, &frame.duu, &frame.duv, &frame.dvv};
  for (std::size_t k = 0; k < parts.size(); ++k)
    for (std::size_t i = 0; i < n; ++i) *parts[k] += w[k * n + i] * points[static_cast<std::size_t>(indices[i])];
  if (patch.part >= 0) {  // a part of a polygon runs through half of the coordinates of a tile
    frame.du *= 0.5;
    frame.dv *= 0.5;
    frame.duu *= 0.25;
    frame.duv *= 0.25;
    frame.dvv *= 0.25;
  }
  return frame;
}

std::vector<Foot> LimitSurface::seeds() const {
  constexpr std::array<double, 3> square{1.0 / 6, 0.5, 5.0 / 6};
  constexpr std::array<std::array<double, 2>, 6> triangle{{{1.0 / 9, 1.0 / 9},
                                                           {4.0 / 9, 1.0 / 9},
                                                           {7.0 / 9, 1.0 / 9},
                                                           {1.0 / 9, 4.0 / 9},
                                                           {4.0 / 9, 4.0 / 9},
                                                           {1.0 / 9, 7.0 / 9}}};
  std::vector<Foot> feet;
  for (int p = 0; p < static_cast<int>(data_->patches.size()); ++p) {
    if (data_->scheme == Scheme::Loop)
      for (const auto& [u, v] : triangle) feet.push_back({p, u, v});
    else
      for (const double u : square)
        for (const double v : square) feet.push_back({p, u, v});
  }
  return feet;
}

std::vector<std::pair<int, int>> LimitSurface::edges() const {
  std::vector<std::pair<int, int>> list;
  const Far::TopologyLevel& level = data_->refiner->GetLevel(0);
  for (int e = 0; e < level.GetNumEdges(); ++e) {
    const Far::ConstIndexArray ends = level.GetEdgeVertices(e);
    list.emplace_back(ends[0], ends[1]);
  }
  return list;
}

}  // namespace blossom::subdivision
