#include "app/sample_maker.h"
#include "paper_figures.h"

namespace {

using namespace blossom;
using samples::add;

Value places(std::initializer_list<std::pair<double, double>> offsets) {
  Value list = Value::array();
  for (const auto& [x, y] : offsets) list.push_back({x, y, 0.0});
  return list;
}

/// Figure 7 of Lee, Lee, Kim & Kim 2002: a triangle becomes a star, pulled towards a pentagon early and rounded on its way
/// by a circle.
Document triangleToStar(const App& app) {
  Document document;
  const auto triangle = add(app, document, "polygon", "Triangle", {{"sides", 3}, {"radius", 20}, {"rotation", 90}});
  const auto pentagon = add(app, document, "polygon", "Pentagon", {{"sides", 5}, {"radius", 20}, {"rotation", 90}});
  const auto circle = add(app, document, "circle", "Circle", {{"radius", 18}});
  const auto star = add(app, document, "star", "Star", {{"points", 5}, {"outer", 24}, {"inner", 9}, {"rotation", 90}});
  add(app, document, "morph", "Triangle to star",
      {{"frames", 49}, {"tolerance", 0.01}, {"offsets", places({{-90, -20}, {-50, 45}, {50, 45}, {90, -20}})}},
      {triangle, pentagon, circle, star});
  return document;
}

/// Figure 5 (f): a letter with two holes becomes a flower with one. Nobody says which corner goes where.
Document phiToFlower(const App& app) {
  Document document;
  const auto phi = add(app, document, "text", "Phi",
                       {{"text", "\u03A6"}, {"style", "bold"}, {"height", 60}, {"align", "centre"}, {"at", {0, -30, 0}}});
  const auto petal = add(app, document, "ellipse", "Petal", {{"a", 13}, {"b", 7}, {"centre", {17, 0, 0}}});
  const auto petals = add(app, document, "pattern", "Petals", {{"kind", "circular"}, {"count", 6}, {"join", true}}, {petal});
  const auto heart = add(app, document, "circle", "Heart", {{"radius", 8}});
  const auto whole = add(app, document, "boolean", "Whole flower", {{"operation", "union"}}, {petals, heart});
  const auto middle = add(app, document, "circle", "Middle", {{"radius", 4}});
  const auto flower = add(app, document, "boolean", "Flower", {{"operation", "difference"}}, {whole, middle});
  add(app, document, "morph", "Phi to flower",
      {{"frames", 25}, {"tolerance", 0.01}, {"offsets", places({{-60, 0}, {60, 0}})}}, {phi, flower});
  return document;
}

/// Where the middle of a cutter may stand in a plate with a boss, and what the cutter then reaches.
Document cutterRoom(const App& app) {
  Document document;
  const auto plate = add(app, document, "rectangle", "Plate", {{"width", 60}, {"height", 40}, {"corner", 6}});
  const auto boss = add(app, document, "star", "Boss", {{"points", 6}, {"outer", 12}, {"inner", 6}});
  const auto pocket = add(app, document, "boolean", "Pocket", {{"operation", "difference"}}, {plate, boss});
  const auto cutter = add(app, document, "circle", "Cutter", {{"radius", 3}});
  const auto room =
      add(app, document, "minkowski-difference", "Room for the cutter", {{"tolerance", 0.01}}, {pocket, cutter});
  add(app, document, "minkowski-sum", "What is cut", {{"tolerance", 0.01}}, {room, cutter});
  return document;
}

}  // namespace

/// make_minkowski_samples FOLDER: writes the sample documents of morphs and sums.
int main(int argc, char** argv) {
  return samples::run(argc, argv, [](const App& app, const std::filesystem::path& folder) {
    saveDocument(triangleToStar(app), folder / "triangle-to-star.blossom");
    saveDocument(phiToFlower(app), folder / "phi-to-flower.blossom");
    saveDocument(cutterRoom(app), folder / "cutter-room.blossom");
    saveDocument(samples::figure1(app), folder / "figure-1-doubled-star.blossom");
    saveDocument(samples::figure2(app), folder / "figure-2-towards-the-hull.blossom");
    saveDocument(samples::figure3(app), folder / "figure-3-flower-and-butterfly.blossom");
    saveDocument(samples::figure4(app), folder / "figure-4-triangle-to-square.blossom");
    saveDocument(samples::figure5(app), folder / "figure-5-five-pairs.blossom");
    saveDocument(samples::figure6(app), folder / "figure-6-rounded-by-a-circle.blossom");
  });
}
