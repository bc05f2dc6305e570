#include "app/sample_maker.h"

namespace {

using namespace blossom;
using samples::add;

/// A rounded cover with bosses that stay: ramps, even depths, a finishing pass along the walls.
Document cover(const App& app) {
  Document document;
  const auto plate = add(app, document, "rectangle", "Cover", {{"width", 90}, {"height", 60}, {"corner", 12}});
  const auto window = add(app, document, "ellipse", "Window", {{"a", 16}, {"b", 10}});
  const auto screw = add(app, document, "circle", "Screw boss", {{"radius", 5}, {"centre", {-31, -17, 0}}});
  const auto row = add(app, document, "pattern", "Row", {{"count", 2}, {"step", {62, 0, 0}}}, {screw});
  const auto bosses = add(app, document, "pattern", "Bosses", {{"count", 2}, {"step", {0, 34, 0}}}, {row});
  const auto part = add(app, document, "boolean", "Part", {{"operation", "difference"}}, {plate, window, bosses});
  add(app, document, "pocket", "Pocket",
      {{"tool-diameter", 6}, {"depth", 9}, {"stepdown", 3}, {"finish", 0.2}, {"zero", "corner"}}, {part});
  return document;
}

/// A pocket around a boss, in stock between two clamps. The holder comes down close to them.
Document clampedBlock(const App& app) {
  Document document;
  const auto body = add(app, document, "box", "Block", {{"width", 80}, {"depth", 50}, {"height", 20}});
  const auto hole =
      add(app, document, "box", "Hollow", {{"width", 60}, {"depth", 30}, {"height", 12}, {"position", {10, 10, 10}}});
  const auto boss = add(app, document, "cylinder", "Boss", {{"radius", 6}, {"height", 20}, {"position", {40, 25, 0}}});
  const auto hollow = add(app, document, "boolean", "Hollowed", {{"operation", "difference"}}, {body, hole});
  const auto part = add(app, document, "boolean", "Part", {{"operation", "union"}}, {hollow, boss});
  const Value size{15, 20, 16};
  const auto setup =
      add(app, document, "setup", "Setup",
          {{"stock-margin", 3},
           {"stock-above", 1},
           {"clamps", {{{"corner", {-18, 15, 12}}, {"size", size}}, {{"corner", {83, 15, 12}}, {"size", size}}}},
           {"travel", {300, 200, 120}},
           {"zero-at", {100, 70, 60}}},
          {part});
  constexpr int floor = 10;  // number of the hollow's floor
  add(app, document, "pocket", "Pocket",
      {{"face", {{"input", "part"}, {"kind", "face"}, {"index", floor}}},
       {"tool-diameter", 6},
       {"depth", 10},
       {"stepdown", 4},
       {"entry", "helix"},
       {"flute-length", 14},
       {"shank-diameter", 6},
       {"stick-out", 22},
       {"holder-diameter", 30}},
      {part, setup});
  Feature shown = document.at(setup);
  shown.visible = true;
  return document.with(std::move(shown));
}

/// Letters cut into a sign with a small tool, helix down, each letter to its depth before the next.
Document sign(const App& app) {
  Document document;
  const auto letters =
      add(app, document, "text", "Letters", {{"text", "Blossom"}, {"style", "bold"}, {"height", 30}, {"at", {0, 0, 0}}});
  add(app, document, "pocket", "Engraved",
      {{"tool-diameter", 2}, {"depth", 2}, {"stepover", "50%"}, {"entry", "helix"}, {"feed", 600}, {"stock-margin", 8}},
      {letters});
  return document;
}

}  // namespace

/// make_pocket_program_samples FOLDER: writes the sample documents of pockets.
int main(int argc, char** argv) {
  return samples::run(argc, argv, [](const App& app, const std::filesystem::path& folder) {
    saveDocument(cover(app), folder / "pocket-cover.blossom");
    saveDocument(sign(app), folder / "pocket-sign.blossom");
    saveDocument(clampedBlock(app), folder / "clamped-block.blossom");
  });
}
