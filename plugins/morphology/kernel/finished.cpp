#include "kernel/finished.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include "core/error.h"
#include "geometry/mesh/mesh_crossing.h"
#include "geometry/mesh/mesh_topology.h"
#include "geometry/shape/bounds.h"
#include "kernel/coplanar.h"
#include "kernel/flatness.h"
#include "kernel/in_order.h"
#include "kernel/manifold.h"
#include "kernel/plane_triangles.h"
#include "kernel/self_crossing.h"
#include "kernel/separated.h"
#include "kernel/side_by_side.h"
#include "kernel/slivers.h"

namespace blossom::morphology {

namespace {

Mesh movedFrom(Mesh mesh, const Vec3& centre) {
  for (Vec3& p : mesh.points) p += centre;
  return mesh;
}

/// Without corners that repeat the one before, and without ways there and back again.
std::vector<int> withoutSpikes(std::vector<int> face) {
  for (std::size_t k = 0; k < face.size() && face.size() > 2;) {
    const std::size_t n = face.size(), next = (k + 1) % n, after = (k + 2) % n;
    if (face[k] == face[next]) {
      face.erase(face.begin() + static_cast<std::ptrdiff_t>(next));
      k = 0;
    } else if (face[k] == face[after]) {
      face.erase(face.begin() + static_cast<std::ptrdiff_t>(std::max(next, after)));
      face.erase(face.begin() + static_cast<std::ptrdiff_t>(std::min(next, after)));
      k = 0;
    } else {
      ++k;
    }
  }
  return face;
}

std::vector<int> fromLowestNumber(std::vector<int> face) {
  std::rotate(face.begin(), std::min_element(face.begin(), face.end()), face.end());
  return face;
}

/// Faces over shared points: equal places are one vertex, and faces that have lost their area that way are gone, as are two
/// that lie on each other back to back.
Mesh collapsed(const Mesh& mesh) {
  Mesh shared;
  std::map<std::array<double, 3>, int> numbers;
  std::vector<int> number;
  for (const Vec3& p : mesh.points) {
    const auto [at, fresh] =
        numbers.try_emplace({p.x() + 0.0, p.y() + 0.0, p.z() + 0.0}, static_cast<int>(shared.points.size()));
    if (fresh) shared.points.push_back(p);
    number.push_back(at->second);
  }
  std::map<std::vector<int>, int> balance;  // how often a face turns one way more than the other
  for (std::size_t f = 0; f < mesh.faceCount(); ++f) {
    std::vector<int> face;
    for (const int v : mesh.face(f)) face.push_back(number[static_cast<std::size_t>(v)]);
    face = withoutSpikes(std::move(face));
    if (face.size() < 3) continue;
    std::vector<int> one = fromLowestNumber(face), other = fromLowestNumber({face.rbegin(), face.rend()});
    if (one <= other)
      ++balance[std::move(one)];
    else
      --balance[std::move(other)];
  }
  for (const auto& [face, times] : balance) {
    for (int k = 0; k < times; ++k) shared.addFace(face);
    for (int k = 0; k < -times; ++k) shared.addFace(std::vector<int>(face.rbegin(), face.rend()));
  }
  return shared;
}

/// Corners that follow each other have places of their own.
bool everyEdgeHasLength(const Mesh& mesh) {
  for (std::size_t f = 0; f < mesh.faceCount(); ++f) {
    const auto corners = facePoints(mesh, f);
    for (std::size_t k = 0; k < corners.size(); ++k)
      if (corners[k] == corners[(k + 1) % corners.size()]) return false;
  }
  return true;
}

/// The face as triangles between its corners, or as it is where that fails.
void addSplit(const Mesh& mesh, std::size_t face, Mesh& result) {
  const std::vector<int> corners(mesh.face(face).begin(), mesh.face(face).end());
  const auto triangles = trianglesBetween(mesh.points, {corners}, vectorArea(facePoints(mesh, face)));
  if (triangles.size() != corners.size() - 2) {
    result.addFace(corners);
    return;
  }
  for (const auto& triangle : triangles) result.addFace(triangle);
}

template <class Which>
Mesh withSplit(const Mesh& mesh, const Which& which) {
  Mesh result;
  result.points = mesh.points;
  for (std::size_t f = 0; f < mesh.faceCount(); ++f)
    if (mesh.face(f).size() > 3 && which(f))
      addSplit(mesh, f, result);
    else
      result.addFace(mesh.face(f));
  return result;
}

/// Looks at ways to write one surface down until one crosses nowhere.
class Attempts {
 public:
  Attempts(const Vec3& centre, const Progress& progress) : centre_(centre), progress_(progress) {}

