#include <array>
#include <vector>
#include "app/sample_maker.h"

namespace {

using namespace blossom;

FeatureId add(const App& app, Document& document, const char* command, const char* name, Value parameters,
              const std::vector<FeatureId>& inputs = {}, bool visible = true) {
  const auto type = app.registry->at(command);
  Feature feature{document.freshId(command), type->id, name, std::move(parameters), inputs, visible, false, Value::object()};
  document = document.with(feature);
  return feature.id;
}

/// Free-form outlines through points, closed by a last spline that goes on in the direction of the one before.
Value closedSpline(const std::vector<std::array<double, 2>>& through) {
  Value points = Value::array();
  for (std::size_t i = 1; i < through.size(); ++i) points.push_back({through[i][0], through[i][1], 0.0});
  return {
      {"start", {through[0][0], through[0][1], 0.0}},
      {"segments", Value::array({{{"kind", "spline"}, {"through", points}, {"to", {through[0][0], through[0][1], 0.0}}}})}};
}

/// Jeong & Kim's task: a pocket bounded by free-form curves with a free-form island, its medial axis and its offsets.
Document freeFormPocket(const App& app) {
  Document document;
  const auto outline =
      add(app, document, "outline", "Outline",
          closedSpline({{-50, 0}, {-38, -26}, {-8, -22}, {18, -32}, {46, -18}, {48, 14}, {22, 26}, {2, 16}, {-24, 30}}), {},
          false);
  const auto island =
      add(app, document, "outline", "Island", closedSpline({{4, -8}, {20, -12}, {28, 2}, {18, 8}, {8, 4}}), {}, false);
  const auto pocket = add(app, document, "boolean", "Pocket", {{"operation", "difference"}}, {outline, island});
  add(app, document, "offset", "Offset loops", {{"distance", {2, 4, 6, 8, 10, 12, 14, 16}}}, {pocket});
  add(app, document, "medial-axis", "Medial axis", Value::object(), {pocket});
  return document;
}

/// A sticker: letters, the line to cut around them, and the strokes that a pen draws along their middle.
Document sticker(const App& app) {
  Document document;
  const auto text = add(app, document, "text", "Letters", {{"text", "Blossom"}, {"style", "bold"}, {"height", 20}});
  add(app, document, "offset", "Cutting line", {{"distance", {3}}, {"side", "outside"}}, {text});
  add(app, document, "medial-axis", "Pen strokes", Value::object(), {text});
  return document;
}

}  // namespace

/// make_offset_samples FOLDER: writes the sample documents of offsets and medial axes.
int main(int argc, char** argv) {
  return samples::run(argc, argv, [](const App& app, const std::filesystem::path& folder) {
    saveDocument(freeFormPocket(app), folder / "free-form-pocket.blossom");
    saveDocument(sticker(app), folder / "sticker.blossom");
  });
}
