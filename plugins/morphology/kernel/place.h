#pragma once
#include <string>

#include "core/place_text.h"

namespace blossom::morphology {

/// The shape that a message is about: its name and the origin of its local coordinates.
struct Subject {
  std::string name;            ///< "The first solid"
  Vec3 origin = Vec3::Zero();  ///< added to local coordinates

  /// A position in a message: "(1, 2.5, -3)", to six digits.
  [[nodiscard]] std::string place(const Vec3& local) const { return placeText(local + origin); }
};

}  // namespace blossom::morphology
