#include "scene/picture_drawing.h"

#include <fmt/format.h>
#include <vtkActor.h>
#include <vtkLookupTable.h>
#include <vtkPolyData.h>
#include <vtkRenderer.h>

#include <algorithm>
#include <chrono>
#include <thread>

#include "core/error.h"
#include "geometry/shape/frame_times.h"
#include "scene/onion_skin.h"
#include "scene/picture_image.h"
#include "scene/picture_legend.h"
#include "scene/shading.h"

namespace blossom {

namespace {

constexpr int largestSide = 32768;

bool needsStudy(SurfaceDisplay display) { return showsCurvature(display) || display == SurfaceDisplay::IsoCurves; }

double widthFactor(int width, int height) { return pictureSupersampling * std::max(1.0, std::min(width, height) / 900.0); }

void addPoints(vtkPolyData* data, std::vector<Vec3>& points) {
  const vtkIdType count = data ? data->GetNumberOfPoints() : 0;
  for (vtkIdType i = 0; i < count; ++i) {
    Vec3 p;
    data->GetPoint(i, p.data());
    points.push_back(p);
  }
}

std::mutex onePictureAtATime;

}  // namespace

void checkSize(const PictureOptions& options) {
  if (options.width >= 1 && options.height >= 1 && options.width <= largestSide && options.height <= largestSide) return;
  throw Error(ErrorCode::InvalidParameter, fmt::format("A picture has 1 to {} pixels a side; {}x{} was asked for.",
                                                       largestSide, options.width, options.height));
}

Look lookOf(const PictureOptions& options) { return options.lightTheme ? Look::light() : Look::dark(); }

PictureDrawing pictureDrawing(const Shape& shape, const PictureOptions& options, const Progress& progress) {
  const TessellationOptions fineness{.chord = options.chord, .angle = 0.12};
  const auto drawn = [&](const Shape& each) { return toSceneData(tessellate(each, fineness, progress)); };
  PictureDrawing drawing;
  const auto* sequence = shape.get<Sequence>();
  if (sequence && !sequence->frames.empty())
    for (const std::size_t k : spreadFrames(sequence->frames.size(), maximumSkins))
      drawing.frames.push_back(drawn(sequence->frames[k]));
  if (needsStudy(options.display)) {
    drawing.study = studySurfaces(shape, fineness, options.isoCurves, progress);
    drawing.shape = drawing.study->scene;
  } else {
    drawing.shape = drawing.frames.empty() ? drawn(shape) : drawing.frames.back();
  }
  return drawing;
}

std::vector<Vec3> pointsOf(const PictureDrawing& drawing) {
  std::vector<Vec3> points;
  for (vtkPolyData* data : {drawing.shape.faces.Get(), drawing.shape.edges.Get(), drawing.shape.points.Get()})
    addPoints(data, points);
  return points;
}

double curvatureBoundOf(const std::vector<PictureDrawing>& drawn, SurfaceDisplay display) {
  double bound = 0;
  for (const PictureDrawing& drawing : drawn)
    if (drawing.study) bound = std::max(bound, curvatureBound(*drawing.study, display));
  return bound;
}

std::optional<CurvatureRange> rangeOfBound(SurfaceDisplay display, double bound) {
  if (bound == 0) return std::nullopt;
  return curvatureRange(display, bound);
}

void fillScene(vtkRenderer* renderer, const std::vector<PictureDrawing>& drawn, const PictureOptions& options, int width,
               int height, const std::optional<CurvatureRange>& range) {
  Look look = lookOf(options);
  const double factor = widthFactor(width, height);
  look.edgeWidth *= factor;
  look.pointSize *= factor;
  setUpRenderer(renderer, look);
  const auto colors = range ? curvatureColors(options.display, *range) : nullptr;
  // Stripes show creases better than the lines that hide them.
  const bool edges = options.edges && options.display != SurfaceDisplay::Zebra;
  for (const auto& [shape, frames, study] : drawn) {
    for (const auto& actor : makeActors(shape, look)) {
      if (!edges && shape.faces && roleOf(actor) == ActorRole::Edges) continue;
      if (roleOf(actor) == ActorRole::Faces && !shape.planar) shadeFaces(*actor, {options.display, options.zebra, colors});
      renderer->AddActor(actor);
    }
    if (study && study->isoCurves && options.display == SurfaceDisplay::IsoCurves)
      renderer->AddActor(makeIsoCurveActor(study->isoCurves, look));
    for (const auto& skin : onionSkin(frames, look, 1, 1)) renderer->AddViewProp(skin);
  }
}

void finishImage(Image& image, const PictureOptions& options, const std::optional<CurvatureRange>& range) {
  const Look look = lookOf(options);
  if (!options.transparent) layOver(image, look);
  if (range) drawLegend(image, options.display, *range, look);
}

OnePictureAtATime::OnePictureAtATime(const Progress& progress) : lock_(onePictureAtATime, std::defer_lock) {
  while (!lock_.try_lock()) {
    progress.check();
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
}

}  // namespace blossom
