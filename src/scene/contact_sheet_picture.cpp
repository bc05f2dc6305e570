#include <fmt/format.h>
#include <vtkRenderer.h>

#include <algorithm>

#include "core/error.h"
#include "core/file.h"
#include "geometry/shape/contact_sheet.h"
#include "geometry/shape/frame_times.h"
#include "scene/camera.h"
#include "scene/image_letters.h"
#include "scene/picture_drawing.h"
#include "scene/picture_image.h"
#include "scene/sequence_pictures.h"

namespace blossom {

namespace {

constexpr int smallestCell = 24;  // pixels

/// Cells of equal size on a picture, each a frame above the line of its time.
struct CellPlan {
  SheetGrid grid;
  int width = 0, height = 0;  // of a cell
  int letter = 1;             // pixels of the sheet for each of a letter
  int strip = 0;              // height of the line of the time
  [[nodiscard]] int pictureHeight() const { return height - strip; }
  [[nodiscard]] bool roomy() const { return width >= smallestCell && pictureHeight() >= smallestCell; }
};

CellPlan cellPlan(std::size_t cells, const PictureOptions& options, const Vec2& shape) {
  CellPlan plan;
  plan.letter = std::max(1, std::min(options.width, options.height) / 350);
  plan.strip = (letterHeight + 6) * plan.letter;
  plan.grid = sheetGrid(cells, shape, Vec2(options.width, options.height));
  plan.width = options.width / plan.grid.columns;
  plan.height = options.height / plan.grid.rows;
  return plan;
}

/// Width and height of what is seen, as it is seen.
Vec2 seenSize(const std::vector<Vec3>& points, const PictureOptions& options) {
  const Turn turn = turnOf(options.view, points);
  Vec2 low = Vec2::Constant(1e300), high = -low;
  for (const Vec3& p : points) {
    const Vec2 q(p.dot(turn.right()), p.dot(turn.up()));
    low = low.cwiseMin(q);
    high = high.cwiseMax(q);
  }
  const Vec2 size = high - low;
  return size.cwiseMax(Vec2::Constant(std::max(1e-3 * size.maxCoeff(), 1e-9)));
}

Sequence chosenFrames(const Sequence& sequence, std::size_t wanted) {
  Sequence chosen;
  for (const std::size_t k : spreadFrames(sequence.frames.size(), wanted)) {
    chosen.frames.push_back(sequence.frames[k]);
    if (sequence.times.size() == sequence.frames.size()) chosen.times.push_back(sequence.times[k]);
  }
  return chosen;
}

/// As many cells as have room, at most `wanted`.
CellPlan roomyPlan(std::size_t& wanted, const PictureOptions& options, const Vec2& shape) {
  for (; wanted > 0; --wanted)
    if (const CellPlan plan = cellPlan(wanted, options, shape); plan.roomy()) return plan;
  throw Error(ErrorCode::InvalidParameter,
              fmt::format("A contact sheet of {} x {} pixels has no room for a frame.", options.width, options.height),
              "Make the picture larger (size).");
}

Image drawCells(const Sequence& shown, const CellPlan& plan, const PictureOptions& cell, const SequenceView& view,
                const PictureOptions& options, const Progress& progress) {
  const std::size_t pixels = static_cast<std::size_t>(options.width) * static_cast<std::size_t>(options.height);
  Image sheet{options.width, options.height, std::vector<std::uint8_t>(4 * pixels)};
  const OnePictureAtATime turn(progress);
  OffscreenDrawer drawer(cell.width, cell.height, pictureSupersampling);
  const double count = static_cast<double>(shown.frames.size());
  for (std::size_t k = 0; k < shown.frames.size(); ++k) {
    const Progress part = progress.part(static_cast<double>(k) / count, static_cast<double>(k + 1) / count);
    paste(drawFrame(drawer, shown.frames[k], cell, view, part), sheet, plan.grid.column(k) * plan.width,
          plan.grid.row(k) * plan.height);
  }
  return sheet;
}

void writeTime(Image& sheet, const CellPlan& plan, std::size_t cell, const std::string& time, const Look& look) {
  const int left = plan.grid.column(cell) * plan.width, top = (plan.grid.row(cell) + 1) * plan.height - plan.strip;
  const int wide = static_cast<int>(time.size()) * letterWidth * plan.letter;
  writeLetters(sheet, left + std::max(0, (plan.width - wide) / 2), top + 2 * plan.letter, plan.letter, time,
               mixed(look.edge, look.curve, 0.9));
}

}  // namespace

std::size_t renderContactSheet(const Sequence& sequence, const std::filesystem::path& png, const PictureOptions& options,
                               int cells, const Progress& progress) {
  std::size_t count = std::min(static_cast<std::size_t>(std::max(1, cells)), sequence.frames.size());
  const SequenceView whole = viewOf(chosenFrames(sequence, count), options, progress.part(0, 0.15));
  const CellPlan plan = roomyPlan(count, options, seenSize(whole.seen, options));
  PictureOptions cell = options;
  cell.width = plan.width;
  cell.height = plan.pictureHeight();
  const Sequence shown = chosenFrames(sequence, count);
  const SequenceView view = viewOf(shown, cell, progress.part(0.15, 0.3));
  Image sheet = drawCells(shown, plan, cell, view, options, progress.part(0.3, 0.95));
  progress.report(0.95);
  finishImage(sheet, options, rangeOfBound(options.display, view.curvatureBound));
  const std::vector<std::size_t> frames = spreadFrames(sequence.frames.size(), count);
  for (std::size_t k = 0; k < count; ++k) writeTime(sheet, plan, k, frameLabel(sequence, frames[k]), lookOf(options));
  writeAtomically(png, pngOf(sheet, png, options.transparent ? 4 : 3));
  progress.report(1);
  return count;
}

}  // namespace blossom
