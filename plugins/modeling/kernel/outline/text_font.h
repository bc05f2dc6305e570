#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace blossom::modeling {

enum class FontStyle { Regular, Bold, Italic, BoldItalic };

/// A face of an installed font: its file and the index of the face in it.
struct FontFace {
  std::filesystem::path file;
  int index = 0;
  std::string family;
  std::string style;  ///< as named in the font: "Book", "Bold Oblique"
};

/// The scalable face of that family and style in fontconfig's database of installed fonts. Case-insensitive; there is no
/// substitution of missing fonts. Thread-safe.
std::optional<FontFace> installedFace(const std::string& family, FontStyle);
/// The faces of one family, and the names of all families; sorted.
std::vector<FontFace> installedFaces(const std::string& family);
std::vector<std::string> installedFamilies();

}  // namespace blossom::modeling
