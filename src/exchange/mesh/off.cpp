#include <fmt/format.h>

#include "core/file.h"
#include "core/units.h"
#include "exchange/format/format.h"
#include "exchange/format/mesh_options.h"
#include "exchange/format/text.h"

// Geomview's Object File Format: OFF with its prefixes ST, C and N, whose extra columns are passed over.
namespace blossom {
namespace {

using namespace parse;

class OffReader {
 public:
  OffReader(std::string_view content, const Progress& progress)
      : progress_(progress), size_(content.size()), lines_(content) {}

  Imported read() {
    std::string_view line = dataLine("the word OFF");
    header(takeWord(line));
    if (trimmed(line).empty()) line = dataLine("the number of vertices and faces");
    const std::size_t vertices = count(takeWord(line), "vertices"), faces = count(takeWord(line), "faces");
    mesh_.points.reserve(vertices);
    for (std::size_t i = 0; i < vertices; ++i) {
      if (i % 4096 == 0) progress_.check();
      vertex(dataLine(fmt::format("vertex {} of {}", i + 1, vertices)));
    }
    for (std::size_t i = 0; i < faces; ++i) {
      if (i % 4096 == 0) progress_.check();
      face(dataLine(fmt::format("face {} of {}", i + 1, faces)));
    }
    return importedMesh(std::move(mesh_));
  }

 private:
  /// Next line that is not empty after removing comments.
  std::string_view dataLine(const std::string& expected) {
    std::string_view line;
    while (lines_.next(line)) {
      line = trimmed(line.substr(0, line.find('#')));
      if (!line.empty()) return line;
    }
    throw damaged(lines_.number(), fmt::format("the file ends where {} is expected.", expected));
  }

  void header(std::string_view word) {
    const bool known = word.size() >= 3 && word.substr(word.size() - 3) == "OFF";
    if (!known) throw damaged(lines_.number(), fmt::format("the word OFF is expected, but there is {}.", shown(word)));
    for (const char c : word.substr(0, word.size() - 3))
      if (c != 'S' && c != 'T' && c != 'C' && c != 'N')
        throw damaged(lines_.number(), fmt::format("{} has points outside of three dimensions.", shown(word)));
  }

  std::size_t count(std::string_view word, const char* what) {
    if (word == "BINARY") throw damaged(lines_.number(), "binary OFF files are not read.");
    const std::optional<int> value = toInteger(word);
    // Every vertex and face has a line of two bytes or more.
    if (!value || *value < 0 || static_cast<std::size_t>(*value) > size_ / 2)
      throw damaged(lines_.number(), fmt::format("the number of {} is {}, which this file cannot hold.", what, shown(word)));
    return static_cast<std::size_t>(*value);
  }

  void vertex(std::string_view line) {
    Vec3 point;
    for (int i = 0; i < 3; ++i) {
      const std::string_view word = takeWord(line);
      const std::optional<double> value = toNumber(word);
      if (!value) throw damaged(lines_.number(), fmt::format("a coordinate is expected, but there is {}.", shown(word)));
      point[i] = *value;
    }
    mesh_.points.push_back(point);
  }

  void face(std::string_view line) {
    const std::string_view first = takeWord(line);
    const std::optional<int> count = toInteger(first);
    if (!count || *count < 3)
      throw damaged(lines_.number(), fmt::format("a face needs 3 vertices or more; it says {}.", shown(first)));
    corners_.clear();
    for (int i = 0; i < *count; ++i) {
      if (i % 4096 == 0) progress_.check();
      const std::string_view word = takeWord(line);
      const std::optional<int> index = toInteger(word);
      if (!index || *index < 0 || static_cast<std::size_t>(*index) >= mesh_.points.size())
        throw damaged(lines_.number(), fmt::format("a vertex index from 0 to {} is expected, but there is {}.",
                                                   mesh_.points.size() - 1, shown(word)));
      corners_.push_back(*index);
    }
    mesh_.addFace(corners_);
  }

  const Progress& progress_;
  std::size_t size_;
  Lines lines_;
  Mesh mesh_;
  std::vector<int> corners_;
};

void writeOff(const Shape& shape, const std::filesystem::path& path, const Value& options, const Progress& progress) {
  const Mesh mesh = meshOf(shape, tessellationOptions(options), progress.part(0, 0.4));
  std::string out = fmt::format("OFF\n{} {} 0\n", mesh.points.size(), mesh.faceCount());
  writeEach(mesh.points.size(), progress.part(0.4, 0.7), [&](std::size_t i) {
    const Vec3& p = mesh.points[i];
    out += fmt::format("{} {} {}\n", formatNumber(p.x()), formatNumber(p.y()), formatNumber(p.z()));
  });
  writeEach(mesh.faceCount(), progress.part(0.7, 1), [&](std::size_t f) {
    out += fmt::format("{}", mesh.face(f).size());
    for (const int v : mesh.face(f)) out += fmt::format(" {}", v);
    out += '\n';
  });
  writeBytes(path, out);
}

}  // namespace

Format offFormat() {
  Format format;
  format.id = "off";
  format.title = "OFF (Geomview)";
  format.extensions = {"off"};
  format.writeOptions = {chordOption()};
  format.read = [](const std::filesystem::path& path, const Value&, const Progress& progress) {
    const std::string content = readFile(path);
    return OffReader(content, progress).read();
  };
  format.write = writeOff;
  format.writes = meshableKinds();
  return format;
}

}  // namespace blossom
