#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "core/progress.h"
#include "document/document.h"

namespace blossom {

/// Writes a .blossom file: a zip with `document.json` ({"blossom": format version, "features": [..]}) and `assets/<hash>`.
void saveDocument(const Document&, const std::filesystem::path&, const Progress& = Progress::none());

struct OpenedDocument {
  Document document;
  std::vector<std::string> warnings;  ///< what could not be read, in full sentences
};

/// @throws Error FileNotFound, FormatTooNew, FormatDamaged; with `salvage`, the readable part of a damaged file is returned
/// with warnings instead. The document may read only files in its folder (FileAccess::below).
OpenedDocument openDocument(const std::filesystem::path&, bool salvage = false);

/// Conversion to and from the text of document.json (pretty-printed, stable order).
std::string toJson(const Document&);
OpenedDocument fromJson(const std::string&, bool salvage = false);

/// SHA-256 of a content in hexadecimal digits, the name of an asset.
std::string contentHash(std::string_view content);

}  // namespace blossom
