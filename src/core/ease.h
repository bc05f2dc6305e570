#pragma once

namespace blossom {

/// How a way grows with the time s, both from 0 to 1.
enum class Ease {
  Linear,  ///< s
  In,      ///< s^2: it begins slowly
  Out,     ///< 1 - (1-s)^2: it ends slowly
  InOut    ///< 3 s^2 - 2 s^3, the smoothstep: both
};

/// The way done at a time, which is taken into 0..1.
double easedWay(Ease, double time);
/// Its inverse, in closed form.
double easedTime(Ease, double way);

}  // namespace blossom