  [[nodiscard]] std::optional<Mesh> asIs(const Mesh& mesh) {
    crossing_.reset();
    if (mesh.faceCount() == 0) return std::nullopt;
    Mesh there = movedFrom(mesh, centre_);
    if (!everyEdgeHasLength(there)) return std::nullopt;
    bool isClosed = false, isTwisted = false;
    sideBySide(
        progress_, [&] { crossing_ = firstCrossing(there, progress_); },
        [&] {
          isClosed = meshTopology(mesh).closed();
          isTwisted = isClosed && firstTwistedEdge(there, progress_);
        });
    if (!isClosed) crossing_.reset();
    if (!isClosed || crossing_ || isTwisted) return std::nullopt;
    return there;
  }

  /// Polygons that cross something are split: their triangles may run otherwise than those their readers make.
  [[nodiscard]] std::optional<Mesh> withFewerPolygons(Mesh mesh) {
    constexpr int maximumRounds = 8;
    for (int round = 0; round <= maximumRounds; ++round) {
      if (auto made = asIs(mesh)) return made;
      if (!crossing_) return std::nullopt;
      const std::size_t before = mesh.faceCount();
      const auto isHit = [&](std::size_t f) { return f == crossing_->first || f == crossing_->second; };
      mesh = withSplit(mesh, [&](std::size_t f) { return round == maximumRounds || isHit(f); });
      if (mesh.faceCount() == before) return std::nullopt;
    }
    return asIs(mesh);
  }

  [[nodiscard]] const std::optional<MeshCrossing>& crossing() const { return crossing_; }

 private:
  const Vec3& centre_;
  const Progress& progress_;
  std::optional<MeshCrossing> crossing_;
};

/// Corners on a grid, in the user's coordinates.
Mesh snappedTo(Mesh mesh, const Vec3& centre, double step, const Progress& progress) {
  for (Vec3& p : mesh.points)
    for (int k = 0; k < 3; ++k) p[k] = step * std::nearbyint((p[k] + centre[k]) / step) - centre[k];
  return manifoldOf(collapsed(mesh), progress);
}

/// Triangles, those without area flipped or collapsed; nothing when that is impossible.
std::optional<Mesh> mended(const Mesh& mesh, const Progress& progress) {
  if (mesh.faceCount() == 0 || !meshTopology(mesh).closed()) return std::nullopt;
  try {
    return inOrder(manifoldOf(withoutDegenerate(triangulated(mesh, progress).first, {"The result"}), progress));
  } catch (const Error& error) {
    if (error.code() != ErrorCode::InvalidInput) throw;
    return std::nullopt;
  }
}

/// Rounds a surface to coarser and coarser grids until one crosses nowhere.
class Rounding {
 public:
  Rounding(const Vec3& centre, Attempts& attempts, const Progress& progress)
      : centre_(centre), attempts_(attempts), progress_(progress) {}

  struct Rounded {
    Mesh mesh;
    double step = 0;
  };
  /// @param forms the same surface, with polygons or triangles
  /// @param bits of the first grid after the finest one, and of the last one
  [[nodiscard]] std::optional<Rounded> from(const std::vector<Mesh>& forms, int finest, int firstBits, int lastBits) {
    for (int bits = firstBits; bits <= lastBits; bits += 2)
      for (const Mesh& form : forms)
        if (auto made = onGrid(form, std::ldexp(1, finest + bits))) return made;
    return std::nullopt;
  }

 private:
  std::optional<Rounded> onGrid(const Mesh& form, double step) {
    const Mesh snapped = inOrder(snappedTo(form, centre_, step, progress_));
    if (auto made = attempts_.withFewerPolygons(snapped)) return Rounded{*std::move(made), step};
    if (const auto whole = mended(snapped, progress_))
      if (auto made = attempts_.asIs(*whole)) return Rounded{*std::move(made), step};
    return std::nullopt;
  }

