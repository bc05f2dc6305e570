#include "scene/sequence_pictures.h"

#include <vtkRenderer.h>

#include <algorithm>

#include "core/error.h"
#include "core/file.h"
#include "geometry/shape/bounds.h"
#include "scene/camera.h"
#include "scene/picture_drawing.h"
#include "scene/picture_image.h"

namespace blossom {

namespace {

/// As fine as the largest frame would be drawn alone: curves that stand still are divided in the same way in all frames.
double chordFor(const Sequence& sequence, const PictureOptions& options) {
  if (options.chord > 0) return options.chord;
  Bounds all;
  const auto curved = [](const Shape& frame) {
    return frame.kind() == ShapeKind::Brep || frame.kind() == ShapeKind::Surface;
  };
  for (const Shape& frame : sequence.frames) all.add(bounds(frame));
  return all.diagonal() / (std::any_of(sequence.frames.begin(), sequence.frames.end(), curved) ? 1000 : 8000);
}

PictureOptions withChord(PictureOptions options, double chord) {
  options.chord = chord;
  return options;
}

void refuseEmpty(const std::vector<Vec3>& seen) {
  if (seen.empty())
    throw Error(ErrorCode::InvalidInput, "There is nothing to draw in any frame.", "Give shapes with faces or curves.");
}

}  // namespace

SequenceView viewOf(const Sequence& sequence, const PictureOptions& options, const Progress& progress) {
  checkSize(options);
  SequenceView view;
  view.chord = chordFor(sequence, options);
  PictureOptions looking = withChord(options, view.chord);
  if (!showsCurvature(looking.display)) looking.display = SurfaceDisplay::Plain;
  const double aspect = static_cast<double>(options.width) / options.height,
               count = static_cast<double>(sequence.frames.size());
  for (std::size_t k = 0; k < sequence.frames.size(); ++k) {
    progress.report(static_cast<double>(k) / count, "Looking at the frames");
    const std::vector<PictureDrawing> drawn{pictureDrawing(sequence.frames[k], looking, Progress(progress.token()))};
    for (const Vec3& p : outermostPoints(pointsOf(drawn.front()), options.view, aspect)) view.seen.push_back(p);
    view.curvatureBound = std::max(view.curvatureBound, curvatureBoundOf(drawn, options.display));
  }
  refuseEmpty(view.seen);
  view.seen = outermostPoints(view.seen, options.view, aspect);
  return view;
}

struct FramePictures::Drawing {
  Drawing(const Sequence& sequence, const PictureOptions& given, const Progress& progress)
      : options(given),
        view(viewOf(sequence, given, progress)),
        turn(progress),
        drawer(given.width, given.height, pictureSupersampling) {}

  PictureOptions options;
  SequenceView view;
  OnePictureAtATime turn;
  OffscreenDrawer drawer;
};

FramePictures::FramePictures(const Sequence& sequence, const PictureOptions& options, const Progress& progress)
    : drawing_(std::make_unique<Drawing>(sequence, options, progress)) {}

FramePictures::~FramePictures() = default;

void FramePictures::write(const Shape& frame, const std::filesystem::path& png, const Progress& progress) {
  const PictureOptions& options = drawing_->options;
  Image image = drawFrame(drawing_->drawer, frame, options, drawing_->view, progress);
  finishImage(image, options, rangeOfBound(options.display, drawing_->view.curvatureBound));
  writeAtomically(png, pngOf(image, png, options.transparent ? 4 : 3));
  progress.report(1);
}

Image drawFrame(OffscreenDrawer& drawer, const Shape& frame, const PictureOptions& options, const SequenceView& view,
                const Progress& progress) {
  const std::vector<PictureDrawing> drawn{pictureDrawing(frame, withChord(options, view.chord), Progress(progress.token()))};
  const auto range = rangeOfBound(options.display, view.curvatureBound);
  return drawer.draw(
      [&](vtkRenderer* renderer) {
        fillScene(renderer, drawn, options, options.width, options.height, range);
        fitCameraTo(view.seen, renderer, options.view);
      },
      progress);
}

}  // namespace blossom
