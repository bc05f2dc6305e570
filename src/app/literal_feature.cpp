#include "app/literal_feature.h"

#include <fmt/format.h>

#include "core/error.h"

namespace blossom {
namespace {

struct LiteralParameters {
  std::string text;
};

Shape shapeOf(const std::string& text, const Registry& registry) {
  Shape shape = registry.literal(text);
  if (!shape.empty()) return shape;
  std::string forms;
  for (const auto& form : registry.literals()) forms += (forms.empty() ? "" : ", ") + form.syntax;
  throw Error(ErrorCode::InvalidParameter, fmt::format("\"{}\" is not a shape that can be written down.", text),
              forms.empty() ? "No plugin that is loaded has such forms." : fmt::format("The forms are {}.", forms));
}

std::string dependence(const std::string& text, const Registry& registry) {
  for (const auto& form : registry.literals())
    if (form.dependsOn && text.starts_with(form.name + ':')) return form.dependsOn();
  return {};
}

}  // namespace

FeatureType literalFeature(const std::weak_ptr<const Registry>& registry) {
  return feature<LiteralParameters>("blossom.literal", "Literal", "A shape written down in one word, such as ball:5:3.")
      .command("literal")
      .icon("literal")
      .parameter("text", &LiteralParameters::text, text(), "The form and its measures.")
      .dependsOn([registry](const LiteralParameters& p) {
        const auto alive = registry.lock();
        return alive ? dependence(p.text, *alive) : std::string();
      })
      .evaluate([registry](const LiteralParameters& p, const Inputs&, const Progress&) -> Evaluated {
        const auto alive = registry.lock();
        if (!alive) throw Error(ErrorCode::Internal, "The registry of literal forms is gone.");
        return {shapeOf(p.text, *alive), Value::object(), {}};
      });
}

}  // namespace blossom
