#pragma once
#include <array>
#include <optional>
#include <string>

#include "core/units.h"
#include "core/vector.h"

namespace blossom::modeling {

/// What a user types while drawing: "25" (a length), "25<30" (length and angle from the x axis), "10,20" (a place) or
/// "@10,20" (from the last point). Lengths take units and expressions, as every length does.
class TypedEntry {
 public:
  explicit TypedEntry(LengthUnit unit = {}) : unit_(std::move(unit)) {}  ///< of lengths without one
  [[nodiscard]] const LengthUnit& unit() const { return unit_; }
  [[nodiscard]] bool open() const { return !fields_[0].empty() || !fields_[1].empty() || relative_; }
  /// May this character begin an entry?
  static bool begins(char);
  /// @returns whether the character was taken.
  bool type(char);
  bool back();         ///< takes the last character away
  void switchField();  ///< between length and angle
  void clear() { *this = TypedEntry(unit_); }
  [[nodiscard]] std::string text() const;
  [[nodiscard]] bool inAngle() const { return active_ == 1 && !place_; }

  struct Values {
    std::optional<double> length, angle;  ///< mm, degrees
    std::optional<Vec2> place;
    bool relative = false;  ///< the place counts from the last point
  };
  /// @throws Error InvalidParameter.
  [[nodiscard]] Values values() const;
  /// The values, or why they are not understood.
  [[nodiscard]] std::string problem() const;

 private:
  [[nodiscard]] std::string& field() { return fields_.at(static_cast<std::size_t>(active_)); }

  LengthUnit unit_;
  std::array<std::string, 2> fields_;
  int active_ = 0;
  bool place_ = false, relative_ = false;
};

}  // namespace blossom::modeling
