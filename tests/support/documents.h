#pragma once
#include <vector>

#include "document/document.h"

namespace blossom::test {

using Ids = std::vector<FeatureId>;

/// The features in the order of the document.
inline Ids order(const Document& document) {
  Ids ids;
  for (const auto& feature : document.features()) ids.push_back(feature->id);
  return ids;
}

}  // namespace blossom::test
