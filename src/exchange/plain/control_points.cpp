#include <fmt/format.h>

#include <algorithm>

#include "core/error.h"
#include "core/file.h"
#include "exchange/format/format.h"
#include "exchange/format/text.h"

/// Control points as text: one point a line makes a curve; rows of points apart by ';' make a surface, a line per row.
/// Points are x,y,z or, with the weight multiplied in, wx,wy,wz,w. The files hold no knots: the vector is clamped and
/// uniform.
namespace blossom {
namespace {

using Row = std::vector<Vec4>;

class Reader {
 public:
  explicit Reader(std::string_view text) : lines_(text) {}

  std::vector<Row> rows(const Progress& progress) {
    std::vector<Row> found;
    for (std::string_view line; lines_.next(line);) {
      if (lines_.number() % 1024 == 0) progress.check();
      const bool heading = lines_.number() == 1 && line.starts_with('"');  // column names, as a spreadsheet writes them
      if (!heading && !parse::trimmed(line).empty()) found.push_back(row(line));
    }
    return found;
  }

 private:
  [[noreturn]] void damaged(const std::string& what) const {
    throw Error(ErrorCode::FormatDamaged, fmt::format("Line {}: {}.", lines_.number(), what),
                "A control point is x,y,z or wx,wy,wz,w; the points of a surface's row stand apart by ';'.");
  }

  Row row(std::string_view line) {
    Row points;
    while (true) {
      const std::size_t end = std::min(line.find(';'), line.size());
      points.push_back(pointOf(line.substr(0, end)));
      if (end == line.size()) return points;
      line.remove_prefix(end + 1);
    }
  }

  Vec4 pointOf(std::string_view text) {
    Vec4 pole(0, 0, 0, 1);
    int count = 0;
    while (true) {
      const std::size_t end = std::min(text.find(','), text.size());
      if (count == 4) damaged("a point has more than four coordinates");
      pole[count++] = coordinate(text.substr(0, end));
      if (end == text.size()) break;
      text.remove_prefix(end + 1);
    }
    if (count < 3) damaged("a point has fewer than three coordinates");
    if (!(pole[3] > 0)) damaged("a weight is not above 0");
    return pole;
  }

  double coordinate(std::string_view text) const {
    const std::string_view word = parse::trimmed(text);
    if (const auto value = parse::toNumber(word)) return *value;
    damaged(fmt::format("{} is not a number", parse::shown(word)));
  }

  parse::Lines lines_;
};

std::vector<double> uniformKnots(int degree, std::size_t poles) {
  std::vector<double> knots;
  const int spans = static_cast<int>(poles) - degree;
  for (int k = 0; k <= static_cast<int>(poles) + degree; ++k)
    knots.push_back(std::clamp(k - degree, 0, spans) / static_cast<double>(spans));
  return knots;
}

int degreeFor(const Value& wanted, std::size_t poles) { return std::min(wanted.get<int>(), static_cast<int>(poles) - 1); }

Shape curveOf(const std::vector<Row>& rows, const Value& options) {
  Curve curve;
  for (const Row& row : rows) curve.poles.push_back(row.front());
  curve.degree = degreeFor(options.at("degree-u"), curve.poles.size());
  curve.knots = uniformKnots(curve.degree, curve.poles.size());
  return Shape(std::move(curve));
}

Shape surfaceOf(const std::vector<Row>& rows, const Value& options) {
  Surface surface;
  for (const Row& row : rows) surface.poles.insert(surface.poles.end(), row.begin(), row.end());
  surface.degreeU = degreeFor(options.at("degree-u"), rows.size());
  surface.degreeV = degreeFor(options.at("degree-v"), rows.front().size());
  surface.knotsU = uniformKnots(surface.degreeU, rows.size());
  surface.knotsV = uniformKnots(surface.degreeV, rows.front().size());
  return Shape(std::move(surface));
}

Imported readControlPoints(const std::filesystem::path& path, const Value& options, const Progress& progress) {
  const std::string text = readFile(path);
  const std::vector<Row> rows = Reader(text).rows(progress);
  if (rows.size() < 2)
    throw Error(ErrorCode::FormatDamaged,
                fmt::format("{} holds fewer than two lines of control points.", path.filename().string()));
  const std::size_t width = rows.front().size();
  if (std::any_of(rows.begin(), rows.end(), [&](const Row& row) { return row.size() != width; }))
    throw Error(ErrorCode::FormatDamaged, "The rows have different numbers of control points.",
                "Every line of a surface holds equally many points.");
  Imported imported;
  imported.entities["control point"] = rows.size() * width;
  imported.shape = width == 1 ? curveOf(rows, options) : surfaceOf(rows, options);
  imported.warnings.push_back(
      "The file holds no knots: a clamped uniform knot vector was taken. The degree can be given by options.");
  return imported;
}

ParameterSpec degreeOption(const char* name, const char* help) {
  ParameterSpec spec = count(1, 25);
  spec.name = name;
  spec.help = help;
  spec.fallback = 3;
  return spec;
}

}  // namespace

Format controlPointsFormat() {
  Format format;
  format.id = "control-points";
  format.title = "Control points (text)";
  format.extensions = {"cpt", "cptw"};
  format.readOptions = {degreeOption("degree-u", "Degree of the curve, or of the surface from line to line."),
                        degreeOption("degree-v", "Degree of the surface along a line.")};
  format.read = readControlPoints;
  return format;
}

}  // namespace blossom
