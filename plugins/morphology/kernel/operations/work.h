#pragma once
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/progress.h"
#include "core/stopwatch.h"
#include "kernel/arrangement/arranged_sum.h"
#include "kernel/finished.h"
#include "kernel/morphology.h"
#include "kernel/prepared.h"

namespace blossom::morphology {

/// One operation: its counters, and the steps that several of them share. Every step reports from one share of the progress
/// to another.
class Work {
 public:
  explicit Work(const Progress& progress) : whole_(progress), progress_(progress) {}

  /// From now on progress is that of one of several solids, which follow the preparation. @param frame from 0
  void startFrame(std::size_t frame, std::size_t count);

  [[nodiscard]] Prepared prepare(const Operand&, const CommonGrid&, double from, double to);
  [[nodiscard]] std::pair<Prepared, Prepared> prepareBoth(const Operand&, const Operand&, const CommonGrid&, double from,
                                                          double to);
  /// A result as an operand, rounded as if it came from a file. What is thin will be made thick again: slivers stay.
  [[nodiscard]] Prepared asOperand(const Mesh& triangles, const std::string& name, const CommonGrid&, double from, double to,
                                   Slivers = Slivers::Stay);
  /// The operand with its bodies made one where they meet.
  [[nodiscard]] Prepared united(Prepared, const CommonGrid&, double from, double to);

  /// weightA a + weightB b, about the same sum of their centres. Weights above 0.
  /// @param kept of `keptPairs` of the same two, when they are added at more than one pair of weights
  [[nodiscard]] Mesh sum(const Prepared& a, double weightA, const Prepared& b, double weightB, const CommonGrid&,
                         double from, double to, const arrangement::FeaturePairs* kept = nullptr);
  /// Adds the counters of an arrangement. @throws Error Degenerate that names the operand when there is none
  [[nodiscard]] Mesh taken(std::optional<ArrangedSum>, const Prepared&);

  /// The operand as it is, its bodies made one where they meet.
  void finish(const Prepared&, const CommonGrid&, double from, double to);
  /// Closed, oriented triangles.
  void finish(const Mesh&, const Vec3& centre, double from, double to);
  void finish(const Prism&, const Vec3& centre, double from, double to);
  void warn(std::string sentence) { warnings_.push_back(std::move(sentence)); }

  [[nodiscard]] MorphologyResult result();
  [[nodiscard]] const Progress& progress() const { return progress_; }
  MorphologyStats& stats() { return stats_; }

 private:
  [[nodiscard]] Mesh unitedBodies(const Prepared&, const CommonGrid&, double from, double to);

  Progress whole_, progress_;
  MorphologyStats stats_;
  std::vector<Mesh> solids_;
  std::vector<std::string> warnings_;
  RoundingLoss loss_;  ///< of all steps
};

/// As it enters a sum.
[[nodiscard]] Term termOf(const Prepared&, double factor = 1);

/// @throws Error InvalidInput for an operand that has no volume.
void requireSolid(const Operand&);

/// @throws Error Degenerate that names the operand.
[[noreturn]] void refuseSmallFaces(const std::string& name);

/// A shell that looks inwards and crosses another one encloses everything: nothing outside is left.
/// @throws Error InvalidInput that names the operand.
[[noreturn]] void refuseTurnedShell(const Prepared&, const Progress&);

/// @throws Error Degenerate that names the solid of which an erosion has left nothing, and what has no room in it.
[[noreturn]] void nothingLeft(const Operand&, const std::string& element, const std::string& remedy);
/// "The ball" as "the ball".
std::string insideSentence(std::string name);

}  // namespace blossom::morphology
