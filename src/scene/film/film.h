#pragma once
#include <filesystem>

#include "core/progress.h"
#include "scene/scene.h"

namespace blossom {

struct FilmOptions {
  PictureOptions picture;  ///< of each picture; a film is never transparent; at most 4096 pixels a side
  double seconds = 2;      ///< of the whole film, above 0
  int rate = 25;           ///< pictures per second, 1..120
};

/// Writes a sequence as a film: Theora video in an Ogg file, by VTK. Each frame is shown in its own time (see
/// frameBeginnings), all of them with one camera. The file depends on nothing but the arguments. Written to the path given:
/// atomicity is the caller's affair. @returns the number of pictures. O(pictures times pixels).
/// @throws Error InvalidParameter; InvalidInput when there is nothing to draw; FileUnwritable, also when the disk is full;
/// Internal as renderPicture; Cancelled, between two pictures.
std::size_t renderFilm(const Sequence&, const std::filesystem::path&, const FilmOptions&,
                       const Progress& = Progress::none());

}  // namespace blossom
