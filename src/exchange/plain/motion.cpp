#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <initializer_list>
#include <optional>

#include "core/error.h"
#include "core/file.h"
#include "exchange/format/format.h"
#include "exchange/plain/motion_edits.h"
#include "exchange/plain/motion_node.h"
#include "exchange/plain/motion_read.h"
#include "geometry/shape/motion.h"
#include "parameter/wording.h"

/// Motion files: JSON with the three factors of a two-parameter motion, as resources/manual/sweep.md describes them.
namespace blossom {

namespace {

constexpr const char* editsOption = "edits";
constexpr const char* editsLeftOut = "left-out";

ParameterSpec editsChoice() {
  ParameterSpec spec = choice({"kept", editsLeftOut});
  spec.name = editsOption;
  spec.help = "Whether the edits of the file belong to the motion that is read.";
  spec.fallback = "kept";
  return spec;
}

/// "in line 3, column 12": where a person finds byte `at` (counted from 1).
std::string placeInText(const std::string& text, std::size_t at) {
  const auto end = text.begin() + static_cast<std::ptrdiff_t>(std::min(at > 0 ? at - 1 : 0, text.size()));
  const auto line = std::count(text.begin(), end, '\n') + 1;
  const auto start = std::find(std::make_reverse_iterator(end), text.rend(), '\n').base();
  return fmt::format("in line {}, column {}", line, end - start + 1);
}

Imported readMotionFile(const std::filesystem::path& path, const Value& options, const Progress& progress) {
  const std::string text = readFile(path);
  progress.check();
  Value json;
  try {
    json = Value::parse(text);
  } catch (const Value::parse_error& error) {
    throw Error(ErrorCode::FormatDamaged, fmt::format("\"{}\" is not a JSON file: it breaks off or goes wrong {}.",
                                                      path.filename().string(), placeInText(text, error.byte)));
  } catch (const Value::exception& error) {
    // "[json.exception.out_of_range.406] number overflow parsing '1e309'"
    const std::string what = error.what();
    const auto quote = what.find('\'');
    throw Error(
        ErrorCode::FormatDamaged,
        fmt::format(
            "\"{}\" holds a number that is too large{}.", path.filename().string(),
            quote == std::string::npos ? "" : ": " + quoted(Value(what.substr(quote + 1, what.rfind('\'') - quote - 1)))));
  }
  progress.check();
  Imported imported;
  Motion motion = readMotion(json, imported.warnings);
  if (options.value(editsOption, "") == editsLeftOut) motion.edits.clear();
  imported.entities = {{"motion", 1}};
  imported.shape = std::move(motion);
  return imported;
}

Value toJson(const Vec4& v) { return Value::array({v[0], v[1], v[2], v[3]}); }

Value surfaceJson(const Surface& surface, ClosedU closed) {
  const std::size_t p = static_cast<std::size_t>(surface.degreeU), rows = surface.countU() - (closed == ClosedU::No ? 0 : p);
  std::vector<double> knotsU = surface.knotsU;
  if (closed != ClosedU::No) {
    // One period is sufficient when the same knots can be restored from it exactly.
    const std::vector<double> period(knotsU.begin() + surface.degreeU, knotsU.end() - surface.degreeU);
    if (unwrappedKnots(surface.degreeU, period) == knotsU) knotsU = period;
  }
  Value poles = Value::array();
  for (std::size_t i = 0; i < rows; ++i) {
    Value row = Value::array();
    for (std::size_t j = 0; j < surface.countV(); ++j) row.push_back(toJson(surface.pole(i, j)));
    poles.push_back(std::move(row));
  }
  return {{"degree", {surface.degreeU, surface.degreeV}}, {"knots", {knotsU, surface.knotsV}}, {"poles", std::move(poles)}};
}

/// A weight and a Euclidean pole whose product is bitwise the homogeneous pole, where that is possible.
Vec3 euclidean(const Vec4& pole) {
  Vec3 point = pole.head<3>() / pole[3];
  for (int k = 0; k < 3; ++k)
    for (const double candidate : {point[k], std::nextafter(point[k], -INFINITY), std::nextafter(point[k], INFINITY)})
      if (candidate * pole[3] == pole[k]) {
        point[k] = candidate;
        break;
      }
  return point;
}

Value motionJson(const Motion& motion) {
  Value poles = Value::array(), weights = Value::array();
  for (const Vec4& pole : motion.trajectory.poles) {
    const Vec3 point = euclidean(pole);
    poles.push_back(Value::array({point.x(), point.y(), point.z()}));
    weights.push_back(pole[3]);
  }
  Value orientation = surfaceJson(motion.orientation, motion.closedU);
  orientation[motionFileSigns] = motionFileSignsKept;
  if (motion.closedU != ClosedU::No)
    orientation["closed_u"] = motion.closedU == ClosedU::Periodic ? "periodic" : "anti-periodic";
  Value json{{"trajectory",
              {{"degree", motion.trajectory.degree},
               {"knots", motion.trajectory.knots},
               {"poles", std::move(poles)},
               {"weights", std::move(weights)}}},
             {"orientation", std::move(orientation)},
             {"scaling", surfaceJson(motion.scaling, motion.closedU)},
             {"point", {motion.point.x(), motion.point.y(), motion.point.z()}}};
  if (!motion.edits.empty()) json["edits"] = editsJson(motion.edits);
  if (motion.base)
    json["base"] = {{"trajectory", motion.base->trajectory},
                    {"orientation", motion.base->orientation},
                    {"scaling", motion.base->scaling}};
  return json;
}

/// What no motion file may hold is not written, for nobody could read it again. @param path to the value: "scaling.poles[2]"
void requireReadable(const Value& value, const std::string& path) {
  const bool ofRows =
      value.is_array() && value.front().is_array() && !value.front().empty() && value.front().front().is_array();
  const std::size_t entries = value.size() * (ofRows ? value.front().size() : 1);
  if (entries > motionFileEntries)
    throw Error(ErrorCode::OutputNotSupported,
                fmt::format("{} would hold {} entries; a motion file may have {}.", path, entries, motionFileEntries),
                "Give the motion fewer rows or columns.");
  for (const auto& [key, part] : value.items()) {
    const auto pathOfPart = [&, &name = key] {
      return value.is_array() ? fmt::format("{}[{}]", path, name) : path.empty() ? name : fmt::format("{}.{}", path, name);
    };
    if (part.is_structured() && !part.empty()) requireReadable(part, pathOfPart());
    if (part.is_number() && !(std::abs(part.get<double>()) <= motionFileNumber))
      throw Error(ErrorCode::OutputNotSupported,
                  fmt::format("{} would be {}; numbers of a motion file lie between -1e9 and 1e9.", pathOfPart(),
                              part.get<double>()),
                  "Make the motion smaller, choose nearer targets, or weights nearer to 1.");
  }
}

/// Numbers side by side, everything else on lines of its own: a file that a person can read and compare.
void print(std::ostream& out, const Value& value, int indent) {
  const std::string margin(static_cast<std::size_t>(indent) + 2, ' ');
  const bool flat = !value.is_structured() || (value.is_array() && (value.empty() || !value.front().is_structured()));
  if (flat) {
    out << value.dump();
    return;
  }
  out << (value.is_object() ? "{\n" : "[\n");
  for (auto it = value.begin(); it != value.end(); ++it) {
    if (it != value.begin()) out << ",\n";
    out << margin;
    if (value.is_object()) out << Value(it.key()).dump() << ": ";
    print(out, *it, indent + 2);
  }
  out << '\n' << std::string(static_cast<std::size_t>(indent), ' ') << (value.is_object() ? '}' : ']');
}

void write(const Shape& shape, const std::filesystem::path& path, const Value&, const Progress& progress) {
  const Motion* motion = shape.get<Motion>();
  if (!motion) throw Error(ErrorCode::OutputNotSupported, "Only a motion can be written as a motion file.");
  validate(*motion);
  progress.check();
  const Value json = motionJson(*motion);
  requireReadable(json, "");
  progress.check();
  std::ofstream out(path, std::ios::binary);
  print(out, json, 0);
  out << '\n';
  out.flush();
  if (!out) throw Error(ErrorCode::FileUnwritable, fmt::format("\"{}\" could not be written.", path.string()));
}

}  // namespace

Format motionFormat() {
  return {.id = "motion",
          .title = "Two-parameter motion (JSON)",
          .extensions = {"json"},
          .readOptions = {editsChoice()},
          .writeOptions = {},
          .read = readMotionFile,
          .write = write,
          .writes = {ShapeKind::Motion},
          .reads = ShapeKind::Motion};
}

}  // namespace blossom
