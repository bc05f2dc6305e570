#include "paper_figures.h"

#include <fmt/format.h>

#include <utility>
#include <vector>

#include "app/sample_maker.h"

namespace blossom::samples {
namespace {

constexpr double tolerance = 0.01;  // mm, of what has curves

Value place(double x, double y) { return {x, y, 0.0}; }

Value offsetsTo(std::initializer_list<std::pair<double, double>> places) {
  Value list = Value::array();
  for (const auto& [x, y] : places) list.push_back(place(x, y));
  return list;
}

FeatureId moved(const App& app, Document& document, const char* name, const FeatureId& shape, double x, double y) {
  return add(app, document, "transform", name, {{"move", place(x, y)}}, {shape});
}

/// A flower of six petals with a round hole.
FeatureId addFlower(const App& app, Document& document) {
  const auto petal = add(app, document, "ellipse", "Petal", {{"a", 17}, {"b", 10}, {"centre", place(21, 0)}});
  const auto petals = add(app, document, "pattern", "Petals", {{"kind", "circular"}, {"count", 6}, {"join", true}}, {petal});
  const auto heart = add(app, document, "circle", "Heart", {{"radius", 17}});
  const auto whole = add(app, document, "boolean", "Whole flower", {{"operation", "union"}}, {petals, heart});
  const auto middle = add(app, document, "circle", "Middle", {{"radius", 12}});
  return add(app, document, "boolean", "Flower", {{"operation", "difference"}}, {whole, middle});
}

/// Two pairs of wings and a body about the origin.
FeatureId addButterfly(const App& app, Document& document) {
  const auto wing = [&](const char* name, double a, double b, double x, double y, double rotation) {
    return add(app, document, "ellipse", name, {{"a", a}, {"b", b}, {"centre", place(x, y)}, {"rotation", rotation}});
  };
  const auto upperRight = wing("Upper right wing", 4.5, 2.6, 3.6, 2.4, 35),
             upperLeft = wing("Upper left wing", 4.5, 2.6, -3.6, 2.4, 145),
             lowerRight = wing("Lower right wing", 3, 1.9, 2.6, -2.4, -50),
             lowerLeft = wing("Lower left wing", 3, 1.9, -2.6, -2.4, -130), body = wing("Body", 5, 0.8, 0, 0, 90);
  return add(app, document, "boolean", "Butterfly", {{"operation", "union"}},
             {upperRight, upperLeft, lowerRight, lowerLeft, body});
}

}  // namespace

Document figure1(const App& app) {
  Document document;
  const auto row = [&](const FeatureId& shape, const char* letter, double y) {
    const auto sum = add(app, document, "region-repeat", fmt::format("{0} + {0}", letter).c_str(), {{"count", 2}}, {shape});
    const auto twice = add(app, document, "transform", fmt::format("2 {}", letter).c_str(), {{"scale", 2}}, {shape});
    moved(app, document, fmt::format("{} there", letter).c_str(), shape, -75, y);
    moved(app, document, fmt::format("{0} + {0} there", letter).c_str(), sum, 0, y);
    moved(app, document, fmt::format("2 {} there", letter).c_str(), twice, 95, y);
  };
  const auto triangle = add(app, document, "polygon", "A", {{"sides", 3}, {"radius", 20}, {"rotation", 90}});
  row(triangle, "A", 45);
  const auto star = add(app, document, "star", "B", {{"points", 5}, {"outer", 20}, {"inner", 8}, {"rotation", 90}});
  row(star, "B", -45);
  return document;
}

Document figure2(const App& app) {
  Document document;
  const auto star = add(app, document, "star", "C", {{"points", 5}, {"outer", 20}, {"inner", 8}, {"rotation", 90}});
  constexpr int most = 10, inRow = 5;
  for (int n = 1; n <= most; ++n) {
    const auto sum = add(app, document, "region-repeat", fmt::format("(1/{0}) [{0}] C", n).c_str(),
                         {{"count", n}, {"normalised", true}}, {star});
    moved(app, document, fmt::format("{} there", n).c_str(), sum, 45 * ((n - 1) % inRow - 2), n > inRow ? -25 : 25);
  }
  const auto hull = add(app, document, "region-hull", "Hull of C", Value::object(), {star});
  moved(app, document, "Hull there", hull, 0, -75);
  return document;
}

Document figure3(const App& app) {
  Document document;
  const auto flower = addFlower(app, document), butterfly = addButterfly(app, document);
  const Value along{{"along", "outer"}, {"tolerance", tolerance}}, inside{{"along", "holes"}, {"tolerance", tolerance}};
  const auto outer = add(app, document, "outline-sweep", "Along the outer boundary", along, {flower, butterfly});
  const auto hole = add(app, document, "outline-sweep", "Along the hole", inside, {flower, butterfly});
  const auto sum = add(app, document, "minkowski-sum", "Minkowski sum", {{"tolerance", tolerance}}, {flower, butterfly});
  moved(app, document, "(a) Flower", flower, -105, 50);
  moved(app, document, "(a) Butterfly", butterfly, -105, 105);
  moved(app, document, "(b, c) Along the outer boundary", outer, 0, 50);
  moved(app, document, "(d, e) Along the hole", hole, 90, 50);
  moved(app, document, "(f) Flower", flower, -52, -55);
  moved(app, document, "(f) Along the outer boundary", outer, -52, -55);
  moved(app, document, "(f) Along the hole", hole, -52, -55);
  moved(app, document, "(g) Minkowski sum", sum, 60, -55);
  return document;
}

Document figure4(const App& app) {
  Document document;
  const auto triangle = add(app, document, "polygon", "A", {{"sides", 3}, {"radius", 18}, {"rotation", 90}});
  const auto square = add(app, document, "rectangle", "B", {{"width", 26}, {"height", 26}});
  add(app, document, "morph", "Triangle to square", {{"frames", 25}, {"offsets", offsetsTo({{-60, 30}, {60, -30}})}},
      {triangle, square});
  return document;
}

Document figure5(const App& app) {
  Document document;
  const auto pair = [&](const char* name, const FeatureId& first, const FeatureId& last, double x) {
    const Value places = offsetsTo({{x, 90}, {x, -90}});
    for (const double t : {0.0, 0.25, 0.5, 0.75, 1.0})  // stay when the sequence plays
      add(app, document, "morph", fmt::format("{} at {}", name, t).c_str(),
          {{"t", t}, {"tolerance", tolerance}, {"offsets", places}}, {first, last});
    add(app, document, "morph", name, {{"frames", 25}, {"tolerance", tolerance}, {"offsets", places}}, {first, last});
  };
  const auto star = [&](const char* name, double rotation) {
    return add(app, document, "star", name, {{"points", 5}, {"outer", 19}, {"inner", 8}, {"rotation", rotation}});
  };
  const auto triangle = [&](const char* name, double rotation) {
    return add(app, document, "polygon", name, {{"sides", 3}, {"radius", 18}, {"rotation", rotation}});
  };
  const auto hexagon = add(app, document, "polygon", "Hexagon", {{"sides", 6}, {"radius", 18}});
  const auto circle = add(app, document, "circle", "Circle", {{"radius", 16}});
  pair("(a) Convex pair", hexagon, circle, -110);
  const auto square = add(app, document, "rectangle", "Square", {{"width", 28}, {"height", 28}});
  const auto concave = star("Star", 90);
  pair("(b) Convex and concave", square, concave, -55);
  const auto upright = star("Star upright", 90), turned = star("Star turned", 270);
  pair("(c) Turned stars", upright, turned, 0);
  const auto up = triangle("Triangle", 90), down = triangle("Triangle flipped", 270);
  pair("(d) Flipped pair", up, down, 55);
  const auto post = add(app, document, "rectangle", "Post", {{"width", 12}, {"height", 36}, {"centre", place(-8, 0)}});
  const auto foot = add(app, document, "rectangle", "Foot", {{"width", 28}, {"height", 12}, {"centre", place(0, -12)}});
  const auto angle = add(app, document, "boolean", "Angle", {{"operation", "union"}}, {post, foot});
  const auto other = add(app, document, "transform", "Angle turned", {{"angle", 90}}, {angle});
  pair("(e) Turned, without symmetry", angle, other, 110);
  return document;
}

Document figure6(const App& app) {
  Document document;
  const auto triangle = add(app, document, "polygon", "Triangle", {{"sides", 3}, {"radius", 18}, {"rotation", 90}});
  const auto circle = add(app, document, "circle", "Circle", {{"radius", 15}});
  const auto square = add(app, document, "rectangle", "Square", {{"width", 26}, {"height", 26}});
  const std::pair<double, double> atTriangle{-90, -40}, atCircle{0, 70}, atSquare{90, -40};
  const auto morph = [&](const char* name, std::initializer_list<std::pair<double, double>> places,
                         const std::vector<FeatureId>& shapes) {
    add(app, document, "morph", name, {{"frames", 25}, {"tolerance", tolerance}, {"offsets", offsetsTo(places)}}, shapes);
  };
  morph("Triangle to square", {atTriangle, atSquare}, {triangle, square});
  morph("Triangle to circle", {atTriangle, atCircle}, {triangle, circle});
  morph("Circle to square", {atCircle, atSquare}, {circle, square});
  morph("Triangle to square by the circle", {atTriangle, atCircle, atSquare}, {triangle, circle, square});
  return document;
}

}  // namespace blossom::samples
