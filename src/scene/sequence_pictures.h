#pragma once
#include <filesystem>
#include <memory>
#include <vector>

#include "core/progress.h"
#include "scene/scene.h"

namespace blossom {

/// What the pictures of all frames of a sequence share, so that what stands still in it stays at its pixels.
struct SequenceView {
  std::vector<Vec3> seen;     ///< points that decide on the camera; not empty
  double chord = 0;           ///< mm
  double curvatureBound = 0;  ///< the end of the scale of colours; 0 when none is shown
};

/// Looks at every frame. The view is that of pictures of the size in the options. O(points), and a study of every frame
/// where curvature is shown. @throws Error InvalidParameter; InvalidInput when there is nothing to draw; Cancelled.
SequenceView viewOf(const Sequence&, const PictureOptions&, const Progress&);

/// Draws the frames of a sequence as PNG files of one view, one after the other, in one OpenGL context: on the thread that
/// made it, and no other pictures are drawn in this process meanwhile.
class FramePictures {
 public:
  /// Looks at every frame. @throws Error as viewOf; Internal with the driver's message when no context can be created.
  FramePictures(const Sequence&, const PictureOptions&, const Progress& = Progress::none());
  ~FramePictures();
  FramePictures(const FramePictures&) = delete;
  FramePictures& operator=(const FramePictures&) = delete;

  /// An empty frame is the canvas. @throws Error FileUnwritable, Cancelled.
  void write(const Shape& frame, const std::filesystem::path& png, const Progress& = Progress::none());

 private:
  struct Drawing;
  std::unique_ptr<Drawing> drawing_;
};

/// Up to `cells` frames, evenly spread, beside each other in one PNG file of the size in the options, each with its time,
/// all of them with the same camera. There are fewer where cells would have less than 24 pixels a side. @returns the number
/// of cells. @throws Error as renderPicture; InvalidParameter when not even one cell has room.
std::size_t renderContactSheet(const Sequence&, const std::filesystem::path& png, const PictureOptions&, int cells,
                               const Progress& = Progress::none());

}  // namespace blossom
