#pragma once
#include <string>
#include <string_view>

namespace blossom {

/// Text escaped for an XML attribute; control characters, which XML does not allow, are left out.
std::string escapedXml(std::string_view);

}  // namespace blossom
