#include "exchange/dxf/dxf_groups.h"

#include <fmt/format.h>

namespace blossom {

using namespace parse;

std::vector<DxfGroup> scanDxf(std::string_view content, const Progress& progress) {
  if (content.substr(0, 18) == "AutoCAD Binary DXF")
    throw Error(ErrorCode::FormatDamaged, "It is a binary DXF file.", "Save it as text (ASCII) DXF.");
  if (content.substr(0, 3) == "\xef\xbb\xbf") content.remove_prefix(3);
  std::vector<DxfGroup> groups;
  Lines lines(content);
  std::string_view code, value;
  while (lines.next(code)) {
    if (groups.size() % 65536 == 0) progress.check();
    const std::size_t codeLine = lines.number();
    const std::optional<int> number = toInteger(trimmed(code));
    if (!number || *number < -5 || *number > 5000)
      throw damaged(codeLine, fmt::format("a group code is expected, but there is {}.", shown(trimmed(code))));
    if (!lines.next(value)) throw damaged(codeLine, "the file ends after a group code.");
    groups.push_back({*number, trimmed(value), lines.number()});
    if (*number == 0 && groups.back().value == "EOF") return groups;
  }
  throw damaged(lines.number(), "the file ends before its EOF.");
}

}  // namespace blossom