  const Vec3& centre_;
  Attempts& attempts_;
  const Progress& progress_;
};

std::string movedBySentence(double step) {
  return fmt::format("Corners have been moved by up to {:.2g} mm, so that rounding makes no faces cross.", step);
}

/// With what is nearly one made one; nothing when that does not help.
std::optional<Finished> withNearOnesUnited(const Mesh& triangles, double size, Attempts& attempts,
                                           const Progress& progress) {
  for (const double share : {1e-11, 1e-10, 1e-9}) {
    const double least = share * size;
    const auto apart = separated(triangles, least, progress);
    if (!apart || apart->faceCount() == 0) continue;
    const Mesh whole = inOrder(manifoldOf(*apart, progress));
    if (!meshTopology(whole).closed()) continue;
    const Mesh joined = joinedCoplanar(whole, {.tolerance = 8 * least}, progress);
    if (auto made = attempts.withFewerPolygons(manifoldOf(joined, progress)))
      return Finished{inOrder(*made), movedBySentence(2 * least)};
    if (auto made = attempts.asIs(whole)) return Finished{inOrder(*made), movedBySentence(2 * least)};
  }
  return std::nullopt;
}

constexpr int fewBits = 4, mostBits = 24;  ///< by which grids are coarser than the finest one
constexpr double leastThickness = 1e-12;   ///< of the size: thinner voids and bodies may be turned by rounding

}  // namespace

CannotBeRounded::CannotBeRounded(const std::string& message)
    : Error(ErrorCode::Degenerate, message,
            "Make one shape a little larger or smaller where one just fits the other, or leave out details too small for "
            "their size.") {}

Finished finished(const Mesh& soup, const Vec3& centre, Slivers slivers, const Progress& progress) {
  progress.report(0, "Joining faces");
  const Mesh triangles = inOrder(manifoldOf(soup, progress));
  const double size = bounds(triangles).diagonal();
  bool isClosed = false;
  std::size_t shells = 0;
  Mesh joined;
  sideBySide(
      progress,
      [&] {
        const MeshTopology topology = meshTopology(triangles);
        isClosed = topology.closed();
        shells = topology.components.size();
      },
      [&] { joined = joinedCoplanar(triangles, {.tolerance = joinedFacesFlatness * size}, progress); });
  if (!isClosed) throw Error(ErrorCode::Internal, "The result is not closed.", "Please report the two shapes.");
  if (slivers == Slivers::Go && shells > 1) {
    const Mesh thicker = withoutSlivers(triangles, leastThickness * size, progress);
    const bool isLess = thicker.faceCount() > 0 && thicker.faceCount() < triangles.faceCount();
    if (isLess) return finished(thicker, centre, Slivers::Stay, progress);
  }
  joined = joined.faceCount() == triangles.faceCount() ? triangles : manifoldOf(joined, progress);
  Attempts attempts(centre, progress);
  if (auto made = attempts.withFewerPolygons(joined)) return {inOrder(*made), {}};
  std::optional<MeshCrossing> crossing = attempts.crossing();
  if (auto made = attempts.asIs(triangles)) return {inOrder(*made), {}};
  const int finest = std::ilogb(std::max(size, centre.cwiseAbs().maxCoeff())) - 51;  // two units in the last place
  Rounding rounding(centre, attempts, progress);
  if (auto made = rounding.from({joined, triangles}, finest, 0, fewBits))
    return {inOrder(made->mesh), movedBySentence(made->step)};
  if (auto made = withNearOnesUnited(triangles, size, attempts, progress)) return *std::move(made);
  if (auto made = rounding.from({joined, triangles}, finest, fewBits + 2, mostBits))
    return {inOrder(made->mesh), movedBySentence(made->step)};
  if (attempts.crossing()) crossing = attempts.crossing();
  throw CannotBeRounded(
      crossing ? fmt::format("With corners rounded to numbers of 16 digits the result crosses itself near {}.",
                             Subject{}.place(crossing->place))
               : fmt::format("With corners rounded to numbers of 16 digits nothing closed is left of the result near {}.",
                             Subject{}.place(centre)));
}

std::optional<OnGrid> onCoarserGrid(const Mesh& triangles, double step, const Progress& progress) {
  const Vec3 centre = Vec3::Zero();
  Attempts attempts(centre, progress);
  auto made = Rounding(centre, attempts, progress).from({triangles}, std::ilogb(step), 0, mostBits);
  if (!made) return std::nullopt;
  return OnGrid{triangulated(made->mesh, progress).first, made->step};
}

}  // namespace blossom::morphology
