#pragma once
#include <set>
#include <string>

#include "document/document_json.h"

namespace blossom {

/// Hashes of the assets named by a feature or by keys of newer versions; assets named only by undone steps are left out. The
/// types of parameters need not be known, because their plugin may be missing.
std::set<std::string> namedAssets(const Document&);

/// Reports every imported file without content.
void checkAssets(const Document&, Problems&);

}  // namespace blossom
