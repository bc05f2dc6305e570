#pragma once
#include <QCoreApplication>
#include <QString>
#include <array>
#include <optional>

#include "geometry/shape/motion_edit.h"

namespace blossom::sweep {

/// What the next drag on the surface does. Keys change it; it lasts until they do so again, for all surfaces of a document.
class PullMode {
  Q_DECLARE_TR_FUNCTIONS(blossom::sweep::PullMode)
 public:
  PullMode() = default;
  /// What an edit that is there does; of a twist, whose axis is its own, the axis is left out.
  explicit PullMode(const MotionEdit&);

  /// The axis of a twist, through the trajectory: along it, towards the point, or across both.
  enum class Axis { Tangent, Arm, Across };

  [[nodiscard]] const EditSymmetry& symmetry() const { return symmetry_; }
  [[nodiscard]] Axis axis() const { return axis_; }
  /// How wide a part the drag changes, as in MotionPull.
  [[nodiscard]] int level() const { return level_; }
  [[nodiscard]] bool twists() const { return twists_; }
  /// Whether it pulls by turning and scaling, as it does before any key.
  [[nodiscard]] bool isPlain() const { return !twists_ && shares_ == turnAndScale; }
  /// The shares of a pull, the last one above 0 being 1; all 0 for a twist.
  [[nodiscard]] PullWeights weights() const;

  /// T, R, S, W: that way alone, or turning and scaling again when it was already; A: the next axis of a twist; 1 to 9:
  /// copies; M: mirror; + and -: a finer and a coarser level; 0: the motion's own. @returns whether the key is one of these
  bool key(int key);
  /// T, R, S: that way beside the others, or no longer; one of them stays. Sections that move leave half of the way to the
  /// others. @returns as key
  bool keyWithShift(int key);
  /// Tenths of the share that `adjustable` names. @returns whether there is one
  bool addTenths(int tenths);
  /// The letter of the share that can be set: that of the key pressed last, or the first one. The last of the shares has no
  /// choice, for it goes the rest of the way; empty where there is no other.
  [[nodiscard]] QString adjustable() const;

  [[nodiscard]] QString wayText() const;       ///< "by turning and scaling"
  [[nodiscard]] QString axisText() const;      ///< "the tangent of the trajectory"
  [[nodiscard]] QString symmetryText() const;  ///< "4 copies, mirrored"; empty: none
  [[nodiscard]] QString levelText() const;     ///< "2 levels finer"; empty: level 0

 private:
  enum Share : std::size_t { Translate, Rotate, Scale };
  using Shares = std::array<double, 3>;
  static constexpr Shares turnAndScale{0, 1, 1};

  static std::optional<Share> shareOfKey(int key);
  [[nodiscard]] std::size_t lastShare() const;
  [[nodiscard]] bool only(Share) const;
  [[nodiscard]] std::optional<std::size_t> adjustableShare() const;

  bool twists_ = false;
  Shares shares_ = turnAndScale;
  std::optional<Share> named_;  ///< by the key pressed last
  Axis axis_ = Axis::Tangent;
  EditSymmetry symmetry_;
  int level_ = 0;
};

}  // namespace blossom::sweep
