#include "core/ease.h"

#include <algorithm>
#include <cmath>

namespace blossom {

double easedWay(Ease ease, double time) {
  const double s = std::clamp(time, 0.0, 1.0);
  switch (ease) {
    case Ease::Linear:
      break;
    case Ease::In:
      return s * s;
    case Ease::Out:
      return 1 - (1 - s) * (1 - s);
    case Ease::InOut:
      return s * s * (3 - 2 * s);
  }
  return s;
}

double easedTime(Ease ease, double way) {
  const double y = std::clamp(way, 0.0, 1.0);
  switch (ease) {
    case Ease::Linear:
      break;
    case Ease::In:
      return std::sqrt(y);
    case Ease::Out:
      return 1 - std::sqrt(1 - y);
    case Ease::InOut:  // the root in 0..1 of the cubic, by the sine of a third
      return y == 0 || y == 1 ? y : 0.5 - std::sin(std::asin(1 - 2 * y) / 3);
  }
  return y;
}

}  // namespace blossom
