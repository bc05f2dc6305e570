#include "scene/film/film.h"

#include <fmt/format.h>
#include <vtkImageData.h>
#include <vtkOggTheoraWriter.h>

#include <cmath>

#include "core/error.h"
#include "core/file.h"
#include "geometry/shape/frame_times.h"
#include "scene/film/ogg_pages.h"
#include "scene/picture_drawing.h"
#include "scene/picture_image.h"

namespace blossom {

namespace {

constexpr int largestFilmSide = 4096;  // pixels: a picture is compressed within what a user waits for a cancelled film
constexpr int blockSide = 16;          // of Theora

int wholeBlocks(int side) { return (side + blockSide - 1) / blockSide * blockSide; }

void checkFilm(const FilmOptions& options) {
  const PictureOptions& picture = options.picture;
  if (picture.width < 1 || picture.height < 1 || std::max(picture.width, picture.height) > largestFilmSide)
    throw Error(ErrorCode::InvalidParameter, fmt::format("A film has 1 to {} pixels a side; {}x{} was asked for.",
                                                         largestFilmSide, picture.width, picture.height));
  if (!(options.seconds > 0 && options.seconds <= 3600) || options.rate < 1 || options.rate > 120)
    throw Error(ErrorCode::InvalidParameter, "A film lasts up to an hour and has 1 to 120 pictures per second.");
}

/// VTK's writer, with pictures padded to whole blocks: it would leave what lies beyond them to chance.
class FilmWriter {
 public:
  FilmWriter(const std::filesystem::path& file, const FilmOptions& options) : file_(file), options_(options) {
    writer_->SetFileName(file.c_str());
    writer_->SetRate(options.rate);
    writer_->SetInputData(imageData(Image{1, 1, {0, 0, 0, 255}}, 3, 1, 1));
    writer_->Start();
    refuseFailed();
  }

  void show(const Image& image) {
    writer_->SetInputData(imageData(image, 3, wholeBlocks(options_.picture.width), wholeBlocks(options_.picture.height)));
  }

  /// Adds what is shown once more.
  void addPicture() {
    writer_->Write();
    refuseFailed();
    ++pictures_;
  }

  void finish() {
    writer_->End();
    refuseFailed();
    finishTheoraFile(file_, {options_.picture.width, options_.picture.height, pictures_});
  }

 private:
  void refuseFailed() const {
    if (writer_->GetError() != 0) cannotWrite(file_, "the film cannot be made");
  }

  const std::filesystem::path& file_;
  const FilmOptions& options_;
  std::size_t pictures_ = 0;
  vtkSmartPointer<vtkOggTheoraWriter> writer_ = vtkSmartPointer<vtkOggTheoraWriter>::New();
};

}  // namespace

std::size_t renderFilm(const Sequence& sequence, const std::filesystem::path& file, const FilmOptions& given,
                       const Progress& progress) {
  checkFilm(given);
  FilmOptions options = given;
  options.picture.transparent = false;
  const SequenceView view = viewOf(sequence, options.picture, progress.part(0, 0.1));
  const auto range = rangeOfBound(options.picture.display, view.curvatureBound);
  const std::vector<double> begins = frameBeginnings(sequence);
  const auto count = static_cast<std::size_t>(std::max(1L, std::lround(options.seconds * options.rate)));
  const OnePictureAtATime turn(progress);
  OffscreenDrawer drawer(options.picture.width, options.picture.height, pictureSupersampling);
  FilmWriter writer(file, options);
  for (std::size_t k = 0, shown = sequence.frames.size(); k < count; ++k) {
    progress.report(0.1 + 0.9 * static_cast<double>(k) / static_cast<double>(count), "Filming");
    const std::size_t frame = frameAt(begins, (static_cast<double>(k) + 0.5) / static_cast<double>(count));
    if (frame != shown) {
      Image image = drawFrame(drawer, sequence.frames[frame], options.picture, view, Progress(progress.token()));
      finishImage(image, options.picture, range);
      writer.show(image);
      shown = frame;
    }
    writer.addPicture();
  }
  writer.finish();
  progress.report(1);
  return count;
}

}  // namespace blossom
