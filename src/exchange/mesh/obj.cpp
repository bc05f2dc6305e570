#include <fmt/format.h>

#include <cctype>

#include "core/file.h"
#include "core/units.h"
#include "exchange/format/format.h"
#include "exchange/format/mesh_options.h"
#include "exchange/format/text.h"

// Wavefront OBJ: vertices, polygons and, as OpenSubdiv writes them, `t` lines with the tags of a subdivision cage:
// `t NAME integers/floats/strings values..`, whose vertex indices count from zero.
namespace blossom {
namespace {

using namespace parse;

constexpr std::size_t longestStatement = 1 << 20;

class ObjReader {
 public:
  ObjReader(std::string_view content, const Progress& progress) : progress_(progress), lines_(content) {}

  Imported read() {
    std::string joined;
    std::string_view line;
    while (nextStatement(line, joined)) {
      if (lines_.number() % 4096 == 0) progress_.check();
      statement(line);
    }
    checkIndices();
    Imported imported = importedMesh(std::move(mesh_), warnings());
    imported.skipped = skipped_.toValue();
    return imported;
  }

 private:
  /// A line, or several joined by a backslash at their ends.
  bool nextStatement(std::string_view& line, std::string& joined) {
    if (!lines_.next(line)) return false;
    if (line.empty() || line.back() != '\\') return true;
    joined.assign(line.substr(0, line.size() - 1));
    while (lines_.next(line)) {
      const bool more = !line.empty() && line.back() == '\\';
      joined.append(" ").append(line.substr(0, line.size() - (more ? 1 : 0)));
      if (joined.size() > longestStatement) throw damaged(lines_.number(), "a statement is longer than 1 MB.");
      if (!more) break;
    }
    line = joined;
    return true;
  }

  void statement(std::string_view line) {
    std::string_view rest = line.substr(0, line.find('#'));
    const std::string_view whole = trimmed(rest);
    const std::string_view key = takeWord(rest);
    if (key.empty()) return;
    if (key == "v")
      vertex(rest);
    else if (key == "f" || key == "fo")
      face(rest);
    else if (key == "t")
      tag(rest, whole);
    else if (key == "o" || key == "g")
      name(key, rest);
    else
      other(key);
  }

  void vertex(std::string_view rest) {
    Vec3 point;
    for (int i = 0; i < 3; ++i) point[i] = number(takeWord(rest), "a coordinate");
    mesh_.points.push_back(point);
  }

  void face(std::string_view rest) {
    corners_.clear();
    for (std::string_view word = takeWord(rest); !word.empty(); word = takeWord(rest)) {
      if (corners_.size() % 4096 == 0) progress_.check();
      corners_.push_back(vertexIndex(word));
    }
    if (corners_.size() < 3)
      throw damaged(lines_.number(), fmt::format("a face needs 3 vertices or more; it has {}.", corners_.size()));
    mesh_.addFace(corners_);
    faceLines_.push_back(lines_.number());
  }

  /// "7", "7/1", "7/1/2", "7//2"; negative ones count back from the last vertex so far.
  int vertexIndex(std::string_view word) {
    const std::optional<int> index = toInteger(word.substr(0, word.find('/')));
    if (!index || *index == 0) throw damaged(lines_.number(), fmt::format("{} is not a vertex number.", shown(word)));
    for (const char c : word)
      if (c != '/' && c != '-' && c != '+' && (c < '0' || c > '9'))
        throw damaged(lines_.number(), fmt::format("{} is not a vertex number.", shown(word)));
    if (*index > 0) return *index - 1;
    const long long back = static_cast<long long>(mesh_.points.size()) + *index;
    if (back < 0)
      throw damaged(lines_.number(), fmt::format("a face counts {} vertices back, but only {} stand before it.",
                                                 -static_cast<long long>(*index), mesh_.points.size()));
    return static_cast<int>(back);
  }

  void tag(std::string_view rest, std::string_view whole) {
    const std::string_view name = takeWord(rest), counts = takeWord(rest);
    if (name == "crease" && counts == "2/1/0") {
      const int from = tagIndex(takeWord(rest)), to = tagIndex(takeWord(rest));
      mesh_.creases.push_back({from, to, number(takeWord(rest), "a sharpness")});
      creaseLines_.push_back(lines_.number());
    } else if (name == "corner" && counts == "1/1/0") {
      const int vertex = tagIndex(takeWord(rest));
      mesh_.corners.push_back({vertex, number(takeWord(rest), "a sharpness")});
      cornerLines_.push_back(lines_.number());
    } else {
      mesh_.otherTags.push_back(utf8(whole));
    }
  }

