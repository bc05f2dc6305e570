#include "kernel/parts/largest_size.h"

#include <Standard_Failure.hxx>
#include <cmath>

#include "core/units.h"

namespace blossom::modeling {

std::optional<double> largestSize(double failing, const std::function<bool(double)>& works, const Progress& progress) {
  const auto holds = [&](double size) {
    progress.check();
    try {
      return works(size);
    } catch (const Standard_Failure&) {
      return false;
    }
  };
  double low = failing;
  for (int halvings = 0; !holds(low /= 2);)
    if (++halvings == 10) return {};
  double high = 2 * low;
  for (int i = 0; i < 10; ++i) (holds((low + high) / 2) ? low : high) = (low + high) / 2;
  return low;
}

std::string roundedDown(double size) {
  const double unit = std::pow(10, std::floor(std::log10(size)) - 3);
  const double digits = std::floor(size / unit * (1 + 1e-9));
  // Dividing by a whole power keeps 4.8 from becoming 4.800000000000001.
  return formatNumber(unit < 1 ? digits / std::round(1 / unit) : digits * unit);
}

}  // namespace blossom::modeling
