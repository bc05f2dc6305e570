#pragma once

namespace blossom {

inline constexpr const char* versionText = "0.1.0";
/// Version of the plugin interface. Raised whenever a plugin built against older headers could break; the loader refuses all
/// others.
inline constexpr int pluginApiVersion = 9;
/// Version of the format of .blossom documents.
inline constexpr int documentFormatVersion = 1;

}  // namespace blossom
