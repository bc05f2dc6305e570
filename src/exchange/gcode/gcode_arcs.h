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

/// Whether the arcs of a program are where its author meant them.
namespace blossom {

/// Collects arcs whose centres are named (I, J), and the places after the point that its words have.
class GcodeArcs {
 public:
  void number(std::string_view written,
              double unit);  ///< "-10.500": a length as it stands in the program, and its unit in mm
  /// An arc, counter-clockwise or not; `named`: its centre is told by I and J rather than by a radius.
  void arc(std::size_t line, const Vec2& from, const Vec2& to, const Vec2& center, bool counterclockwise, bool named);
  /// Any other move in the plane of the arcs; one that stays where it is in it ends the way that arcs join.
  void straight(const Vec2& from, const Vec2& to);

  /// Arcs whose ends lie at different distances from their centre, more than rounding explains; and arcs whose centre lies
  /// close beside one that several others share, or beside one with which the arc joins its neighbours smoothly or is half
  /// or a quarter of a circle: what a slip in a single number leaves where the ends cannot tell.
  /// The first three of them, and how many more there are. @throws Error Cancelled.
  [[nodiscard]] std::vector<std::string> doubts(const Progress&) const;

 private:
  /// The direction of the way at a joint, and how long the move is that it belongs to; none: length 0.
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
  /// mm of one step in the last place that words of this program use.
  [[nodiscard]] double step() const;
  void missedEnds(double step, std::vector<std::pair<std::size_t, std::string>>& found) const;
  /// What holds for an arc as it was meant: ends equally far from the centre, a smooth way at either end, half or a quarter
  /// of a circle.
  struct Trait {
    double off;          ///< mm by which it does not hold
    Vec2 slope;          ///< how that changes with the centre
    double rounding;     ///< mm that rounded numbers explain at most
    bool joint = false;  ///< about the way before or after the arc
  };
  /// First the ends; of the others those that nearly hold.
  [[nodiscard]] std::vector<Trait> traits(const Arc&, double step) const;
  /// The centre for which all of them hold, where it differs in one of its numbers and two of them tell it.
  [[nodiscard]] std::optional<Vec2> meantCenter(const Arc&, double step) const;
  void slips(double step, std::vector<std::pair<std::size_t, std::string>>& found, const Progress&) const;
  void strayCenters(double step, std::vector<std::pair<std::size_t, std::string>>& found, const Progress&) const;

  std::vector<Arc> arcs_;
  Joint last_;                           ///< of the move before
  bool joinsArc_ = false;                ///< .. which was the last arc
  std::array<std::size_t, 8> places_{};  ///< how many words have so many places after the point
  double unit_ = 1;
};

}  // namespace blossom