  int tagIndex(std::string_view word) {
    const std::optional<int> index = toInteger(word);
    if (!index || *index < 0)
      throw damaged(lines_.number(), fmt::format("a tag needs a vertex index; it has {}.", shown(word)));
    return *index;
  }

  void name(std::string_view key, std::string_view rest) {
    const std::string_view given = trimmed(rest);
    ++(key == "o" ? objects_ : groups_);
    if (!given.empty() && (mesh_.name.empty() || (key == "o" && objects_ == 1))) mesh_.name = utf8(given);
  }

  void other(std::string_view key) {
    for (const char c : key)
      if (!std::isalnum(static_cast<unsigned char>(c)) && c != '_')
        throw damaged(lines_.number(), fmt::format("{} is not an OBJ statement.", shown(key)));
    skipped_.add(key);
  }

  double number(std::string_view word, const char* what) {
    if (const std::optional<double> value = toNumber(word)) return *value;
    throw damaged(lines_.number(),
                  fmt::format("{} is expected, but there is {}.", what, word.empty() ? "nothing" : shown(word)));
  }

  /// Faces and tags may come before their vertices, so this waits for the end.
  void checkIndices() const {
    const int count = static_cast<int>(mesh_.points.size());
    const auto check = [&](int index, std::size_t line, int base) {
      if (index >= count) throw damaged(line, fmt::format("vertex {} is used, but there are only {}.", index + base, count));
    };
    for (std::size_t f = 0; f < mesh_.faceCount(); ++f) {
      if (f % 4096 == 0) progress_.check();
      for (const int v : mesh_.face(f)) check(v, faceLines_[f], 1);
    }
    for (std::size_t i = 0; i < mesh_.creases.size(); ++i) {
      check(mesh_.creases[i].from, creaseLines_[i], 0);
      check(mesh_.creases[i].to, creaseLines_[i], 0);
    }
    for (std::size_t i = 0; i < mesh_.corners.size(); ++i) check(mesh_.corners[i].vertex, cornerLines_[i], 0);
  }

  [[nodiscard]] std::vector<std::string> warnings() const {
    std::vector<std::string> list;
    if (objects_ > 1) list.push_back(fmt::format("{} objects became one mesh.", objects_));
    for (const char* lost : {"l", "p", "curv", "surf"})
      if (const auto it = skipped_.counts().find(lost); it != skipped_.counts().end())
        list.push_back(
            fmt::format("{} statements \"{}\" (lines, points or free-form pieces) were left out.", it->second, lost));
    return list;
  }

  const Progress& progress_;
  Lines lines_;
  Mesh mesh_;
  std::vector<int> corners_;
  std::vector<std::size_t> faceLines_, creaseLines_, cornerLines_;
  std::size_t objects_ = 0, groups_ = 0;
  Counter skipped_;
};

void writeObj(const Shape& shape, const std::filesystem::path& path, const Value& options, const Progress& progress) {
  const Mesh mesh = meshOf(shape, tessellationOptions(options), progress.part(0, 0.4));
  std::string out = "# Blossom\n";
  if (!mesh.name.empty()) out += "o " + mesh.name + "\n";
  writeEach(mesh.points.size(), progress.part(0.4, 0.7), [&](std::size_t i) {
    const Vec3& p = mesh.points[i];
    out += fmt::format("v {} {} {}\n", formatNumber(p.x()), formatNumber(p.y()), formatNumber(p.z()));
  });
  writeEach(mesh.faceCount(), progress.part(0.7, 1), [&](std::size_t f) {
    out += 'f';
    for (const int v : mesh.face(f)) out += fmt::format(" {}", v + 1);
    out += '\n';
  });
  for (const std::string& tag : mesh.otherTags) out += tag + "\n";
  for (const Crease& c : mesh.creases)
    out += fmt::format("t crease 2/1/0 {} {} {}\n", c.from, c.to, formatNumber(c.sharpness));
  for (const Corner& c : mesh.corners) out += fmt::format("t corner 1/1/0 {} {}\n", c.vertex, formatNumber(c.sharpness));
  writeBytes(path, out);
}

}  // namespace

Format objFormat() {
  Format format;
  format.id = "obj";
  format.title = "OBJ (Wavefront)";
  format.extensions = {"obj"};
  format.writeOptions = {chordOption()};
  format.read = [](const std::filesystem::path& path, const Value&, const Progress& progress) {
    const std::string content = readFile(path);
    return ObjReader(content, progress).read();
  };
  format.write = writeObj;
  format.writes = meshableKinds();
  return format;
}

}  // namespace blossom
