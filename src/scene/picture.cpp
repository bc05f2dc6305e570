#include <vtkRenderer.h>

#include "core/error.h"
#include "core/file.h"
#include "scene/picture_drawing.h"
#include "scene/picture_image.h"
#include "scene/picture_legend.h"
#include "scene/scene.h"

namespace blossom {

namespace {

std::vector<PictureDrawing> tessellateAll(const std::vector<Shape>& shapes, const PictureOptions& options,
                                          const Progress& progress) {
  std::vector<PictureDrawing> drawn;
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    const double count = static_cast<double>(shapes.size());
    const Progress part = progress.part(static_cast<double>(i) / count, static_cast<double>(i + 1) / count);
    PictureDrawing drawing = pictureDrawing(shapes[i], options, part);
    if (!drawing.shape.empty()) drawn.push_back(std::move(drawing));
  }
  if (drawn.empty()) throw Error(ErrorCode::InvalidInput, "There is nothing to draw.", "Give a shape with faces or curves.");
  return drawn;
}

}  // namespace

std::optional<CurvatureRange> renderPicture(const std::vector<Shape>& shapes, const std::filesystem::path& png,
                                            const PictureOptions& options, const Progress& progress) {
  checkSize(options);
  const std::vector<PictureDrawing> drawn = tessellateAll(shapes, options, progress.part(0, 0.5));
  const OnePictureAtATime turn(progress);
  const std::optional<CurvatureRange> range = rangeOfBound(options.display, curvatureBoundOf(drawn, options.display));
  Image image = drawOffscreen(
      options.width, options.height, pictureSupersampling,
      [&](vtkRenderer* renderer) {
        fillScene(renderer, drawn, options, options.width, options.height, range);
        fitCamera(renderer, options.view);
      },
      progress.part(0.5, 0.95));
  finishImage(image, options, range);
  writeAtomically(png, pngOf(image, png, options.transparent ? 4 : 3));
  progress.report(1);
  return range;
}

}  // namespace blossom
