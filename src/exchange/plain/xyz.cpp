#include <fmt/format.h>

#include "core/file.h"
#include "core/units.h"
#include "exchange/format/format.h"
#include "exchange/format/mesh_options.h"
#include "exchange/format/text.h"

// Points as text, one a line: three numbers apart by blanks, tabs, commas or semicolons. What follows them (normals,
// colours) is passed over; lines that begin with # or // are comments, and a first line may name the columns or count the
// points.
namespace blossom {
namespace {

using namespace parse;

/// Takes one field off; blanks and one comma or semicolon part fields.
std::string_view takeField(std::string_view& rest) {
  rest = trimmed(rest);
  const std::size_t end = std::min(rest.find_first_of(" \t,;"), rest.size());
  const std::string_view field = rest.substr(0, end);
  rest = trimmed(rest.substr(end));
  if (!rest.empty() && (rest.front() == ',' || rest.front() == ';')) rest.remove_prefix(1);
  return field;
}

bool isComment(std::string_view line) { return line.empty() || line.front() == '#' || line.starts_with("//"); }

/// A line before all points with the names of the columns, or with the number of points.
bool isHeading(std::string_view line) {
  const std::string_view first = takeField(line);
  return !toNumber(first) ? first.find_first_of("0123456789") == std::string_view::npos : trimmed(line).empty();
}

Vec3 pointOf(std::string_view line, std::size_t number) {
  Vec3 point;
  for (int k = 0; k < 3; ++k) {
    const std::string_view field = takeField(line);
    const std::optional<double> value = toNumber(field);
    if (!value)
      throw damaged(number, field.empty() ? fmt::format("a point needs three coordinates; it has {}.", k)
                                          : fmt::format("{} is not a coordinate.", shown(field)));
    point[k] = *value;
  }
  return point;
}

Imported readXyz(const std::filesystem::path& path, const Value&, const Progress& progress) {
  const std::string content = readFile(path);
  Lines lines(content);
  Mesh mesh;
  std::string_view line;
  bool heading = true;
  while (lines.next(line)) {
    if (lines.number() % 4096 == 0) progress.check();
    line = trimmed(line);
    if (isComment(line)) continue;
    if (!heading || !isHeading(line)) mesh.points.push_back(pointOf(line, lines.number()));
    heading = false;
  }
  if (mesh.points.empty())
    throw Error(ErrorCode::FormatDamaged, "It holds no point.", "The file is damaged or was not written completely.");
  Imported imported;
  imported.entities = {{"point", mesh.points.size()}};
  imported.shape = Shape(std::move(mesh));
  return imported;
}

void writeXyz(const Shape& shape, const std::filesystem::path& path, const Value&, const Progress& progress) {
  std::string out;
  for (const Vec3& p : shape.get<Mesh>()->points)
    out += fmt::format("{} {} {}\n", formatNumber(p.x()), formatNumber(p.y()), formatNumber(p.z()));
  progress.check();
  writeBytes(path, out);
}

}  // namespace

Format xyzFormat() {
  Format format;
  format.id = "xyz";
  format.title = "Points (XYZ)";
  format.extensions = {"xyz"};
  format.read = readXyz;
  format.write = writeXyz;
  format.writes = {ShapeKind::Mesh};
  return format;
}

}  // namespace blossom
