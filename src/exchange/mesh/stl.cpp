#include <fmt/format.h>

#include <array>
#include <cmath>
#include <unordered_map>

#include "core/file.h"
#include "core/units.h"
#include "exchange/format/bytes.h"
#include "exchange/format/format.h"
#include "exchange/format/mesh_options.h"
#include "exchange/format/sniff.h"
#include "exchange/format/text.h"

// Stereolithography, text and binary. STL has no shared vertices: equal ones become one here, so that a closed solid is
// closed.
namespace blossom {
namespace {

using namespace parse;

struct PointHash {
  std::size_t operator()(const std::array<double, 3>& p) const {
    std::size_t hash = 0;
    for (const double x : p) hash = hash * 0x9e3779b97f4a7c15ull + std::hash<double>()(x);
    return hash ^ hash >> 29;
  }
};

/// Collects facets; each one of the file becomes a face, also those without an area.
class FacetSink {
 public:
  void corner(double x, double y, double z) {
    // -0 and 0 are equal but hash apart.
    const auto [it, isNew] = indices_.try_emplace({x + 0.0, y + 0.0, z + 0.0}, static_cast<int>(mesh_.points.size()));
    if (isNew) mesh_.points.emplace_back(x, y, z);
    facet_[corners_++] = it->second;
    if (corners_ < 3) return;
    if (facet_[0] == facet_[1] || facet_[1] == facet_[2] || facet_[2] == facet_[0]) ++flat_;
    mesh_.addFace(facet_);
    corners_ = 0;
  }

  Imported take(std::string name) {
    std::vector<std::string> warnings;
    if (flat_ > 0)
      warnings.push_back(fmt::format("{} two equal corners and no area.",
                                     flat_ == 1 ? "1 facet has" : fmt::format("{} facets have", flat_)));
    mesh_.name = std::move(name);
    const std::size_t facets = mesh_.faceCount();
    Imported imported = importedMesh(std::move(mesh_), std::move(warnings));
    imported.entities = {{"facet", facets}};
    return imported;
  }

 private:
  Mesh mesh_;
  std::unordered_map<std::array<double, 3>, int, PointHash> indices_;
  std::array<int, 3> facet_{};
  std::size_t corners_ = 0, flat_ = 0;
};

Imported readBinary(std::string_view content, const Progress& progress) {
  ByteReader bytes(content.substr(80), std::endian::little);
  const std::uint32_t facets = bytes.take<std::uint32_t>();
  if (bytes.remaining() / 50 < facets)
    throw Error(ErrorCode::FormatDamaged,
                fmt::format("It announces {} facets, but has room for {}.", facets, bytes.remaining() / 50),
                "The file is damaged or was not written completely.");
  FacetSink sink;
  for (std::uint32_t f = 0; f < facets; ++f) {
    if (f % 8192 == 0) progress.check();
    for (int i = 0; i < 3; ++i) bytes.take<float>();  // the normal follows from the corners
    for (int i = 0; i < 3; ++i) {
      const float x = bytes.take<float>(), y = bytes.take<float>(), z = bytes.take<float>();
      if (!std::isfinite(x) || !std::isfinite(y) || !std::isfinite(z))
        throw Error(ErrorCode::FormatDamaged, fmt::format("Facet {} has a coordinate that is not a number.", f + 1));
      sink.corner(x, y, z);
    }
    bytes.take<std::uint16_t>();
  }
  return sink.take({});
}

/// solid NAME / facet normal x y z / outer loop / vertex x y z (3) / endloop / endfacet / endsolid NAME
class TextStl {
 public:
  explicit TextStl(std::string_view content) : lines_(content) {}

  Imported read(const Progress& progress) {
    std::string_view line;
    while (lines_.next(line)) {
      if (lines_.number() % 8192 == 0) progress.check();
      statement(line);
    }
    if (inFacet_ || inSolid_)
      throw damaged(lines_.number(), fmt::format("the file ends where {} is expected.", inFacet_ ? "endfacet" : "endsolid"));
    return sink_.take(std::move(name_));
  }

 private:
  void statement(std::string_view line) {
    const std::string_view key = takeWord(line);
    if (key.empty() || key == "outer" || key == "endloop") return;
    if (key == "solid") {
      expect(!inSolid_, key);
      inSolid_ = true;
      if (name_.empty()) name_ = utf8(trimmed(line));
    } else if (key == "endsolid") {
      expect(inSolid_ && !inFacet_, key);
      inSolid_ = false;
    } else if (key == "facet") {
      expect(inSolid_ && !inFacet_, key);
      inFacet_ = true;
      corners_ = 0;
    } else if (key == "endfacet") {
      expect(inFacet_, key);
      if (corners_ != 3) throw damaged(lines_.number(), fmt::format("a facet has 3 corners; this one has {}.", corners_));
      inFacet_ = false;
    } else if (key == "vertex") {
      expect(inFacet_ && corners_ < 3, key);
      vertex(line);
    } else {
      throw damaged(lines_.number(), fmt::format("{} is not an STL statement.", shown(key)));
    }
  }

  void expect(bool allowed, std::string_view key) const {
    if (!allowed) throw damaged(lines_.number(), fmt::format("{} cannot stand here.", shown(key)));
  }

