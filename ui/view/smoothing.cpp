#include "ui/view/smoothing.h"

#include <QPainter>
#include <array>
#include <bit>
#include <cstring>

namespace blossom::ui {

namespace {

// Eight queens on a grid of eighths of a pixel: every row and column has one, so that edges of every slope get eight steps.
constexpr std::array<std::array<int, 2>, Smoothing::frames> places{
    {{0, 0}, {-3, -1}, {1, -3}, {3, 1}, {-1, 3}, {-2, -4}, {2, 2}, {-4, 4}}};

constexpr std::uint32_t pair = 0x00FF00FF, opaque = 0xFF000000;

/// The line of a picture that the line `y` of a frame belongs to.
std::uint32_t* lineOf(QImage& picture, int y) {
  return reinterpret_cast<std::uint32_t*>(picture.scanLine(picture.height() - 1 - y));
}

}  // namespace

QPointF Smoothing::offset() const {
  const auto& place = places[static_cast<std::size_t>(taken_ % frames)];
  return QPointF(place[0], place[1]) / frames;
}

bool Smoothing::take(const std::vector<std::uint32_t>& frame, QImage& picture) {
  const auto width = static_cast<std::size_t>(picture.width());
  if (taken_++ == 0) {
    for (int y = 0; y < picture.height(); ++y)
      std::memcpy(lineOf(picture, y), &frame[static_cast<std::size_t>(y) * width], width * sizeof(std::uint32_t));
    return true;
  }
  if (taken_ == 2) {  // the picture is the first frame still
    redAndBlue_.assign(frame.size(), 0);
    green_.assign(frame.size(), 0);
    for (int y = 0; y < picture.height(); ++y) {
      const std::uint32_t* line = lineOf(picture, y);
      for (std::size_t x = 0; x < width; ++x) {
        redAndBlue_[static_cast<std::size_t>(y) * width + x] = line[x] & pair;
        green_[static_cast<std::size_t>(y) * width + x] = (line[x] >> 8) & 0xFF;
      }
    }
  }
  add(frame);
  if (!std::has_single_bit(static_cast<unsigned>(taken_))) return false;
  showMean(picture);
  return true;
}

void Smoothing::add(const std::vector<std::uint32_t>& frame) {
  for (std::size_t i = 0; i < frame.size(); ++i) {
    redAndBlue_[i] += frame[i] & pair;
    green_[i] += (frame[i] >> 8) & 0xFF;
  }
}

void Smoothing::showMean(QImage& picture) const {
  const int shift = std::countr_zero(static_cast<unsigned>(taken_));
  const std::uint32_t half = 1U << (shift - 1), halves = half << 16 | half;
  const auto width = static_cast<std::size_t>(picture.width());
  for (int y = 0; y < picture.height(); ++y) {
    std::uint32_t* line = lineOf(picture, y);
    const std::size_t start = static_cast<std::size_t>(y) * width;
    for (std::size_t x = 0; x < width; ++x)
      line[x] = opaque | (((redAndBlue_[start + x] + halves) >> shift) & pair) | ((green_[start + x] + half) >> shift) << 8;
  }
}

void showEnlarged(const std::vector<std::uint32_t>& frame, QSize size, QImage& picture) {
  const QImage whole(reinterpret_cast<const uchar*>(frame.data()), size.width(), size.height(), QImage::Format_RGB32);
  QPainter painter(&picture);
  painter.setRenderHint(QPainter::SmoothPixmapTransform);
  painter.drawImage(QRectF(QPointF(), QSizeF(picture.size()) / picture.devicePixelRatio()), whole.mirrored());
}

}  // namespace blossom::ui
