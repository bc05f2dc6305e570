#pragma once
#include <vtkImageData.h>
#include <vtkSmartPointer.h>

#include <filesystem>
#include <string>

#include "scene/offscreen.h"

namespace blossom {

struct Look;

/// Lays a transparent image over the canvas, which becomes darker downwards. O(pixels).
void layOver(Image&, const Look&);

/// For VTK, which counts rows from the bottom. @param channels 3 or 4  @param width, height at least those of the image:
/// what lies beyond its right and lower edge repeats that edge.
vtkSmartPointer<vtkImageData> imageData(const Image&, int channels, int width, int height);

/// The content of a PNG file. @param path how an error calls it @throws Error FileUnwritable.
std::string pngOf(const Image&, const std::filesystem::path& path, int channels);

/// Copies an image into another one, which has room for it there.
void paste(const Image& from, Image& to, int left, int top);

}  // namespace blossom
