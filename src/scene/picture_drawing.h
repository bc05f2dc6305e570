#pragma once
#include <mutex>
#include <optional>
#include <vector>

#include "scene/offscreen.h"
#include "scene/scene.h"
#include "scene/sequence_pictures.h"
#include "scene/surface_study.h"

/// What pictures, contact sheets and films are made of.
namespace blossom {

/// What a picture shows of one shape; of a sequence its last frame, and outlines of others around it.
struct PictureDrawing {
  SceneData shape;
  std::vector<SceneData> frames;
  std::optional<SurfaceStudy> study;  ///< where the display needs one
};

inline constexpr int pictureSupersampling = 2;

/// @throws Error InvalidParameter for a size that no picture has.
void checkSize(const PictureOptions&);
Look lookOf(const PictureOptions&);

/// @throws Error as tessellate and studySurfaces.
PictureDrawing pictureDrawing(const Shape&, const PictureOptions&, const Progress&);
/// All of its points.
std::vector<Vec3> pointsOf(const PictureDrawing&);
/// The end of the scale for all shapes, by the one that bends most; 0 when no curvature is shown.
double curvatureBoundOf(const std::vector<PictureDrawing>&, SurfaceDisplay);
std::optional<CurvatureRange> rangeOfBound(SurfaceDisplay, double bound);

/// Adds lights and actors; the camera stays where it is.
/// @param width, height of the picture that it is drawn for: lines keep their look at any size
void fillScene(vtkRenderer*, const std::vector<PictureDrawing>&, const PictureOptions&, int width, int height,
               const std::optional<CurvatureRange>&);

/// A frame of a sequence in the view that all of its frames share, without canvas and legend. The drawer is of the size in
/// the options.
Image drawFrame(OffscreenDrawer&, const Shape&, const PictureOptions&, const SequenceView&, const Progress&);

/// Lays the image over its canvas and adds the legend of curvatures.
void finishImage(Image&, const PictureOptions&, const std::optional<CurvatureRange>&);

/// Held while pictures are drawn: contexts of OpenGL are not made on two threads at once.
class OnePictureAtATime {
 public:
  /// Waits for its turn. @throws Error Cancelled.
  explicit OnePictureAtATime(const Progress&);

 private:
  std::unique_lock<std::mutex> lock_;
};

}  // namespace blossom
