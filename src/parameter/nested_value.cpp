#include "parameter/nested_value.h"

#include <algorithm>

namespace blossom {

namespace {

/// Levels of lists and objects, itself included.
int depthOf(const Value& value) {
  if (!value.is_structured()) return 0;
  int deepest = 0;
  for (const Value& part : value) deepest = std::max(deepest, depthOf(part));
  return deepest + 1;
}

}  // namespace

bool isNestedData(const Value& value) {
  constexpr int deepestRead = 2;  // points of a list
  return depthOf(value) > deepestRead;
}

}  // namespace blossom
