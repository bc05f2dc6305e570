#include "core/file.h"
#include "exchange/format.h"
#include "exchange/svg_read.h"
#include "exchange/svg_write.h"

namespace blossom {

Format svgFormat() {
  ParameterSpec tolerance = positiveLength();
  tolerance.name = "tolerance";
  tolerance.help = "Largest distance between a spline and the cubic pieces that stand for it.";
  tolerance.fallback = 1e-3;

  Format format;
  format.id = "svg";
  format.title = "SVG (scalable vector graphics)";
  format.extensions = {"svg"};
  format.writeOptions = {tolerance};
  format.read = [](const std::filesystem::path& path, const Value&, const Progress& progress) {
    const std::string content = readFile(path);
    return svg::readDocument(content, progress);
  };
  format.write = svg::writeDocument;
  format.writes = {ShapeKind::Curves, ShapeKind::Region, ShapeKind::MedialAxis, ShapeKind::Toolpath};
  return format;
}

}  // namespace blossom
