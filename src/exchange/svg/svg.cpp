#include "core/file.h"
#include "exchange/format/format.h"
#include "exchange/format/frames.h"
#include "exchange/svg/svg_read.h"
#include "exchange/svg/svg_write.h"

namespace blossom {

Format svgFormat() {
  ParameterSpec tolerance = positiveLength();
  tolerance.name = "tolerance";
  tolerance.help = "Largest distance between a spline and the cubic pieces that stand for it.";
  tolerance.fallback = 1e-3;

  ParameterSpec animate = flag();
  animate.name = "animate";
  animate.help = "Put all frames of a sequence into one file that plays them, instead of a file each.";
  animate.fallback = false;

  ParameterSpec seconds = number(0.01, 3600);
  seconds.name = "seconds";
  seconds.help = "Duration of an animation in seconds; it repeats endlessly.";
  seconds.fallback = 2.0;

  Format format;
  format.id = "svg";
  format.title = "SVG (scalable vector graphics)";
  format.extensions = {"svg"};
  format.writeOptions = {tolerance, animate, seconds, sheetOption()};
  format.read = [](const std::filesystem::path& path, const Value&, const Progress& progress) {
    const std::string content = readFile(path);
    return svg::readDocument(content, progress);
  };
  format.write = [](const Shape& shape, const std::filesystem::path& file, const Value& given, const Progress& progress) {
    svg::writeDocument(shape, file, given, progress);
  };
  format.frameWriter = [](const Sequence& sequence, const Value& given, const Progress& looking) -> Format::Write {
    return [page = svg::sharedPage(sequence, given, looking)](const Shape& frame, const std::filesystem::path& file,
                                                              const Value& options, const Progress& progress) {
      svg::writeDocument(frame, file, options, progress, &page);
    };
  };
  format.inOneFile = [](const Value& given) { return given.value("animate", false) || sheetCells(given) > 0; };
  format.writes = {ShapeKind::Curves, ShapeKind::Region, ShapeKind::MedialAxis, ShapeKind::Toolpath, ShapeKind::Sequence};
  return format;
}

}  // namespace blossom
