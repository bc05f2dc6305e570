#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "core/file.h"
#include "core/units.h"
#include "exchange/format/bytes.h"
#include "exchange/format/format.h"
#include "exchange/format/mesh_options.h"
#include "exchange/format/text.h"
#include "exchange/mesh/ply_header.h"

// Stanford's polygon format: a header that declares elements and their properties, then the data as text or in either byte
// order.
namespace blossom {
namespace {

using namespace parse;

/// The values after the header, one after the other.
class PlyValues {
 public:
  PlyValues(std::string_view data, PlyEncoding encoding)
      : text_(data),
        bytes_(data, encoding == PlyEncoding::Big ? std::endian::big : std::endian::little),
        isText_(encoding == PlyEncoding::Text) {}

  double take(PlyType type) {
    if (isText_) return takeText();
    switch (type) {
      case PlyType::Int8:
        return bytes_.take<std::int8_t>();
      case PlyType::UInt8:
        return bytes_.take<std::uint8_t>();
      case PlyType::Int16:
        return bytes_.take<std::int16_t>();
      case PlyType::UInt16:
        return bytes_.take<std::uint16_t>();
      case PlyType::Int32:
        return bytes_.take<std::int32_t>();
      case PlyType::UInt32:
        return bytes_.take<std::uint32_t>();
      case PlyType::Float32:
        return bytes_.take<float>();
      case PlyType::Float64:
        return bytes_.take<double>();
    }
    return 0;
  }

  std::size_t takeCount(const PlyProperty& list) {
    const double count = take(*list.countType);
    const double room = static_cast<double>(isText_ ? text_.size() / 2 + 1 : bytes_.remaining() / byteSize(list.type));
    if (!(count >= 0 && count <= room) || count != std::floor(count))
      throw Error(ErrorCode::FormatDamaged,
                  fmt::format("A list of {} announces {} values, which this file cannot hold.", shown(list.name), count));
    return static_cast<std::size_t>(count);
  }

 private:
  double takeText() {
    const std::string_view word = takeWord(text_);
    if (word.empty())
      throw Error(ErrorCode::FormatDamaged, "The file ends in the middle of its data.", "It was not written completely.");
    const std::optional<double> value = toNumber(word);
    if (!value) throw Error(ErrorCode::FormatDamaged, fmt::format("A number is expected, but there is {}.", shown(word)));
    return *value;
  }

  std::string_view text_;
  ByteReader bytes_;
  bool isText_;
};

class PlyReader {
 public:
  PlyReader(std::string_view content, const Progress& progress)
      : progress_(progress), header_(readPlyHeader(content)), values_(content.substr(header_.bytes), header_.encoding) {}

  Imported read() {
    Value leftOut = Value::object();
    for (const PlyElement& element : header_.elements) {
      if (element.properties.empty()) continue;
      if (element.name == "vertex")
        readVertices(element);
      else if (element.name == "face")
        readFaces(element);
      else if (element.name == "tristrips")
        readStrips(element);
      else {
        passOver(element);
        if (element.count > 0) leftOut[utf8(element.name)] = element.count;
      }
    }
    for (const int v : mesh_.faceVertices)  // may come before their vertices
      if (static_cast<std::size_t>(v) >= mesh_.points.size())
        throw Error(ErrorCode::FormatDamaged,
                    fmt::format("A face uses vertex {}, but there are only {}.", v, mesh_.points.size()));
    Imported imported = importedMesh(std::move(mesh_));
    imported.skipped = std::move(leftOut);
    return imported;
  }

 private:
  static std::size_t propertyNamed(const PlyElement& element, std::initializer_list<std::string_view> names, bool list) {
    for (std::size_t i = 0; i < element.properties.size(); ++i) {
      const PlyProperty& p = element.properties[i];
      if (p.countType.has_value() == list && std::find(names.begin(), names.end(), p.name) != names.end()) return i;
    }
    throw Error(ErrorCode::FormatDamaged, fmt::format("Its {} has no property \"{}\".", element.name, *names.begin()));
  }

  void readVertices(const PlyElement& element) {
    const std::array<std::size_t, 3> axes{propertyNamed(element, {"x"}, false), propertyNamed(element, {"y"}, false),
                                          propertyNamed(element, {"z"}, false)};
    for (std::size_t n = 0; n < element.count; ++n) {
      if (n % 8192 == 0) progress_.check();
      Vec3 point(0, 0, 0);
      for (std::size_t i = 0; i < element.properties.size(); ++i) {
        const double value = single(element.properties[i]);
        for (std::size_t axis = 0; axis < 3; ++axis)
          if (axes[axis] == i) point[static_cast<Eigen::Index>(axis)] = value;
      }
      if (!point.allFinite())
        throw Error(ErrorCode::FormatDamaged, fmt::format("Vertex {} has a coordinate that is not a number.", n));
      mesh_.points.push_back(point);
    }
  }

  void readFaces(const PlyElement& element) {
    const std::size_t list = propertyNamed(element, {"vertex_indices", "vertex_index"}, true);
    for (std::size_t n = 0; n < element.count; ++n) {
      if (n % 8192 == 0) progress_.check();
      for (std::size_t i = 0; i < element.properties.size(); ++i) {
        if (i == list)
          face(element.properties[i], n);
        else
          single(element.properties[i]);
      }
    }
  }

