#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <span>

#include "exchange/dxf/dxf_groups.h"

namespace blossom {

using namespace parse;

namespace {

using Groups = std::span<const DxfGroup>;

/// dxflib reads lines of up to 1024 characters and waits for ever at longer ones.
constexpr std::size_t longestValue = 1000;
constexpr int hatchStyle = 75, hatchSeeds = 98;

struct KnownType {
  std::string_view name;
  std::vector<int> codes;  ///< groups that are passed on, besides layer, colour and extrusion
};

const std::vector<KnownType>& knownTypes() {
  static const std::vector<KnownType> types{
      {"LINE", {10, 20, 30, 11, 21, 31}},
      {"ARC", {10, 20, 30, 40, 50, 51}},
      {"CIRCLE", {10, 20, 30, 40}},
      {"ELLIPSE", {10, 20, 30, 11, 21, 31, 40, 41, 42}},
      {"LWPOLYLINE", {70, 38, 10, 20, 42}},
      {"POLYLINE", {10, 20, 30, 70}},
      {"VERTEX", {10, 20, 30, 42, 70}},
      {"SEQEND", {}},
      {"SPLINE", {70, 71, 40, 10, 20, 30, 41, 11, 21, 31, 12, 22, 13, 23}},
      {"HATCH", {10, 20, 30, 11, 21, 12, 22, 13, 23, 40, 42, 50, 51, 72, 73, 74, 91, 92, 93, 94, 95, 96, 97}},
      {"INSERT", {2, 10, 20, 30, 41, 42, 43, 44, 45, 50, 70, 71}},
      {"LAYER", {2, 70}},
      {"BLOCK", {2, 70, 10, 20, 30}},
      {"ENDBLK", {}},
  };
  return types;
}

const KnownType* knownType(std::string_view name) {
  const auto& types = knownTypes();
  const auto it = std::find_if(types.begin(), types.end(), [&](const KnownType& t) { return t.name == name; });
  return it == types.end() ? nullptr : &*it;
}

bool isCommon(int code) { return code == 8 || code == 62 || code == 420 || code == 210 || code == 220 || code == 230; }
bool isReal(int code) { return (code >= 10 && code <= 59) || (code >= 210 && code <= 239); }
bool isText(int code) { return code == 2 || code == 8; }

std::size_t count(Groups groups, int code) {
  return static_cast<std::size_t>(
      std::count_if(groups.begin(), groups.end(), [&](const DxfGroup& g) { return g.code == code; }));
}

std::string_view valueOf(Groups groups, int code) {
  const auto it = std::find_if(groups.begin(), groups.end(), [&](const DxfGroup& g) { return g.code == code; });
  return it == groups.end() ? std::string_view() : it->value;
}

int flagsOf(Groups groups, int code = 70) { return toInteger(valueOf(groups, code)).value_or(0); }

class Cleaner {
 public:
  explicit Cleaner(const std::vector<DxfGroup>& groups) : groups_(groups) {}

  CleanDxf clean(const Progress& progress) {
    while (at_ < groups_.size()) {
      progress.check();
      section(progress);
    }
    if (!entitiesSeen_)
      throw Error(ErrorCode::FormatDamaged, "It has no ENTITIES section.", "The file is damaged or holds no drawing.");
    begin("EOF", groups_.back().line);
    return std::move(out_);
  }

 private:
  /// A group 0 and all that belongs to it, to the next group 0.
  Groups takeObject() {
    const std::size_t first = at_++;
    while (at_ < groups_.size() && groups_[at_].code != 0) ++at_;
    return Groups(groups_).subspan(first, at_ - first);
  }

