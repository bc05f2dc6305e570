#pragma once
#include <string>
#include <vector>

#include "core/progress.h"
#include "core/stopwatch.h"
#include "kernel/finished.h"
#include "kernel/morphology.h"
#include "kernel/prepared.h"

namespace blossom::morphology {

/// One operation: its counters, and the steps that several of them share. Every step reports from one share of the progress
/// to another.
class Work {
 public:
  explicit Work(const Progress& progress) : progress_(progress) {}

  [[nodiscard]] Prepared prepare(const Operand&, const CommonGrid&, double from, double to);
  [[nodiscard]] Parts apart(const Prepared&, double from, double to);
  [[nodiscard]] Parts outside(const Solid&, const Bounds& frame, double from, double to);
  [[nodiscard]] Solid sum(const Parts& a, const Parts& b, double from, double to);
  /// weightA a + weightB b of two solids.
  [[nodiscard]] Solid nefSum(const Prepared& a, double weightA, const Prepared& b, double weightB, double from, double to);

  /// An exact result as an operand, rounded as if it came from a file: it has faces that are bent by less than rounding, and
  /// every bend would be taken apart. As it is where rounding would make it cross itself.
  [[nodiscard]] Prepared asOperand(const Solid&, const Bounds&, const CommonGrid&, double from, double to);

  /// The operand as it is, its bodies made one where they meet.
  void finish(const Prepared&, double from, double to);
  void finish(const Solid&, const Vec3& centre, double from, double to);
  /// Closed, oriented triangles.
  void finish(const Mesh&, const Vec3& centre, double from, double to);
  void finish(const Prism&, const Vec3& centre, double from, double to);
  void warn(std::string sentence) { warnings_.push_back(std::move(sentence)); }

  [[nodiscard]] MorphologyResult result();
  [[nodiscard]] const Progress& progress() const { return progress_; }
  MorphologyStats& stats() { return stats_; }

 private:
  void add(Finished, Stopwatch&);

  const Progress& progress_;
  MorphologyStats stats_;
  std::vector<Mesh> solids_;
  std::vector<std::string> warnings_;
};

/// @throws Error InvalidInput for an operand that has no volume.
void requireSolid(const Operand&);

/// @throws Error Degenerate that names the solid of which an erosion has left nothing.
[[noreturn]] void nothingLeft(const Operand&, const std::string& remedy);

}  // namespace blossom::morphology
