#pragma once
#include <QCoreApplication>
#include <array>
#include <optional>

#include "manipulators/insert_edit.h"
#include "ui/tools/typed_text.h"

namespace blossom::sweep {

/// The goal of an edit while it is typed: the coordinates "x, y, z" of a point, of which one left empty stays as it was, or
/// the angle of a twist. Units, expressions and named numbers as in any field.
class GoalEntry {
  Q_DECLARE_TR_FUNCTIONS(blossom::sweep::GoalEntry)
 public:
  static GoalEntry ofPoint(const ui::ToolHost&, const Vec3& present);
  static GoalEntry ofAngle(double presentDegrees);

  /// As of a text that is typed; Tab goes on to the next coordinate.
  ui::TypedKey key(const QKeyEvent& event);

  struct Goal {
    Vec3 point = Vec3::Zero();
    double angle = 0;
    Value written;  ///< what a document keeps of it
  };
  /// Coordinates that are not typed yet stay as they are. @throws Error InvalidParameter saying what is wrong with the text.
  [[nodiscard]] Goal goalSoFar(const ui::ToolHost&) const;
  /// @throws Error as goalSoFar, and where coordinates are missing.
  [[nodiscard]] Goal goal(const ui::ToolHost&) const;

  [[nodiscard]] bool isAngle() const { return angle_; }
  [[nodiscard]] bool unchanged() const { return text_.unchanged(); }
  [[nodiscard]] const ui::TypedText& text() const { return text_; }

 private:
  [[nodiscard]] Goal pointGoal(const ui::ToolHost&) const;

  ui::TypedText text_;
  Vec3 present_ = Vec3::Zero();
  bool angle_ = false;
};

}  // namespace blossom::sweep
