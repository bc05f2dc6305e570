#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace blossom::modeling {

enum class FontStyle { Regular, Bold, Italic, BoldItalic };

/// A face of an installed font: its file and the place of the face in it.
struct FontFace {
  std::filesystem::path file;
  int index = 0;
  std::string family;
  std::string style;  ///< as the font itself calls it: "Book", "Bold Oblique"
};

/// The scalable face of that family and style, by fontconfig's database of installed fonts. Case does not matter; nothing is
/// put in place of a font that is not there. Thread-safe.
std::optional<FontFace> installedFace(const std::string& family, FontStyle);
/// The faces of one family, and all families; sorted.
std::vector<FontFace> installedFaces(const std::string& family);
std::vector<std::string> installedFamilies();

}  // namespace blossom::modeling
