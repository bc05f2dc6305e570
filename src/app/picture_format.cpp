#include "app/picture_format.h"

#include <fmt/format.h>

#include <charconv>
#include <memory>

#include "core/error.h"
#include "exchange/format/frames.h"
#include "scene/film/film.h"
#include "scene/sequence_pictures.h"

namespace blossom {

namespace {

ParameterSpec option(ParameterSpec spec, std::string name, std::string help, Value fallback) {
  spec.name = std::move(name);
  spec.help = std::move(help);
  spec.fallback = std::move(fallback);
  return spec;
}

/// Of pictures and of films.
std::vector<ParameterSpec> lookOptions() {
  return {option(text(), "size", "Width and height in pixels.", "1280x800"),
          option(choice(viewNames()), "view", "Direction of view; auto means top for planar drawings and iso for the rest.",
                 "auto"),
          option(choice({"dark", "light"}), "theme", "Colours of canvas and edges.", "dark"),
          option(flag(), "edges", "Draw the feature edges.", true),
          option(choice(surfaceDisplayNames()), "display",
                 "What the faces tell of their surfaces: zebra stripes, Gaussian, mean or largest curvature in colours, or "
                 "iso-curves.",
                 "plain"),
          option(count(1, 200), "stripes", "Dark stripes of the zebra, from one side of the surroundings to the other.", 12),
          option(angle(), "stripe-angle", "Turns the stripes of the zebra from level.", 0.0),
          option(count(0, 100), "iso-curves", "Iso-curves in each direction of a face.", 8),
          option(length(), "chord", "Largest distance between the shape and its picture; 0 is as fine as the picture needs.",
                 0.0)};
}

std::vector<ParameterSpec> pictureOptions() {
  std::vector<ParameterSpec> options = lookOptions();
  options.insert(options.begin() + 3, option(flag(), "transparent", "Leave the background out.", false));
  options.push_back(sheetOption());
  return options;
}

std::vector<ParameterSpec> filmOptions() {
  std::vector<ParameterSpec> options = lookOptions();
  options.push_back(option(number(0.01, 3600), "seconds", "Duration of the film in seconds.", 2.0));
  options.push_back(option(count(1, 120), "rate", "Pictures per second.", 25));
  return options;
}

// "1280x800"
void readSize(const std::string& text, PictureOptions& options) {
  const char* end = text.data() + text.size();
  const auto width = std::from_chars(text.data(), end, options.width);
  if (width.ec == std::errc{} && width.ptr != end && (*width.ptr == 'x' || *width.ptr == 'X')) {
    const auto height = std::from_chars(width.ptr + 1, end, options.height);
    if (height.ec == std::errc{} && height.ptr == end) return;
  }
  throw Error(ErrorCode::InvalidParameter, fmt::format("\"{}\" is not a size of a picture.", text),
              "Write width and height like 1280x800.");
}

/// What a choice of the look says, in either format.
PictureOptions lookFrom(const Value& all) {
  PictureOptions options;
  readSize(all.at("size").get<std::string>(), options);
  options.view = all.at("view").get<std::string>();
  options.lightTheme = all.at("theme") == "light";
  options.edges = all.at("edges").get<bool>();
  options.chord = all.at("chord").get<double>();
  options.display = surfaceDisplayOf(all.at("display").get<std::string>());
  options.zebra = {all.at("stripes").get<int>(), all.at("stripe-angle").get<double>()};
  options.isoCurves = all.at("iso-curves").get<int>();
  return options;
}

void writePicture(const Shape& shape, const std::filesystem::path& path, const Value& values, const Progress& progress) {
  const PictureOptions options = readPictureOptions(values);
  const auto* sequence = shape.get<Sequence>();
  if (sequence)
    renderContactSheet(*sequence, path, options, sheetCells(values), progress);
  else
    renderPicture({shape}, path, options, progress);
}

Format::Write pictureOfEachFrame(const Sequence& sequence, const Value& values, const Progress& looking) {
  return [pictures = std::make_shared<FramePictures>(sequence, readPictureOptions(values), looking)](
             const Shape& frame, const std::filesystem::path& path, const Value&, const Progress& progress) {
    pictures->write(frame, path, progress);
  };
}

void writeFilm(const Shape& shape, const std::filesystem::path& path, const Value& values, const Progress& progress) {
  const auto* sequence = shape.get<Sequence>();
  if (!sequence) throw Error(ErrorCode::OutputNotSupported, "A film takes a sequence.", "Set frames, as of a morph.");
  const Value all = completed(filmOptions(), values);
  renderFilm(*sequence, path,
             {.picture = lookFrom(all), .seconds = all.at("seconds").get<double>(), .rate = all.at("rate").get<int>()},
             progress);
}

}  // namespace

PictureOptions readPictureOptions(const Value& values) {
  const Value all = completed(pictureOptions(), values);
  PictureOptions options = lookFrom(all);
  options.transparent = all.at("transparent").get<bool>();
  return options;
}

Format pngFormat() {
  Format png;
  png.id = "png";
  png.title = "Picture (PNG)";
  png.extensions = {"png"};
  png.writeOptions = pictureOptions();
  png.write = writePicture;
  png.frameWriter = pictureOfEachFrame;
  png.inOneFile = [](const Value& options) { return sheetCells(options) > 0; };
  png.writes = {ShapeKind::Region,   ShapeKind::Curves, ShapeKind::Curve,   ShapeKind::Surface,
                ShapeKind::Brep,     ShapeKind::Mesh,   ShapeKind::Motion,  ShapeKind::MedialAxis,
                ShapeKind::Toolpath, ShapeKind::Setup,  ShapeKind::Sequence};
  return png;
}

Format ogvFormat() {
  Format ogv;
  ogv.id = "ogv";
  ogv.title = "Film (Ogg Theora)";
  ogv.extensions = {"ogv"};
  ogv.writeOptions = filmOptions();
  ogv.write = writeFilm;
  ogv.writes = {ShapeKind::Sequence};
  return ogv;
}

}  // namespace blossom
