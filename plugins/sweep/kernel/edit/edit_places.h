#pragma once
#include <array>
#include <functional>
#include <span>
#include <vector>

#include "core/progress.h"
#include "kernel/edit/edit_result.h"
#include "kernel/edit/least_change.h"
#include "kernel/edit/level_surface.h"
#include "kernel/edit/motion_symmetry.h"
#include "kernel/edit/seam_v.h"

namespace blossom::sweep {

/// A place to be edited, or a copy of one by symmetry.
struct EditPlace {
  MotionPlace at;        ///< inside the domain
  Eigen::Matrix3d turn;  ///< what becomes of vectors from t(v)
  std::size_t of = 0;    ///< index of the place of the edit
  std::vector<Unreached> obstacles = {};
  bool contradicted = false;  ///< another place of the edit lies there and is to go elsewhere
};

/// The places and pins of an edit with their copies, as rows of the factors, and the motion while it is edited. What pulls
/// and twists share. A motion that closes in v stays closed there, as smooth as it was (kernel/edit/seam_v.h).
class EditPlaces {
 public:
  /// @throws Error InvalidParameter for no place, a place outside the domain, a fold outside 1 .. 360 or a level outside
  /// coarsestLevel .. finestLevel; LimitExceeded above 400 places, pins and copies; as symmetricPlaces; Degenerate where the
  /// orientation vanishes.
  EditPlaces(const Motion&, std::span<const MotionPlace> at, std::span<const MotionPlace> pins, const EditSymmetry&,
             int level, const Progress&);

  /// Changes the value of a factor by `wanted(place)` at every place; pins stay. `wanted` sees the motion before the change.
  /// At a finer level the factor gets the knots for it, and the motion remembers its base knots; at a coarser one, poles
  /// change as functions with fewer knots do.
  /// @throws Error LimitExceeded when a factor would get more than a million poles.
  void changeTrajectory(const std::function<Vec3(EditPlace&)>& wanted);
  void changeOrientation(const std::function<Vec4(EditPlace&)>& wanted);
  void changeScaling(const std::function<Vec4(EditPlace&)>& wanted);

  [[nodiscard]] const Motion& motion() const { return result_.motion; }
  [[nodiscard]] const std::vector<EditPlace>& places() const { return places_; }
  /// Marks places of the edit that lie at one spot, where `differ(i, j)` says that they are to go to different points.
  void markContradictions(const std::function<bool(std::size_t, std::size_t)>& differ);

  /// The result; a place has arrived when at most `allowed` of it is `left`. @param otherwise the reason when there is no
  /// other  @throws Error Degenerate where what is left is no number
  EditResult finished(const std::function<double(const EditPlace&)>& left, double allowed, Unreached otherwise);

 private:
  template <class Row>
  PoleChange changeOf(Row row, const SeamV&, const Eigen::MatrixXd& wanted);
  void changeSurface(Surface& factor, double closure, const SeamV&, const std::array<std::vector<double>, 2>& base,
                     const Eigen::MatrixXd& wanted);
  void remember();
  [[nodiscard]] std::vector<MotionPlace> spots() const;
  template <class Vector>
  Eigen::MatrixXd wantedAt(const std::function<Vector(EditPlace&)>& wanted);

  EditResult result_;
  std::vector<EditPlace> places_;
  std::vector<MotionPlace> given_, pins_;
  MotionSeams seams_;
  EditLevel level_;
  BaseKnots base_;                     ///< of the motion given
  bool own_;                           ///< functions of the level are those of the factors as they are
  bool symmetric_, together_ = false;  ///< together_: the last change could not give every place what it wanted
  Progress progress_;
};

}  // namespace blossom::sweep
