#pragma once
#include <QCoreApplication>
#include <QString>

#include "geometry/shape/motion_edit.h"

namespace blossom::sweep {

/// What the next drag on the surface does. Keys change it; it lasts until they do so again, for all surfaces of a document.
class PullMode {
  Q_DECLARE_TR_FUNCTIONS(blossom::sweep::PullMode)
 public:
  /// Combined: turns towards the target and scales for the rest.
  enum class Way { Combined, Translate, Rotate, Scale, Twist };
  /// The axis of a twist, through the trajectory: along it, towards the point, or across both.
  enum class Axis { Tangent, Arm, Across };

  [[nodiscard]] Way way() const { return way_; }
  [[nodiscard]] const EditSymmetry& symmetry() const { return symmetry_; }
  [[nodiscard]] Axis axis() const { return axis_; }
  /// How wide a part the drag changes, as in MotionPull.
  [[nodiscard]] int level() const { return level_; }
  [[nodiscard]] bool twists() const { return way_ == Way::Twist; }
  /// The shares of a pull; all 0 for a twist.
  [[nodiscard]] PullWeights weights() const;

  /// T, R, S, W: that way alone, or combined again when it was already; A: the next axis of a twist; 1 to 9: copies; M:
  /// mirror; + and -: a finer and a coarser level; 0: the motion's own. @returns whether the key is one of these
  bool key(int key);

  [[nodiscard]] QString wayText() const;       ///< "by turning and scaling"
  [[nodiscard]] QString axisText() const;      ///< "the tangent of the trajectory"
  [[nodiscard]] QString symmetryText() const;  ///< "4 copies, mirrored"; empty: none
  [[nodiscard]] QString levelText() const;     ///< "2 levels finer"; empty: level 0

 private:
  Way way_ = Way::Combined;
  Axis axis_ = Axis::Tangent;
  EditSymmetry symmetry_;
  int level_ = 0;
};

}  // namespace blossom::sweep
