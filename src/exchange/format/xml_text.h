#pragma once
#include <string>
#include <string_view>

namespace blossom {

/// Text as it stands in an attribute of XML; control characters, which XML has not, are left out.
std::string escapedXml(std::string_view);

}  // namespace blossom