  void section(const Progress& progress) {
    if (groups_[at_].code == 0 && groups_[at_].value == "EOF") {
      at_ = groups_.size();
      return;
    }
    if (groups_[at_].code == 999) {  // a comment
      ++at_;
      return;
    }
    const Groups head = takeObject();
    if (head[0].code != 0 || head[0].value != "SECTION" || head.size() < 2 || head[1].code != 2)
      throw damaged(head[0].line,
                    fmt::format("a SECTION with its name is expected, but there is {}.", shown(head[0].value)));
    const std::string_view name = head[1].value;
    if (name == "HEADER") header(head.subspan(2));
    blockLine_ = 0;
    for (;;) {
      if (at_ >= groups_.size() || groups_[at_].value == "EOF" || groups_[at_].value == "SECTION")
        throw damaged(head[0].line, fmt::format("the section {} has no end.", shown(name)));
      if (at_ % 1024 == 0) progress.check();
      const Groups object = takeObject();
      if (object[0].value == "ENDSEC") break;
      if (name == "TABLES" && object[0].value == "LAYER")
        emit(object, *knownType("LAYER"));
      else if (name == "BLOCKS")
        blockObject(object);
      else if (name == "ENTITIES")
        entity(object);
    }
    if (blockLine_ > 0) throw damaged(blockLine_, "the BLOCK has no ENDBLK.");
    entitiesSeen_ = entitiesSeen_ || name == "ENTITIES";
  }

  void header(Groups groups) {
    for (std::size_t i = 0; i + 1 < groups.size(); ++i) {
      if (groups[i].code != 9 || groups[i].value != "$INSUNITS") continue;
      if (!toInteger(groups[i + 1].value))
        throw damaged(groups[i + 1].line,
                      fmt::format("$INSUNITS needs a number, but there is {}.", shown(groups[i + 1].value)));
      begin("$INSUNITS", groups[i].line, 9);
      append(70, groups[i + 1].value);
    }
  }

  void blockObject(Groups object) {
    const std::string_view type = object[0].value;
    if (type == "BLOCK") {
      if (blockLine_ > 0) throw damaged(object[0].line, "a BLOCK begins inside of another one.");
      blockLine_ = object[0].line;
      if (valueOf(object, 2).empty()) throw damaged(object[0].line, "a BLOCK has no name.");
    }
    if (type == "ENDBLK") {
      if (blockLine_ == 0) throw damaged(object[0].line, "ENDBLK stands without its BLOCK.");
      blockLine_ = 0;
    }
    if (type == "VERTEX" || type == "SEQEND") {
      part(object);
      return;
    }
    const KnownType* known = knownType(type);
    skipParts_ = type == "POLYLINE" && isHidden(object);
    if (known && known->name != "LAYER" && !isHidden(object)) emit(object, *known);
  }

  /// A VERTEX or SEQEND belongs to the POLYLINE (or, a SEQEND, to the attributes of an INSERT) before it.
  void part(Groups object) {
    if (!skipParts_) emit(object, *knownType(object[0].value));
    if (object[0].value == "SEQEND") skipParts_ = false;
  }

  /// Invisible, or a POLYLINE that is a net of faces.
  static bool isHidden(Groups object) {
    const bool isNet = object[0].value == "POLYLINE" && (flagsOf(object) & (16 | 64)) != 0;
    return isNet || flagsOf(object, 60) == 1;
  }

  void entity(Groups object) {
    const std::string_view type = object[0].value;
    if (type == "VERTEX" || type == "SEQEND") {
      part(object);
      return;
    }
    skipParts_ = false;
    const KnownType* known = knownType(type);
    if (type == "LAYER" || type == "BLOCK" || type == "ENDBLK") known = nullptr;
    const bool inPaperSpace = flagsOf(object, 67) == 1;
    if (inPaperSpace) ++out_.inPaperSpace;
    if (type == "POINT" && !inPaperSpace) {
      ++out_.points;
      out_.entities.add(type);
    } else if (!known || inPaperSpace || isHidden(object)) {
      skipParts_ = type == "POLYLINE";
      out_.skipped.add(type);
    } else {
      emit(object, *known);
      out_.entities.add(type);
    }
  }

