#pragma once
#include <map>

#include "document/evaluator.h"
#include "naming/likeness.h"
#include "support/modeling.h"

/// Parts of shapes that are picked by where they lie, and a feature that names them.
namespace blossom::test {

inline Document with(const Document& document, const char* id, const char* type, Value parameters,
                     std::vector<FeatureId> inputs = {}) {
  Feature feature;
  feature.id = feature.name = id;
  feature.type = std::string("modeling.") + type;
  feature.parameters = std::move(parameters);
  feature.inputs = std::move(inputs);
  return document.with(std::move(feature));
}

/// The number of the only part at a place; nothing when there is none or several.
inline std::optional<int> numberAt(const Shape& shape, SubShapeKind kind, const Vec3& place) {
  const std::vector<Likeness> all = likenesses(shape, kind);
  std::optional<int> found;
  for (std::size_t k = 0; k < all.size(); ++k) {
    if ((all[k].place - place).norm() > 1e-6) continue;
    if (found) return std::nullopt;
    found = static_cast<int>(k);
  }
  return found;
}

/// A feature that only names parts, so that no kernel may refuse them.
struct Held {
  std::vector<SubShapeValue> edges, faces;
};

inline FeatureType holdFeature() {
  return feature<Held>("modeling.hold", "Hold", "Names parts of a solid.")
      .input({.name = "shape", .help = "A solid.", .kinds = {ShapeKind::Brep}})
      .parameter("edges", &Held::edges, list(subShape("edge")), "Edges.")
      .parameter("faces", &Held::faces, list(subShape("face")), "Faces.")
      .evaluate([](const Held&, const Inputs& inputs, const Progress&) {
        return Evaluated{inputs.of(0)[0], Value::object(), {}};
      });
}

inline Results evaluated(const Document& document) {
  static const auto registry = [] {
    auto all = std::make_shared<Registry>(*theApp().registry);
    all->add(holdFeature());
    return all;
  }();
  static Evaluator evaluator(registry, 64);
  return evaluator.evaluate(document, Progress::none());
}

}  // namespace blossom::test
