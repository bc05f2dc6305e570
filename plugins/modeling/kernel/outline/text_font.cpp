#include "kernel/outline/text_font.h"

#include <fontconfig/fontconfig.h>

#include <algorithm>
#include <cstdlib>
#include <memory>
#include <mutex>
#include <set>

namespace blossom::modeling {
namespace {

struct Destroy {
  void operator()(FcPattern* pattern) const { FcPatternDestroy(pattern); }
  void operator()(FcObjectSet* set) const { FcObjectSetDestroy(set); }
  void operator()(FcFontSet* set) const { FcFontSetDestroy(set); }
};
template <class T>
using Owned = std::unique_ptr<T, Destroy>;

/// What the database says of one face.
struct Entry {
  FontFace face;
  int weight = FC_WEIGHT_REGULAR, slant = FC_SLANT_ROMAN, width = FC_WIDTH_NORMAL;
};

std::string textOf(FcPattern* pattern, const char* key) {
  FcChar8* text = nullptr;
  return FcPatternGetString(pattern, key, 0, &text) == FcResultMatch ? reinterpret_cast<const char*>(text) : "";
}

int numberOf(FcPattern* pattern, const char* key, int otherwise) {
  int value = 0;
  return FcPatternGetInteger(pattern, key, 0, &value) == FcResultMatch ? value : otherwise;
}

/// Faces that match; an empty family means all.
std::vector<Entry> entries(const std::string& family) {
  static std::mutex mutex;  // the first use builds the database
  const std::scoped_lock lock(mutex);
  const Owned<FcPattern> wanted(FcPatternCreate());
  FcPatternAddBool(wanted.get(), FC_SCALABLE, FcTrue);
  if (!family.empty()) FcPatternAddString(wanted.get(), FC_FAMILY, reinterpret_cast<const FcChar8*>(family.c_str()));
  const Owned<FcObjectSet> keys(
      FcObjectSetBuild(FC_FAMILY, FC_STYLE, FC_FILE, FC_INDEX, FC_WEIGHT, FC_SLANT, FC_WIDTH, nullptr));
  const Owned<FcFontSet> found(FcFontList(nullptr, wanted.get(), keys.get()));
  std::vector<Entry> result;
  for (int k = 0; found && k < found->nfont; ++k) {
    FcPattern* pattern = found->fonts[k];
    // The upper half of the index names an instance of a variable font; only plain faces are taken.
    const int index = numberOf(pattern, FC_INDEX, 0);
    if (index > 0xffff) continue;
    result.push_back({{textOf(pattern, FC_FILE), index, textOf(pattern, FC_FAMILY), textOf(pattern, FC_STYLE)},
                      numberOf(pattern, FC_WEIGHT, FC_WEIGHT_REGULAR),
                      numberOf(pattern, FC_SLANT, FC_SLANT_ROMAN),
                      numberOf(pattern, FC_WIDTH, FC_WIDTH_NORMAL)});
  }
  std::sort(result.begin(), result.end(), [](const Entry& a, const Entry& b) {
    return std::tie(a.face.family, a.face.style, a.face.file) < std::tie(b.face.family, b.face.style, b.face.file);
  });
  return result;
}

bool suits(const Entry& entry, FontStyle style) {
  const bool bold = entry.weight >= FC_WEIGHT_DEMIBOLD, slanted = entry.slant != FC_SLANT_ROMAN;
  return bold == (style == FontStyle::Bold || style == FontStyle::BoldItalic) &&
         slanted == (style == FontStyle::Italic || style == FontStyle::BoldItalic);
}

/// How far a face is from the plain one of its style: condensed and light ones come after it.
int strangeness(const Entry& entry, FontStyle style) {
  const bool bold = style == FontStyle::Bold || style == FontStyle::BoldItalic;
  return 10 * std::abs(entry.width - FC_WIDTH_NORMAL) + std::abs(entry.weight - (bold ? FC_WEIGHT_BOLD : FC_WEIGHT_REGULAR));
}

}  // namespace

std::optional<FontFace> installedFace(const std::string& family, FontStyle style) {
  if (family.empty()) return std::nullopt;
  std::vector<Entry> found = entries(family);
  std::erase_if(found, [&](const Entry& entry) { return !suits(entry, style); });
  const auto best = std::min_element(found.begin(), found.end(), [&](const Entry& a, const Entry& b) {
    return strangeness(a, style) < strangeness(b, style);
  });
  if (best == found.end()) return std::nullopt;
  return best->face;
}

std::vector<FontFace> installedFaces(const std::string& family) {
  std::vector<FontFace> faces;
  if (family.empty()) return faces;
  for (Entry& entry : entries(family)) faces.push_back(std::move(entry.face));
  return faces;
}

std::vector<std::string> installedFamilies() {
  std::set<std::string> families;
  for (Entry& entry : entries("")) families.insert(std::move(entry.face.family));
  families.erase("");
  return {families.begin(), families.end()};
}

}  // namespace blossom::modeling
