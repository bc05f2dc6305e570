#include "exchange/mesh/ply_header.h"

#include <fmt/format.h>

#include <array>
#include <utility>

#include "core/error.h"
#include "exchange/format/text.h"

namespace blossom {
namespace {

using namespace parse;

PlyType plyType(std::string_view word, std::size_t line) {
  static constexpr std::array<std::pair<std::string_view, PlyType>, 16> names{{{"char", PlyType::Int8},
                                                                               {"int8", PlyType::Int8},
                                                                               {"uchar", PlyType::UInt8},
                                                                               {"uint8", PlyType::UInt8},
                                                                               {"short", PlyType::Int16},
                                                                               {"int16", PlyType::Int16},
                                                                               {"ushort", PlyType::UInt16},
                                                                               {"uint16", PlyType::UInt16},
                                                                               {"int", PlyType::Int32},
                                                                               {"int32", PlyType::Int32},
                                                                               {"uint", PlyType::UInt32},
                                                                               {"uint32", PlyType::UInt32},
                                                                               {"float", PlyType::Float32},
                                                                               {"float32", PlyType::Float32},
                                                                               {"double", PlyType::Float64},
                                                                               {"float64", PlyType::Float64}}};
  for (const auto& [name, type] : names)
    if (name == word) return type;
  throw damaged(line, fmt::format("{} is not a type of PLY.", shown(word)));
}

PlyEncoding plyEncoding(std::string_view word, std::size_t line) {
  if (word == "ascii") return PlyEncoding::Text;
  if (word == "binary_little_endian") return PlyEncoding::Little;
  if (word == "binary_big_endian") return PlyEncoding::Big;
  throw damaged(line, fmt::format("{} is not an encoding of PLY.", shown(word)));
}

/// Minimum size of one element in bytes, to check its count.
std::size_t minimumSize(const PlyElement& element, PlyEncoding encoding) {
  std::size_t size = 0;
  for (const PlyProperty& p : element.properties)
    size += encoding == PlyEncoding::Text ? 2 : byteSize(p.countType.value_or(p.type));
  return size;
}

class PlyHeaderReader {
 public:
  explicit PlyHeaderReader(std::string_view content) : content_(content), lines_(content) {}

  PlyHeader read() {
    std::string_view line;
    if (!lines_.next(line) || trimmed(line) != "ply") throw damaged(1, "the word ply is expected.");
    while (lines_.next(line)) {
      std::string_view rest = line;
      const std::string_view key = takeWord(rest);
      if (key == "end_header") return finished(line);
      statement(key, rest);
    }
    throw damaged(lines_.number(), "the file ends where end_header is expected.");
  }

 private:
  void statement(std::string_view key, std::string_view rest) {
    if (key == "format") {
      header_.encoding = plyEncoding(takeWord(rest), lines_.number());
      formatGiven_ = true;
    } else if (key == "element") {
      element(rest);
    } else if (key == "property") {
      property(rest);
    } else if (key != "comment" && key != "obj_info" && !key.empty()) {
      throw damaged(lines_.number(), fmt::format("{} is not a statement of a PLY header.", shown(key)));
    }
  }

  void element(std::string_view rest) {
    const std::string_view name = takeWord(rest), word = takeWord(rest);
    const std::optional<int> count = toInteger(word);
    if (name.empty() || !count || *count < 0) throw damaged(lines_.number(), "an element needs a name and a count.");
    if (header_.elements.size() >= 100) throw damaged(lines_.number(), "there are more than 100 elements.");
    header_.elements.push_back({std::string(name), static_cast<std::size_t>(*count), {}});
  }

  void property(std::string_view rest) {
    if (header_.elements.empty()) throw damaged(lines_.number(), "a property stands before any element.");
    std::vector<PlyProperty>& properties = header_.elements.back().properties;
    if (properties.size() >= 1000) throw damaged(lines_.number(), "an element has more than 1000 properties.");
    PlyProperty property;
    std::string_view word = takeWord(rest);
    if (word == "list") {
      property.countType = plyType(takeWord(rest), lines_.number());
      word = takeWord(rest);
    }
    property.type = plyType(word, lines_.number());
    property.name = takeWord(rest);
    properties.push_back(std::move(property));
  }

  PlyHeader finished(std::string_view line) {
    if (!formatGiven_) throw damaged(lines_.number(), "the header does not tell its format.");
    header_.lines = lines_.number();
    header_.bytes = static_cast<std::size_t>(line.data() + line.size() - content_.data());
    if (header_.bytes < content_.size() && content_[header_.bytes] == '\r') ++header_.bytes;
    if (header_.bytes < content_.size() && content_[header_.bytes] == '\n') ++header_.bytes;
    for (const PlyElement& e : header_.elements) {
      const std::size_t minimum = minimumSize(e, header_.encoding);
      if (e.count > 0 && minimum > 0 && e.count > (content_.size() - header_.bytes + 2) / minimum)
        throw damaged(header_.lines,
                      fmt::format("the header announces {} of {}, which this file cannot hold.", e.count, shown(e.name)));
    }
    return std::move(header_);
  }

  std::string_view content_;
  Lines lines_;
  PlyHeader header_;
  bool formatGiven_ = false;
};

}  // namespace

std::size_t byteSize(PlyType type) {
  constexpr std::array<std::size_t, 8> sizes{1, 1, 2, 2, 4, 4, 4, 8};
  return sizes[static_cast<std::size_t>(type)];
}

PlyHeader readPlyHeader(std::string_view content) { return PlyHeaderReader(content).read(); }

}  // namespace blossom
