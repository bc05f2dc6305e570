#pragma once
#include <memory>

#include "core/progress.h"
#include "geometry/mesh/mesh.h"
#include "kernel/limit_shape.h"
#include "kernel/scheme.h"

namespace blossom::subdivision {

/// The limit surface of a cage. Every quad (every triangle for Loop) is a patch, other polygons have one patch per corner.
/// Regular patches are exact; around extraordinary points and semi-sharp features the surface is subdivided ten levels
/// before it is approximated, so that the approximation covers a millionth of the face.
class LimitSurface final : public LimitShape {
 public:
  /// @pre `checkCage` accepts the cage; no reference to it is kept. O(n). @throws Error Cancelled.
  LimitSurface(const Mesh& cage, Scheme, const Progress& = Progress::none());
  /// Only the marked faces; the others must not be evaluated. O(n), with a small constant for faces that are not marked.
  LimitSurface(const Mesh& cage, Scheme, const std::vector<bool>& faces, const Progress&);
  ~LimitSurface() override;
  LimitSurface(const LimitSurface&) = delete;
  LimitSurface& operator=(const LimitSurface&) = delete;

  [[nodiscard]] Domain domain(int patch) const override;
  [[nodiscard]] Row row(const Foot&) const override;
  [[nodiscard]] Frame frame(const Foot&, std::span<const Vec3> points) const override;
  [[nodiscard]] std::vector<Foot> seeds() const override;
  [[nodiscard]] std::vector<std::pair<int, int>> edges() const override;
  [[nodiscard]] bool isCurve() const override { return false; }
  /// Foot of corner k of face f.
  [[nodiscard]] Foot cornerFoot(std::size_t face, std::size_t k) const;
  [[nodiscard]] std::size_t patchCount() const;
  /// Number of faces whose limit surface was computed.
  [[nodiscard]] std::size_t madeFaces() const;
  /// The control points that influence a patch.
  [[nodiscard]] std::vector<int> controlPoints(int patch) const;
  /// The limit point of corner k of face f.
  [[nodiscard]] Row cornerRow(std::size_t face, std::size_t k) const;

 private:
  struct Data;
  std::unique_ptr<Data> data_;
};

}  // namespace blossom::subdivision
