#pragma once
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "core/progress.h"
#include "feature/input_image.h"
#include "naming/face_origins.h"

namespace blossom {

/// One step of the construction of a document: a feature.
struct ConstructionStep {
  std::string id;
  std::vector<std::string> sources;  ///< ids of its inputs in the order of declaration
  std::vector<Shape> inputs;         ///< their shapes as it got them
  std::vector<InputImage> images;
  Shape result;
};

/// The steps of a document, each traced once.
class Construction {
 public:
  /// @throws Error NotFound when there is no such feature or it has no result.
  using StepOf = std::function<ConstructionStep(const std::string& id)>;
  explicit Construction(StepOf stepOf) : stepOf_(std::move(stepOf)) {}

  const ConstructionStep& step(const std::string& id);
  /// Of each face of the step's result, which is a B-rep. @throws Error Cancelled.
  const std::vector<std::vector<FaceOrigin>>& origins(const std::string& id, const Progress&);

 private:
  StepOf stepOf_;
  std::map<std::string, ConstructionStep> steps_;
  std::map<std::string, std::vector<std::vector<FaceOrigin>>> origins_;
};

}  // namespace blossom
