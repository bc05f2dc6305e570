#include "kernel/end_poles.h"

#include <algorithm>

namespace blossom::sweep {

Vec3 euclidean(const Vec4& pole) { return pole.head<3>() / pole[3]; }

double nearAt(const Vec4& pole, double near) {
  constexpr double rounding = 1.5e-14;  // of the coordinates, which have no finer steps after the product is formed
  return std::max(near, rounding * euclidean(pole).norm());
}

std::vector<Vec4> endPoles(const Surface& surface, bool atEnd) {
  std::vector<Vec4> poles;
  for (std::size_t i = 0; i < surface.countU(); ++i) poles.push_back(surface.pole(i, atEnd ? surface.countV() - 1 : 0));
  return poles;
}

Vec3 middleOf(const std::vector<Vec4>& poles) {
  Vec3 sum = Vec3::Zero();
  for (std::size_t i = 0; i + 1 < poles.size(); ++i) sum += euclidean(poles[i]);
  return sum / static_cast<double>(poles.size() - 1);
}

bool isPoint(const std::vector<Vec4>& poles, const Vec3& middle, double near) {
  return std::all_of(poles.begin(), poles.end(),
                     [&](const Vec4& pole) { return (euclidean(pole) - middle).norm() <= near; });
}

}  // namespace blossom::sweep
