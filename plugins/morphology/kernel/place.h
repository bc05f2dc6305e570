#pragma once
#include <fmt/format.h>

#include <string>

#include "core/vector.h"

namespace blossom::morphology {

/// What a message speaks of: its name, and where its coordinates begin.
struct Subject {
  std::string name;            ///< "The first solid"
  Vec3 origin = Vec3::Zero();  ///< is added to every place named

  /// A place in a message: "(1, 2.5, -3)", to six digits.
  [[nodiscard]] std::string place(const Vec3& local) const {
    const Vec3 p = local + origin;
    return fmt::format("({:.6g}, {:.6g}, {:.6g})", p.x() + 0.0, p.y() + 0.0, p.z() + 0.0);
  }
};

}  // namespace blossom::morphology
