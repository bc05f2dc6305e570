#pragma once
#include <filesystem>
#include <vector>

#include "document/document.h"

namespace blossom {

class Registry;

/// The content of every file that a feature names by its path is taken into the document as an asset, so that the document
/// can be moved away from its files; of the path the name of the file is kept. Files that the document may not read stay
/// named and are not read. @throws Error FileNotFound, FileUnreadable, LimitExceeded.
Document withFilesEmbedded(const Registry&, const Document&);
/// The same, but files that are not there stay named, too.
Document withFoundFilesEmbedded(const Registry&, const Document&);

/// The files outside of its folder that the document names and may not read.
std::vector<std::filesystem::path> withheldFiles(const Registry&, const Document&);

}  // namespace blossom
