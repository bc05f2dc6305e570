#include <fmt/format.h>
#include <vtkActor.h>
#include <vtkImageData.h>
#include <vtkLookupTable.h>
#include <vtkPNGWriter.h>
#include <vtkPolyData.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <cmath>
#include <mutex>
#include <optional>

#include "core/error.h"
#include "core/file.h"
#include "scene/offscreen.h"
#include "scene/onion_skin.h"
#include "scene/picture_legend.h"
#include "scene/scene.h"
#include "scene/shading.h"
#include "scene/surface_study.h"

namespace blossom {

namespace {

constexpr int largestSide = 32768;

void checkSize(const PictureOptions& options) {
  if (options.width >= 1 && options.height >= 1 && options.width <= largestSide && options.height <= largestSide) return;
  throw Error(ErrorCode::InvalidParameter, fmt::format("A picture has 1 to {} pixels a side; {}x{} was asked for.",
                                                       largestSide, options.width, options.height));
}

/// What a picture shows of one shape; of a sequence its last frame, and outlines of others around it.
struct Drawing {
  SceneData shape;
  std::vector<SceneData> frames;
  std::optional<SurfaceStudy> study;  // where the display needs one
};

/// Evenly spread, the first and the last among them.
std::vector<const Shape*> someFrames(const Sequence& sequence) {
  const std::size_t count = std::min(maximumSkins, sequence.frames.size());
  std::vector<const Shape*> frames;
  for (std::size_t k = 0; k < count; ++k)
    frames.push_back(&sequence.frames[count > 1 ? k * (sequence.frames.size() - 1) / (count - 1) : 0]);
  return frames;
}

bool needsStudy(SurfaceDisplay display) { return showsCurvature(display) || display == SurfaceDisplay::IsoCurves; }

Drawing drawingOf(const Shape& shape, const PictureOptions& options, const Progress& progress) {
  const TessellationOptions fineness{.chord = options.chord, .angle = 0.12};
  const auto drawn = [&](const Shape& each) { return toSceneData(tessellate(each, fineness, progress)); };
  Drawing drawing;
  const auto* sequence = shape.get<Sequence>();
  if (sequence && !sequence->frames.empty())
    for (const Shape* frame : someFrames(*sequence)) drawing.frames.push_back(drawn(*frame));
  if (needsStudy(options.display)) {
    drawing.study = studySurfaces(shape, fineness, options.isoCurves, progress);
    drawing.shape = drawing.study->scene;
  } else {
    drawing.shape = drawing.frames.empty() ? drawn(shape) : drawing.frames.back();
  }
  return drawing;
}

/// One scale for all shapes, by the one that bends most.
std::optional<CurvatureRange> rangeOf(const std::vector<Drawing>& drawn, SurfaceDisplay display) {
  double bound = 0;
  for (const Drawing& drawing : drawn)
    if (drawing.study) bound = std::max(bound, curvatureBound(*drawing.study, display));
  if (bound == 0) return std::nullopt;
  return curvatureRange(display, bound);
}

std::vector<Drawing> tessellateAll(const std::vector<Shape>& shapes, const PictureOptions& options,
                                   const Progress& progress) {
  std::vector<Drawing> drawn;
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    const double count = static_cast<double>(shapes.size());
    const Progress part = progress.part(static_cast<double>(i) / count, static_cast<double>(i + 1) / count);
    Drawing drawing = drawingOf(shapes[i], options, part);
    if (!drawing.shape.empty()) drawn.push_back(std::move(drawing));
  }
  if (drawn.empty()) throw Error(ErrorCode::InvalidInput, "There is nothing to draw.", "Give a shape with faces or curves.");
  return drawn;
}

// Lines keep their look at any size: their width follows the size of the picture.
double widthFactor(const PictureOptions& options, int supersampling) {
  return supersampling * std::max(1.0, std::min(options.width, options.height) / 900.0);
}

void fillScene(vtkRenderer* renderer, const std::vector<Drawing>& drawn, Look look, const PictureOptions& options,
               double factor) {
  look.edgeWidth *= factor;
  look.pointSize *= factor;
  setUpRenderer(renderer, look);
  const auto range = rangeOf(drawn, options.display);
  const auto colors = range ? curvatureColors(options.display, *range) : nullptr;
  // Stripes show creases better than the lines that hide them.
  const bool edges = options.edges && options.display != SurfaceDisplay::Zebra;
  for (const auto& [shape, frames, study] : drawn) {
    for (const auto& actor : makeActors(shape, look)) {
      if (!edges && shape.faces && roleOf(actor) == ActorRole::Edges) continue;
      if (roleOf(actor) == ActorRole::Faces && !shape.planar)
        shadeFaces(*actor, false, {options.display, options.zebra, colors});
      renderer->AddActor(actor);
    }
    if (study && study->isoCurves && options.display == SurfaceDisplay::IsoCurves)
      renderer->AddActor(makeIsoCurveActor(study->isoCurves, look));
    for (const auto& skin : onionSkin(frames, look, 1, 1)) renderer->AddViewProp(skin);
  }
  fitCamera(renderer, options.view);
}

void layOver(Image& image, const Look& look) {
  const auto blend = [](std::uint8_t& channel, double alpha, double behind) {
    channel = static_cast<std::uint8_t>(std::lround(channel * alpha + behind * 255 * (1 - alpha)));
  };
  for (int y = 0; y < image.height; ++y) {
    const Color behind = mixed(look.backgroundTop, look.backgroundBottom, (y + 0.5) / image.height);
    for (int x = 0; x < image.width; ++x) {
      std::uint8_t* pixel =
          &image.rgba[(static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) + static_cast<std::size_t>(x)) *
                      4];
      const double alpha = pixel[3] / 255.0;
      blend(pixel[0], alpha, behind.red);
      blend(pixel[1], alpha, behind.green);
      blend(pixel[2], alpha, behind.blue);
      pixel[3] = 255;
    }
  }
}

