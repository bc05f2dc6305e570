#pragma once
#include <array>
#include <optional>
#include <vector>

#include "kernel/operations/work.h"

/// Two operands of one operation, and how they are added where they are simple.
namespace blossom::morphology {

struct Pair {
  CommonGrid grid;
  Prepared a, b;
};

Pair preparedPair(Work&, const Operand& a, const Operand& b);

/// Both as prisms along one axis.
struct PrismPair {
  Prism a, b;
};
std::optional<PrismPair> asPrisms(const Prepared& a, const Prepared& b);

inline bool isConvex(const Prepared& operand) { return operand.hull.faceCount() > 0; }

/// Weighted sums of two convex solids, whose corners are paired once.
class ConvexSums {
 public:
  /// @pre both hulls outlive it
  ConvexSums(const Mesh& a, const Mesh& b, Work& work);

  /// weightA a + weightB b
  [[nodiscard]] Mesh sum(double weightA, double weightB);

 private:
  const Mesh &a_, &b_;
  Work& work_;
  std::vector<std::array<int, 2>> corners_;
};

/// weightA a + weightB b of shapes of any kind, about the same sum of their centres. Weights above 0. @throws Error
/// Degenerate when it has no volume.
Mesh sumOfAny(Work&, const Prepared& a, double weightA, const Prepared& b, double weightB, const CommonGrid&, double from,
              double to, const arrangement::FeaturePairs* kept = nullptr);

}  // namespace blossom::morphology
