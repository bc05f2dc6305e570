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
  });
}
