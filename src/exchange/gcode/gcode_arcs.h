#pragma once
#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/progress.h"
#include "core/vector.h"

/// Check of the arcs of a program for mistakes in their centres.
namespace blossom {

/// Collects the arcs of a program, and the numbers of decimals that it uses.
class GcodeArcs {
 public:
  void number(std::string_view written,
              double unit);  ///< a length as written, "-10.500", and its unit in mm
  /// Adds an arc. @param named the centre is given by I and J instead of a radius
  void arc(std::size_t line, const Vec2& from, const Vec2& to, const Vec2& center, bool counterclockwise, bool named);
  /// Adds any other move in the plane of the arcs. A move without a component in that plane interrupts the path.
  void straight(const Vec2& from, const Vec2& to);

  /// Reports arcs whose ends are at different distances from the centre, by more than rounding explains; and arcs whose
  /// centre is slightly off a centre shared by several others, or off the centre for which the arc would join its neighbours
  /// smoothly or be half or a quarter of a circle. Such arcs come from a slip in a single number. Returns sentences for the
  /// first three, and one with the number of all others. @throws Error Cancelled.
  [[nodiscard]] std::vector<std::string> doubts(const Progress&) const;

 private:
  /// Direction of the path at a joint, and length of the move; length 0 means none.
  struct Joint {
    Vec2 direction = Vec2::Zero();
    double length = 0;
  };
  struct Arc {
    std::size_t line;
    Vec2 from, to, center;
    bool named;
    double sweep;  ///< radians, above 0
    Joint before = {}, after = {};
    [[nodiscard]] double begins() const { return (from - center).norm(); }
    [[nodiscard]] double ends() const { return (to - center).norm(); }
  };
  void join(const Joint& begins);
  /// mm, smallest step in the last decimal used in this program.
  [[nodiscard]] double step() const;
  void missedEnds(double step, std::vector<std::pair<std::size_t, std::string>>& found) const;
  /// A property of an intended arc: ends at equal distances from the centre, a smooth path at either end, half or a quarter
  /// of a circle.
  struct Trait {
    double off;          ///< mm, deviation from the property
    Vec2 slope;          ///< gradient of the deviation with respect to the centre
    double rounding;     ///< mm, maximum deviation that rounded numbers explain
    bool joint = false;  ///< the property concerns the path before or after the arc
  };
  /// First the property of the ends, then those of the others that nearly hold.
  [[nodiscard]] std::vector<Trait> traits(const Arc&, double step) const;
  /// The centre for which all properties hold, when it differs in only one coordinate (of an arc given by R: along the
  /// bisector of its chord) and at least two properties determine it.
  [[nodiscard]] std::optional<Vec2> meantCenter(const Arc&, double step) const;
  static std::string movedSentence(const Arc&, const Vec2& meant);
  void slips(double step, std::vector<std::pair<std::size_t, std::string>>& found, const Progress&) const;
  void strayCenters(double step, std::vector<std::pair<std::size_t, std::string>>& found, const Progress&) const;

  std::vector<Arc> arcs_;
  Joint last_;                           ///< of the move before
  bool joinsArc_ = false;                ///< .. which was the last arc
  std::array<std::size_t, 8> places_{};  ///< number of words by their number of decimals
  double unit_ = 1;
};

}  // namespace blossom
