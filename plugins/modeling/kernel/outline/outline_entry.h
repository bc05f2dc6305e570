#pragma once
#include <array>
#include <optional>
#include <string>

#include "core/units.h"
#include "core/vector.h"

namespace blossom::modeling {

/// Values typed while drawing: "25" (a length), "25<30" (length and angle from the x axis), "10,20" (a position) or "@10,20"
/// (relative to the last point). Lengths may have units and be expressions.
class TypedEntry {
 public:
  explicit TypedEntry(LengthUnit unit = {}) : unit_(std::move(unit)) {}  ///< unit of lengths without one
  [[nodiscard]] const LengthUnit& unit() const { return unit_; }
  [[nodiscard]] bool open() const { return !fields_[0].empty() || !fields_[1].empty() || relative_; }
  /// Whether an entry may begin with this character.
  static bool begins(char);
  /// @returns whether the character was accepted.
  bool type(char);
  bool back();         ///< deletes the last character
  void switchField();  ///< between length and angle
  void clear() { *this = TypedEntry(unit_); }
  [[nodiscard]] std::string text() const;
  [[nodiscard]] bool inAngle() const { return active_ == 1 && !place_; }

  struct Values {
    std::optional<double> length, angle;  ///< mm, degrees
    std::optional<Vec2> place;
    bool relative = false;  ///< `place` is relative to the last point
  };
  /// @throws Error InvalidParameter.
  [[nodiscard]] Values values() const;
  /// Why the values cannot be parsed; empty when they can.
  [[nodiscard]] std::string problem() const;

 private:
  [[nodiscard]] std::string& field() { return fields_.at(static_cast<std::size_t>(active_)); }

  LengthUnit unit_;
  std::array<std::string, 2> fields_;
  int active_ = 0;
  bool place_ = false, relative_ = false;
};

}  // namespace blossom::modeling