  void vertex(std::string_view rest) {
    std::array<double, 3> point{};
    for (double& x : point) {
      const std::string_view word = takeWord(rest);
      const std::optional<double> value = toNumber(word);
      if (!value) throw damaged(lines_.number(), fmt::format("a coordinate is expected, but there is {}.", shown(word)));
      x = *value;
    }
    ++corners_;
    sink_.corner(point[0], point[1], point[2]);
  }

  Lines lines_;
  FacetSink sink_;
  std::string name_;
  bool inSolid_ = false, inFacet_ = false;
  int corners_ = 0;
};

Imported readStl(const std::filesystem::path& path, const Value&, const Progress& progress) {
  const std::string content = readFile(path);
  const bool saysSolid = trimmed(std::string_view(content).substr(0, 64)).substr(0, 5) == "solid";
  // The name in a binary header may begin with "solid" as well; then the size decides.
  if (looksLikeBinaryStl(content, content.size()) || (!saysSolid && content.size() >= 84))
    return readBinary(content, progress);
  return TextStl(content).read(progress);
}

Vec3 normalOf(const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 n = (b - a).cross(c - a);
  const double size = n.norm();
  return size > 0 ? Vec3(n / size) : Vec3(0, 0, 0);
}

using Corners = std::array<std::size_t, 3>;

/// Triangles of which two corners fall together in the numbers of the file enclose nothing and would join what only touches:
/// their neighbours close the surface without them.
template <class Number>
std::vector<Corners> facetsOf(const Tessellation& t) {
  const auto same = [&](std::size_t a, std::size_t b) {
    return (t.points[a].cast<Number>().array() == t.points[b].cast<Number>().array()).all();
  };
  std::vector<Corners> facets;
  facets.reserve(t.triangles.size());
  for (const auto& [a, b, c] : t.triangles) {
    const Corners f{static_cast<std::size_t>(a), static_cast<std::size_t>(b), static_cast<std::size_t>(c)};
    if (!same(f[0], f[1]) && !same(f[1], f[2]) && !same(f[2], f[0])) facets.push_back(f);
  }
  return facets;
}

void refuseNothing(const std::vector<Corners>& facets) {
  if (facets.empty())
    throw Error(ErrorCode::OutputNotSupported, "All triangles of the shape are without area, so there is nothing to write.",
                "Is it as large as it should be?");
}

std::string binaryStl(const Tessellation& t, const Progress& progress) {
  const std::vector<Corners> facets = facetsOf<float>(t);
  if (facets.empty() && !facetsOf<double>(t).empty())
    throw Error(
        ErrorCode::OutputNotSupported,
        "The shape lies so far from the origin for its size that nothing of it is left in the numbers of binary STL.",
        "Move it to the origin, or write text (--stl.ascii).");
  refuseNothing(facets);
  std::string out = "Blossom STL, lengths in mm";
  out.resize(80, ' ');
  appendLittleEndian(out, static_cast<std::uint32_t>(facets.size()));
  const auto append = [&](const Vec3& p) {
    for (int i = 0; i < 3; ++i) appendLittleEndian(out, static_cast<float>(p[i]));
  };
  writeEach(facets.size(), progress, [&](std::size_t f) {
    const auto& [a, b, c] = facets[f];
    append(normalOf(t.points[a], t.points[b], t.points[c]));
    for (const std::size_t corner : facets[f]) append(t.points[corner]);
    appendLittleEndian(out, std::uint16_t{0});
  });
  return out;
}

std::string textStl(const Tessellation& t, const Progress& progress) {
  const auto numbers = [](const Vec3& p) {
    return fmt::format("{} {} {}", formatNumber(p.x()), formatNumber(p.y()), formatNumber(p.z()));
  };
  const std::vector<Corners> facets = facetsOf<double>(t);
  refuseNothing(facets);
  std::string out = "solid blossom\n";
  writeEach(facets.size(), progress, [&](std::size_t f) {
    const auto& [a, b, c] = facets[f];
    out += fmt::format("facet normal {}\n outer loop\n", numbers(normalOf(t.points[a], t.points[b], t.points[c])));
    for (const std::size_t corner : facets[f]) out += fmt::format("  vertex {}\n", numbers(t.points[corner]));
    out += " endloop\nendfacet\n";
  });
  return out + "endsolid blossom\n";
}

void writeStl(const Shape& shape, const std::filesystem::path& path, const Value& options, const Progress& progress) {
  const Tessellation triangles = tessellate(shape, tessellationOptions(options), progress.part(0, 0.5));
  if (triangles.triangles.empty())
    throw Error(ErrorCode::OutputNotSupported, "The shape has no faces, so there is nothing to write as STL.",
                "It may be a curve, or a surface that has collapsed to a curve or a point.");
  const Progress writing = progress.part(0.5, 1);
  writeBytes(path, options.value("ascii", false) ? textStl(triangles, writing) : binaryStl(triangles, writing));
}

}  // namespace

Format stlFormat() {
  Format format;
  format.id = "stl";
  format.title = "STL (stereolithography)";
  format.extensions = {"stl"};
  format.writeOptions = {chordOption(), asciiOption()};
  format.read = readStl;
  format.write = writeStl;
  format.writes = meshableKinds();
  return format;
}

}  // namespace blossom