  void emit(Groups object, const KnownType& type) {
    // Control points of a spline-fitted polyline are not on the curve.
    if (type.name == "VERTEX" && (flagsOf(object) & 16) != 0) return;
    begin(type.name, object[0].line);
    if (type.name == "LWPOLYLINE") lightPolyline(object);
    if (type.name == "SPLINE") splineCounts(object);
    if (type.name == "INSERT" && valueOf(object, 2).empty())
      throw damaged(object[0].line, "an INSERT does not tell its block.");
    for (const DxfGroup& g : object.subspan(1)) {
      if (type.name == "HATCH" && (g.code == hatchStyle || g.code == hatchSeeds)) break;
      // The names of layers and blocks come once; a hatch has group 2 for its pattern, others for more.
      if (isCommon(g.code) || std::find(type.codes.begin(), type.codes.end(), g.code) != type.codes.end())
        append(checked(g));
    }
  }

  /// dxflib writes a bulge before the first vertex to a place in front of its array.
  void lightPolyline(Groups object) {
    const std::size_t vertices = count(object, 10);
    if (vertices == 0) throw damaged(object[0].line, "a LWPOLYLINE has no vertices.");
    for (const DxfGroup& g : object) {
      if (g.code == 10) break;
      if (g.code == 20 || g.code == 42) throw damaged(g.line, "a LWPOLYLINE has a value before its first vertex.");
    }
    append(90, std::to_string(vertices));
  }

  void splineCounts(Groups object) {
    const std::size_t knots = count(object, 40), poles = count(object, 10), fits = count(object, 11),
                      weights = count(object, 41);
    const std::size_t line = object[0].line;
    const int degree = valueOf(object, 71).empty() ? 3 : flagsOf(object, 71);
    if (degree < 1 || degree > 25) throw damaged(line, fmt::format("a SPLINE has the degree {}.", degree));
    if (poles == 0 && fits < 2) throw damaged(line, "a SPLINE has neither poles nor fit points.");
    if (poles > 0 && poles < static_cast<std::size_t>(degree) + 1)
      throw damaged(line, fmt::format("a SPLINE of degree {} has {} poles.", degree, poles));
    if (poles > 0 && knots != poles + static_cast<std::size_t>(degree) + 1)
      throw damaged(line, fmt::format("a SPLINE of degree {} with {} poles needs {} knots; it has {}.", degree, poles,
                                      poles + static_cast<std::size_t>(degree) + 1, knots));
    if (weights != 0 && weights != poles)
      throw damaged(line, fmt::format("a SPLINE has {} poles, but {} weights.", poles, weights));
    if (count(object, 20) != poles || count(object, 21) != fits)
      throw damaged(line, "a SPLINE has poles with one coordinate only.");
    append(72, std::to_string(poles > 0 ? knots : 0));
    append(73, std::to_string(poles));
    append(74, std::to_string(fits));
  }

  /// A number as dxflib reads it; names as they are.
  std::pair<int, std::string> checked(const DxfGroup& g) {
    if (isText(g.code)) {
      if (g.value.size() > longestValue) throw damaged(g.line, "a name is longer than 1000 characters.");
      return {g.code, std::string(g.value)};
    }
    const std::optional<double> number = toNumber(g.value);
    if (!number || g.value.size() > longestValue)
      throw damaged(g.line, fmt::format("a number is expected for group {}, but there is {}.", g.code, shown(g.value)));
    if (std::abs(*number) > 1e12) throw damaged(g.line, fmt::format("the number {} is too large.", shown(g.value)));
    if (isReal(g.code)) return {g.code, fmt::format("{}", *number)};
    return {g.code, std::to_string(static_cast<long long>(*number))};
  }

  void begin(std::string_view type, std::size_t line, int code = 0) {
    append(code, type);
    out_.objects.push_back({line, std::string(type)});
  }
  void append(int code, std::string_view value) { fmt::format_to(std::back_inserter(out_.text), "{}\n{}\n", code, value); }
  void append(const std::pair<int, std::string>& group) { append(group.first, group.second); }

  const std::vector<DxfGroup>& groups_;
  std::size_t at_ = 0;
  CleanDxf out_;
  std::size_t blockLine_ = 0;  ///< of the BLOCK that is open; 0: none
  bool skipParts_ = false;     ///< the POLYLINE before was left out
  bool entitiesSeen_ = false;
};

}  // namespace

CleanDxf cleanDxf(const std::vector<DxfGroup>& groups, const Progress& progress) { return Cleaner(groups).clean(progress); }

}  // namespace blossom
