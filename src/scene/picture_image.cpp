#include "scene/picture_image.h"

#include <fmt/format.h>
#include <vtkPNGWriter.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <cmath>

#include "core/error.h"
#include "scene/scene.h"

namespace blossom {

namespace {

std::size_t indexOf(const Image& image, int x, int y) {
  return (static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) + static_cast<std::size_t>(x)) * 4;
}

}  // namespace

void layOver(Image& image, const Look& look) {
  const auto blend = [](std::uint8_t& channel, double alpha, double behind) {
    channel = static_cast<std::uint8_t>(std::lround(channel * alpha + behind * 255 * (1 - alpha)));
  };
  for (int y = 0; y < image.height; ++y) {
    const Color behind = mixed(look.backgroundTop, look.backgroundBottom, (y + 0.5) / image.height);
    for (int x = 0; x < image.width; ++x) {
      std::uint8_t* pixel = &image.rgba[indexOf(image, x, y)];
      const double alpha = pixel[3] / 255.0;
      blend(pixel[0], alpha, behind.red);
      blend(pixel[1], alpha, behind.green);
      blend(pixel[2], alpha, behind.blue);
      pixel[3] = 255;
    }
  }
}

vtkSmartPointer<vtkImageData> imageData(const Image& image, int channels, int width, int height) {
  auto data = vtkSmartPointer<vtkImageData>::New();
  data->SetDimensions(width, height, 1);
  data->AllocateScalars(VTK_UNSIGNED_CHAR, channels);
  auto* to = static_cast<std::uint8_t*>(data->GetScalarPointer());
  for (int y = height - 1; y >= 0; --y)
    for (int x = 0; x < width; ++x) {
      const auto* from = &image.rgba[indexOf(image, std::min(x, image.width - 1), std::min(y, image.height - 1))];
      to = std::copy(from, from + channels, to);
    }
  return data;
}

std::string pngOf(const Image& image, const std::filesystem::path& path, int channels) {
  auto writer = vtkSmartPointer<vtkPNGWriter>::New();
  writer->SetInputData(imageData(image, channels, image.width, image.height));
  writer->WriteToMemoryOn();  // libpng reports a full disk only on stderr
  writer->Write();
  vtkUnsignedCharArray* bytes = writer->GetResult();
  if (writer->GetErrorCode() != 0 || !bytes)
    throw Error(ErrorCode::FileUnwritable, fmt::format("The picture {} could not be made.", path.string()));
  return {reinterpret_cast<const char*>(bytes->GetPointer(0)), static_cast<std::size_t>(bytes->GetNumberOfValues())};
}

void paste(const Image& from, Image& to, int left, int top) {
  for (int y = 0; y < from.height; ++y) {
    const auto row = from.rgba.begin() + static_cast<std::ptrdiff_t>(indexOf(from, 0, y));
    std::copy(row, row + static_cast<std::ptrdiff_t>(from.width) * 4,
              to.rgba.begin() + static_cast<std::ptrdiff_t>(indexOf(to, left, top + y)));
  }
}

}  // namespace blossom
