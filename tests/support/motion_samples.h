#pragma once
#include "exchange/formats.h"
#include "geometry/shape/motion.h"
#include "support/support.h"

namespace blossom::test {

/// The motion of a file among the samples.
inline Motion readMotionOf(const std::string& name) {
  return *motionFormat().read(sample(name), Value::object(), Progress::none()).shape.get<Motion>();
}

}  // namespace blossom::test
