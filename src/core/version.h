#pragma once

namespace blossom {

inline constexpr const char* versionText = "0.1.0";
/// Raised whenever a plugin built against an older header could break; the loader refuses other numbers.
inline constexpr int pluginApiVersion = 2;
/// Format of .blossom documents.
inline constexpr int documentFormatVersion = 1;

}  // namespace blossom
