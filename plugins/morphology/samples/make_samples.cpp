#include "app/sample_maker.h"

namespace {

using namespace blossom;
using samples::add;

Value line(double x, double y) { return {{"kind", "line"}, {"to", {x, y, 0}}, {"tangent", false}}; }

/// Figure 6 of Liu, Chen, Wan & Zhu: a quadrilateral becomes a triangle, here as solids. The figure shows five of the steps.
Document blockToWedge(const App& app) {
  Document document;
  const auto square = add(app, document, "rectangle", "Square", {{"width", 40}, {"height", 40}});
  const auto block = add(app, document, "extrude", "Block", {{"height", 20}}, {square});
  const auto triangle = add(app, document, "polygon", "Triangle", {{"sides", 3}, {"radius", 24}, {"rotation", 90}});
  const auto wedge = add(app, document, "extrude", "Wedge", {{"height", 40}}, {triangle});
  add(app, document, "solid-morph", "Block to wedge", {{"frames", 17}}, {block, wedge});
  return document;
}

/// Figure 5: a solid with two reflex edges, and a convex one added to it.
Document notchedPlusPyramid(const App& app) {
  Document document;
  const Value around = {line(60, 0),  line(60, 50), line(40, 50), line(40, 20),
                        line(20, 20), line(20, 50), line(0, 50),  line(0, 0)};
  const auto outline = add(app, document, "outline", "Outline", {{"segments", around}});
  const auto notched = add(app, document, "extrude", "Notched block", {{"height", 20}}, {outline});
  const auto base = add(app, document, "polygon", "Base", {{"sides", 3}, {"radius", 8}});
  const auto pyramid = add(app, document, "extrude", "Tapered", {{"height", 10}, {"taper", 20}}, {base});
  add(app, document, "solid-sum", "Notched plus tapered", Value::object(), {notched, pyramid});
  return document;
}

/// Figure 4: the sum of two convex solids.
Document convexPair(const App& app) {
  Document document;
  const auto base = add(app, document, "polygon", "Base", {{"sides", 5}, {"radius", 25}, {"rotation", 90}});
  const auto block = add(app, document, "extrude", "Block", {{"height", 20}}, {base});
  const auto triangle = add(app, document, "polygon", "Triangle", {{"sides", 3}, {"radius", 10}, {"centre", {60, 0, 0}}});
  const auto pyramid = add(app, document, "extrude", "Tapered", {{"height", 14}, {"taper", 15}}, {triangle});
  add(app, document, "solid-sum", "Block plus tapered", Value::object(), {block, pyramid});
  return document;
}

/// A gear lies in a recess that is larger than it on all sides.
Document gearWithClearance(const App& app) {
  Document document;
  const auto outline = add(app, document, "star", "Outline", {{"points", 12}, {"outer", 22}, {"inner", 17}});
  const auto gear = add(app, document, "extrude", "Gear", {{"height", 10}}, {outline});
  const auto grown = add(app, document, "inflate", "Gear and clearance", {{"radius", 0.8}, {"subdivisions", 1}}, {gear});
  const auto plate =
      add(app, document, "box", "Plate", {{"width", 60}, {"depth", 60}, {"height", 9}, {"position", {-30, -30, -4}}});
  add(app, document, "transform", "Gear lifted", {{"move", {0, 0, 14}}}, {gear});
  add(app, document, "boolean", "Recess", {{"operation", "difference"}}, {plate, grown});
  return document;
}

/// Letters whose edges, outer and inner ones, are rounded by a ball.
Document roundedLetters(const App& app) {
  Document document;
  const auto text = add(app, document, "text", "Letters", {{"text", "Ta"}, {"style", "bold"}, {"height", 30}});
  const auto raised = add(app, document, "extrude", "Raised", {{"height", 8}}, {text});
  add(app, document, "solid-round", "Rounded", {{"radius", 1.2}, {"edges", "both"}, {"subdivisions", 2}}, {raised});
  return document;
}

/// Section 3.2: a piece of ice melts. Thin parts go first, what is thick lasts.
Document meltingIce(const App& app) {
  Document document;
  const auto star = add(app, document, "star", "Star", {{"points", 6}, {"outer", 30}, {"inner", 15}});
  const auto ice = add(app, document, "extrude", "Ice", {{"height", 24}}, {star});
  add(app, document, "melt", "Melting ice", {{"radius", 8}, {"frames", 9}, {"subdivisions", 1}}, {ice});
  return document;
}

/// The same with edges that go first, until nothing is left.
Document smoothIce(const App& app) {
  Document document;
  const auto star = add(app, document, "star", "Star", {{"points", 5}, {"outer", 30}, {"inner", 14}});
  const auto ice = add(app, document, "extrude", "Ice", {{"height", 20}}, {star});
  add(app, document, "melt", "Gone",
      {{"until", "nothing"}, {"rounding", 0.6}, {"frames", 13}, {"control", "ease-out"}, {"subdivisions", 1}}, {ice});
  return document;
}

/// A block becomes a wedge by way of a ball, and comes near it.
Document byWayOfABall(const App& app) {
  Document document;
  const auto block = add(app, document, "box", "Block", {{"width", 40}, {"depth", 40}, {"height", 30}});
  const auto ball = add(app, document, "ball", "Ball", {{"radius", 25}, {"subdivisions", 1}});
  const auto triangle = add(app, document, "polygon", "Triangle", {{"sides", 3}, {"radius", 28}, {"rotation", 90}});
  const auto wedge = add(app, document, "extrude", "Wedge", {{"height", 40}}, {triangle});
  add(app, document, "solid-morph", "By way of a ball", {{"frames", 13}}, {block, ball, wedge});
  return document;
}

/// A letter, grown by a ball on all sides.
Document inflatedLetter(const App& app) {
  Document document;
  const auto text = add(app, document, "text", "Letter", {{"text", "L"}, {"style", "bold"}, {"height", 40}});
  const auto letter = add(app, document, "extrude", "Raised", {{"height", 8}}, {text});
  add(app, document, "inflate", "Inflated", {{"radius", 4}, {"subdivisions", 2}}, {letter});
  return document;
}

}  // namespace

/// make_morphology_samples FOLDER: writes the sample documents of sums, morphs and melting.
int main(int argc, char** argv) {
  return samples::run(argc, argv, [](const App& app, const std::filesystem::path& folder) {
    saveDocument(blockToWedge(app), folder / "block-to-wedge.blossom");
    saveDocument(notchedPlusPyramid(app), folder / "notched-sum.blossom");
    saveDocument(convexPair(app), folder / "convex-pair.blossom");
    saveDocument(gearWithClearance(app), folder / "gear-with-clearance.blossom");
    saveDocument(roundedLetters(app), folder / "rounded-letters.blossom");
    saveDocument(meltingIce(app), folder / "melting-ice.blossom");
    saveDocument(inflatedLetter(app), folder / "inflated-letter.blossom");
    saveDocument(smoothIce(app), folder / "smooth-ice.blossom");
    saveDocument(byWayOfABall(app), folder / "by-way-of-a-ball.blossom");
  });
}
