#include "naming/construction.h"

namespace blossom {

const ConstructionStep& Construction::step(const std::string& id) {
  if (const auto known = steps_.find(id); known != steps_.end()) return known->second;
  return steps_.emplace(id, stepOf_(id)).first->second;
}

const std::vector<std::vector<FaceOrigin>>& Construction::origins(const std::string& id, const Progress& progress) {
  if (const auto known = origins_.find(id); known != origins_.end()) return known->second;
  const ConstructionStep& traced = step(id);
  auto found = faceOrigins(traced.result.get<Brep>()->shape(), traced.inputs, traced.images, progress);
  return origins_.emplace(id, std::move(found)).first->second;
}

}  // namespace blossom
