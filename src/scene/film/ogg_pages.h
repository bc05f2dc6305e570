#pragma once
#include <cstddef>
#include <filesystem>

namespace blossom {

/// What a film should have come out as.
struct TheoraFilm {
  int width = 0, height = 0;  ///< pixels that are shown: the upper left part of those that are stored
  std::size_t pictures = 0;
};

/// Reads an Ogg file of one Theora stream page by page, as vtkOggTheoraWriter has written it, and holds it to what it should
/// be: VTK does not notice when a disk is full. Sets the part of the pictures that is shown, which VTK cannot, and a serial
/// number that is no random one, so that the same film makes the same file. O(bytes), in the memory of a page.
/// @throws Error FileUnwritable when a page or a picture is missing or damaged.
void finishTheoraFile(const std::filesystem::path&, const TheoraFilm&);

}  // namespace blossom