/// The content of a PNG file; `path` is what an error calls it.
std::string pngOf(const Image& image, const std::filesystem::path& path, int channels) {
  auto data = vtkSmartPointer<vtkImageData>::New();
  data->SetDimensions(image.width, image.height, 1);
  data->AllocateScalars(VTK_UNSIGNED_CHAR, channels);
  auto* to = static_cast<std::uint8_t*>(data->GetScalarPointer());
  for (int y = image.height - 1; y >= 0; --y)  // VTK counts rows from the bottom
    for (int x = 0; x < image.width; ++x) {
      const auto* from =
          &image.rgba[(static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) + static_cast<std::size_t>(x)) *
                      4];
      to = std::copy(from, from + channels, to);
    }
  auto writer = vtkSmartPointer<vtkPNGWriter>::New();
  writer->SetInputData(data);
  writer->WriteToMemoryOn();  // libpng reports a full disk only on stderr
  writer->Write();
  vtkUnsignedCharArray* bytes = writer->GetResult();
  if (writer->GetErrorCode() != 0 || !bytes)
    throw Error(ErrorCode::FileUnwritable, fmt::format("The picture {} could not be made.", path.string()));
  return {reinterpret_cast<const char*>(bytes->GetPointer(0)), static_cast<std::size_t>(bytes->GetNumberOfValues())};
}

}  // namespace

std::optional<CurvatureRange> renderPicture(const std::vector<Shape>& shapes, const std::filesystem::path& png,
                                            const PictureOptions& options, const Progress& progress) {
  static std::mutex onePictureAtATime;
  checkSize(options);
  const std::vector<Drawing> drawn = tessellateAll(shapes, options, progress.part(0, 0.5));
  const std::scoped_lock lock(onePictureAtATime);
  const Look look = options.lightTheme ? Look::light() : Look::dark();
  const int supersampling = 2;
  Image image = drawOffscreen(
      options.width, options.height, supersampling,
      [&](vtkRenderer* renderer) { fillScene(renderer, drawn, look, options, widthFactor(options, supersampling)); },
      progress.part(0.5, 0.95));
  if (!options.transparent) layOver(image, look);
  const std::optional<CurvatureRange> range = rangeOf(drawn, options.display);
  if (range) drawLegend(image, options.display, *range, look);
  writeAtomically(png, pngOf(image, png, options.transparent ? 4 : 3));
  progress.report(1);
  return range;
}

}  // namespace blossom
