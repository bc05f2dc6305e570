#pragma once
#include <map>
#include <string>
#include <vector>

#include "feature/feature_type.h"

namespace blossom {

/// What the evaluations of all frames of a sequence tell, told once.
/// - Warnings: those that say the same once, with the frames in front: "Frames 2 to 5 and 9: ..", "Every frame: ..". Of
/// those
///   that differ, twenty are told, and in how many frames there are more.
/// - Statistics and figures: times (NAME_ms) are added up; what is the same in all frames is told as it is; of numbers that
///   differ the least and the greatest, as NAME_least and NAME_most (before the unit: deviation_least_mm); anything else is
///   left out.
class FrameSummary {
 public:
  /// The next frame.
  void add(Evaluated);
  /// Without a shape. O(w log w) for w warnings and figures.
  [[nodiscard]] Evaluated told() const;

 private:
  [[nodiscard]] std::vector<std::string> warnings() const;

  std::size_t frames_ = 0;
  std::map<std::string, std::vector<Value>> stats_;
  std::vector<std::string> figureNames_;  ///< in the order in which they came
  std::map<std::string, std::vector<Measure>> figures_;
  std::vector<std::string> texts_;
  std::map<std::string, std::vector<std::size_t>> warned_;  ///< frames by text
};

}  // namespace blossom
