#pragma once
#include <set>
#include <string>

#include "document/document_json.h"

namespace blossom {

/// Hashes of the assets that a feature, or what later versions wrote, names. Assets that only undone steps name are left
/// out. Types of parameters need not be known: their plugin may be missing.
std::set<std::string> namedAssets(const Document&);

/// Reports every imported file whose content is not there.
void checkAssets(const Document&, Problems&);

}  // namespace blossom