  void face(const PlyProperty& property, std::size_t n) {
    const std::size_t count = values_.takeCount(property);
    if (count < 3)
      throw Error(ErrorCode::FormatDamaged, fmt::format("Face {} has {} vertices; it needs 3 or more.", n, count));
    corners_.clear();
    for (std::size_t i = 0; i < count; ++i) {
      if (i % 8192 == 0) progress_.check();
      const double index = values_.take(property.type);
      if (!(index >= 0 && index < 2147483647.0))
        throw Error(ErrorCode::FormatDamaged, fmt::format("Face {} has {} for a vertex.", n, index));
      corners_.push_back(static_cast<int>(index));
    }
    mesh_.addFace(corners_);
  }

  void readStrips(const PlyElement& element) {
    const std::size_t list = propertyNamed(element, {"vertex_indices", "vertex_index"}, true);
    for (std::size_t n = 0; n < element.count; ++n)
      for (std::size_t i = 0; i < element.properties.size(); ++i) {
        if (i == list)
          strip(element.properties[i], n);
        else
          single(element.properties[i]);
      }
  }

  /// Every corner from the third on ends a triangle, each turned against the one before; -1 begins anew. Triangles with
  /// equal corners join two strips and are none.
  void strip(const PlyProperty& property, std::size_t n) {
    corners_.clear();
    for (std::size_t left = values_.takeCount(property), i = 0; i < left; ++i) {
      if (i % 8192 == 0) progress_.check();
      const double index = values_.take(property.type);
      if (!(index >= -1 && index < 2147483647.0))
        throw Error(ErrorCode::FormatDamaged, fmt::format("Triangle strip {} has {} for a vertex.", n, index));
      if (index < 0) {
        corners_.clear();
        continue;
      }
      corners_.push_back(static_cast<int>(index));
      if (corners_.size() > 2) addStripTriangle(corners_.size() % 2 == 0);
    }
  }

  void addStripTriangle(bool turned) {
    std::array<int, 3> triangle{};
    std::copy(corners_.end() - 3, corners_.end(), triangle.begin());
    if (turned) std::swap(triangle[0], triangle[1]);
    if (triangle[0] != triangle[1] && triangle[1] != triangle[2] && triangle[2] != triangle[0]) mesh_.addFace(triangle);
  }

  void passOver(const PlyElement& element) {
    for (std::size_t n = 0; n < element.count; ++n) {
      if (n % 8192 == 0) progress_.check();
      for (const PlyProperty& property : element.properties) single(property);
    }
  }

  /// Value of a property; a list is passed over.
  double single(const PlyProperty& property) {
    if (!property.countType) return values_.take(property.type);
    for (std::size_t left = values_.takeCount(property); left > 0; --left) {
      if (left % 8192 == 0) progress_.check();
      values_.take(property.type);
    }
    return 0;
  }

  const Progress& progress_;
  PlyHeader header_;
  PlyValues values_;
  Mesh mesh_;
  std::vector<int> corners_;
};

void writePly(const Shape& shape, const std::filesystem::path& path, const Value& options, const Progress& progress) {
  const Mesh mesh = meshOf(shape, tessellationOptions(options), progress.part(0, 0.4));
  const bool ascii = options.value("ascii", false);
  std::string out = fmt::format(
      "ply\nformat {} 1.0\ncomment Blossom, lengths in mm\nelement vertex {}\nproperty double x\nproperty double "
      "y\nproperty double z\n"
      "element face {}\nproperty list int int vertex_indices\nend_header\n",
      ascii ? "ascii" : "binary_little_endian", mesh.points.size(), mesh.faceCount());
  writeEach(mesh.points.size(), progress.part(0.4, 0.7), [&](std::size_t n) {
    const Vec3& p = mesh.points[n];
    if (ascii)
      out += fmt::format("{} {} {}\n", formatNumber(p.x()), formatNumber(p.y()), formatNumber(p.z()));
    else
      for (int i = 0; i < 3; ++i) appendLittleEndian(out, p[i]);
  });
  writeEach(mesh.faceCount(), progress.part(0.7, 1), [&](std::size_t f) {
    const auto face = mesh.face(f);
    if (ascii) {
      out += fmt::format("{}", face.size());
      for (const int v : face) out += fmt::format(" {}", v);
      out += '\n';
    } else {
      appendLittleEndian(out, static_cast<std::int32_t>(face.size()));
      for (const int v : face) appendLittleEndian(out, static_cast<std::int32_t>(v));
    }
  });
  writeBytes(path, out);
}

}  // namespace

Format plyFormat() {
  Format format;
  format.id = "ply";
  format.title = "PLY (Stanford polygons)";
  format.extensions = {"ply"};
  format.writeOptions = {chordOption(), asciiOption()};
  format.read = [](const std::filesystem::path& path, const Value&, const Progress& progress) {
    const std::string content = readFile(path);
    return PlyReader(content, progress).read();
  };
  format.write = writePly;
  format.writes = meshableKinds();
  return format;
}

}  // namespace blossom
