#include "manipulators/coarse_morph.h"

#include <algorithm>
#include <cmath>

#include "manipulators/morph_ladder.h"

namespace blossom::minkowski {

Value coarseParameters(Value parameters, double tolerance) {
  const Value& given = parameters.at("tolerance");
  parameters["tolerance"] = given.is_number() ? std::max(given.get<double>(), tolerance) : tolerance;
  return parameters;
}

Value fewerFrames(Value parameters, int count, int seen, int place) {
  const int frames = parameters.at("frames").get<int>();
  Value keys = Value::array();
  for (int k = 0; k < count; ++k) {
    const double even = static_cast<double>(k) * (frames - 1) / (count - 1);
    const int frame = k == place ? seen : static_cast<int>(std::lround(even));
    keys.push_back({{"frame", k + 1}, {"t", timeOfFrame(parameters, frame, frames)}, {"ease", "linear"}});
  }
  parameters["frames"] = count;
  parameters["keys"] = std::move(keys);
  return parameters;
}

}  // namespace blossom::minkowski
