#pragma once
#include <string>

#include "core/place_text.h"

namespace blossom::morphology {

/// What a message speaks of: its name, and where its coordinates begin.
struct Subject {
  std::string name;            ///< "The first solid"
  Vec3 origin = Vec3::Zero();  ///< is added to every place named

  /// A place in a message: "(1, 2.5, -3)", to six digits.
  [[nodiscard]] std::string place(const Vec3& local) const { return placeText(local + origin); }
};

}  // namespace blossom::morphology
