#pragma once
#include <cstddef>
#include <vector>

#include "parameter/value.h"

namespace blossom::minkowski {

/// The key points of a path through the arguments of a blossom, as the pad edits them: never none, for without a path the
/// morph runs along the diagonal.
class PathPoints {
 public:
  using Point = std::vector<double>;

  /// @param path the parameter of the morph; what has other than `arguments` numbers is left out
  PathPoints(const Value& path, std::size_t arguments);

  /// As the parameter has it; nothing for the diagonal.
  [[nodiscard]] Value written() const;
  [[nodiscard]] const std::vector<Point>& points() const { return points_; }
  [[nodiscard]] std::size_t arguments() const { return arguments_; }
  /// From the first point of the diagonal straight to its last.
  [[nodiscard]] bool isDiagonal() const { return points_ == diagonal(); }
  /// u of a point, 0 to 1.
  [[nodiscard]] double placeOf(std::size_t point) const;
  [[nodiscard]] Point at(double u) const;

  void set(std::size_t point, std::size_t argument, double value);  ///< kept in 0..1
  void insert(std::size_t before, Point);
  /// Without one of the last two there is no path: the diagonal is back.
  void remove(std::size_t point);
  friend bool operator==(const PathPoints&, const PathPoints&) = default;

 private:
  [[nodiscard]] std::vector<Point> diagonal() const;

  std::size_t arguments_;
  std::vector<Point> points_;
};

}  // namespace blossom::minkowski
