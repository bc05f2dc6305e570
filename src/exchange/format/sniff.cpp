#include "exchange/format/sniff.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstring>
#include <string>

#include "exchange/format/format.h"
#include "exchange/format/text.h"

// Only signatures that a file of another format cannot carry by accident: a wrong guess here would refuse a good file.
namespace blossom {
namespace {

bool isBlank(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\n'; }
bool isDigit(char c) { return c >= '0' && c <= '9'; }
bool contains(std::string_view text, std::string_view what) { return text.find(what) != std::string_view::npos; }

/// Takes the first line off the text; without its end.
std::string_view takeLine(std::string_view& text) {
  const std::size_t end = text.find('\n');
  const std::string_view line = text.substr(0, end);
  text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
  return line;
}

std::string_view takeWord(std::string_view& text) {
  text = parse::trimmed(text);
  const auto end = std::find_if(text.begin(), text.end(), isBlank);
  const auto length = static_cast<std::size_t>(end - text.begin());
  const std::string_view word = text.substr(0, length);
  text.remove_prefix(length);
  return word;
}

std::string_view withoutComments(std::string_view text, char mark) {
  for (;;) {
    text = parse::trimmed(text);
    if (text.empty() || text.front() != mark) return text;
    takeLine(text);
  }
}

bool isIges(std::string_view head) {
  const std::string_view line = takeLine(head);
  return line.size() >= 80 && line[72] == 'S' && isDigit(line[79]) &&
         std::all_of(line.begin() + 73, line.begin() + 80, [](char c) { return isDigit(c) || c == ' '; });
}

bool isOff(std::string_view head) {
  head = withoutComments(head, '#');
  const std::string_view word = takeWord(head);
  if (word.size() < 3 || word.size() > 8 || word.substr(word.size() - 3) != "OFF") return false;
  return std::all_of(word.begin(), word.end() - 3, [](char c) { return std::strchr("STCN4n", c) != nullptr; });
}

bool isDxf(std::string_view head) {
  if (head.substr(0, 18) == "AutoCAD Binary DXF") return true;
  while (parse::trimmed(std::string_view(head).substr(0, head.find('\n'))) == "999") {
    takeLine(head);
    takeLine(head);
  }
  return parse::trimmed(takeLine(head)) == "0" && parse::trimmed(takeLine(head)) == "SECTION";
}

bool isNumber(std::string_view word) {
  return !word.empty() && contains("+-.0123456789", word.substr(0, 1)) && std::any_of(word.begin(), word.end(), isDigit);
}

bool isObj(std::string_view head) {
  head = withoutComments(head, '#');
  for (int lines = 0; lines < 20 && !head.empty(); ++lines) {
    std::string_view line = parse::trimmed(takeLine(head));
    const std::string_view key = takeWord(line);
    if (key.empty() || key.front() == '#' || key == "o" || key == "g" || key == "s") continue;
    if (key == "mtllib") return true;
    return key == "v" && isNumber(takeWord(line)) && isNumber(takeWord(line)) && isNumber(takeWord(line));
  }
  return false;
}

bool isTextStl(std::string_view head) {
  return parse::trimmed(head).substr(0, 5) == "solid" && (contains(head, "facet normal") || contains(head, "endsolid"));
}

std::string_view foreignFormat(std::string_view head) {
  using Signature = std::pair<std::string_view, std::string_view>;
  static constexpr std::array<Signature, 6> signatures{{{"\x89PNG", "PNG"},
                                                        {"%PDF", "PDF"},
                                                        {"PK\x03\x04", "ZIP"},
                                                        {"\x1f\x8b", "GZIP"},
                                                        {"\xff\xd8\xff", "JPEG"},
                                                        {"\x7f"
                                                         "ELF",
                                                         "a program"}}};
  for (const auto& [start, name] : signatures)
    if (head.substr(0, start.size()) == start) return name;
  return {};
}

}  // namespace

bool looksLikeBinaryStl(std::string_view head, std::uintmax_t fileSize) {
  if (head.size() < 84) return false;
  const auto byte = [&](std::size_t i) { return static_cast<std::uint32_t>(static_cast<unsigned char>(head[i])); };
  const std::uint32_t facets = byte(80) | byte(81) << 8 | byte(82) << 16 | byte(83) << 24;
  return fileSize == 84 + 50 * static_cast<std::uintmax_t>(facets);
}

std::string sniffFormat(std::string_view head) {
  if (const std::string_view foreign = foreignFormat(head); !foreign.empty())
    return foreign == "ZIP" && contains(head, "3D/3dmodel.model") ? "3MF" : std::string(foreign);
  if (head.substr(0, 3) == "\xef\xbb\xbf") head.remove_prefix(3);
  const std::string_view text = parse::trimmed(head);
  if (contains(text.substr(0, 2000), "ISO-10303-21;")) return "STEP";
  if (contains(text.substr(0, 400), "DBRep_DrawableShape") || contains(text.substr(0, 400), "CASCADE Topology V"))
    return "BREP";
  if (isIges(head)) return "IGES";
  if (text.substr(0, 3) == "ply" && text.size() > 3 && isBlank(text[3])) return "PLY";
  if (isOff(text)) return "OFF";
  if (isDxf(text)) return "DXF";
  if (!text.empty() && text.front() == '<' && contains(text, "<svg")) return "SVG";
  if (isTextStl(text)) return "STL";
  if (isObj(text)) return "OBJ";
  return {};
}

}  // namespace blossom
