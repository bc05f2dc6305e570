#pragma once
#include <vector>

#include "parameter/binding.h"

namespace blossom {

/// The indices of picked sub-shapes of one input of a feature.
inline std::vector<int> numbersOf(const std::vector<SubShapeValue>& picked) {
  std::vector<int> numbers;
  numbers.reserve(picked.size());
  for (const SubShapeValue& each : picked) numbers.push_back(each.index);
  return numbers;
}

}  // namespace blossom
