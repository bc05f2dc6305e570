#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/error.h"
#include "core/file.h"
#include "exchange/format/format.h"
#include "exchange/format/text.h"

/// Polygons and segments as plain numbers, the forms in which test cases of planar codes are handed around:
/// - a count and as many segments "x1 y1 x2 y2";
/// - a count and as many points "x y", then a count and as many segments;
/// - captioned cases (CAPTION, CLIPTYPE, FILLRULE, SOL_AREA, SOL_COUNT, SUBJECTS, SUBJECTS_OPEN, CLIPS), a polygon "x,y,
/// x,y, .." a line.
namespace blossom {
namespace {

[[noreturn]] void refuse(std::size_t line, const std::string& what) {
  throw Error(ErrorCode::FormatDamaged, fmt::format("Line {}: {}.", line, what),
              "The file is a count followed by segments x1 y1 x2 y2, or captioned polygons x,y, x,y, ..");
}

/// All numbers of a text apart by blanks and commas; empty when something else stands there.
std::optional<std::vector<double>> numbersOf(std::string_view text) {
  constexpr std::string_view between = " ,\t\r\n";
  std::vector<double> numbers;
  for (std::size_t begin = 0; (begin = text.find_first_not_of(between, begin)) != std::string_view::npos;) {
    const std::size_t end = std::min(text.find_first_of(between, begin), text.size());
    const auto value = parse::toNumber(text.substr(begin, end - begin));
    if (!value) return std::nullopt;
    numbers.push_back(*value);
    begin = end;
  }
  return numbers;
}

Path segmentPath(const double* xyxy) {
  Path path;
  path.segments.emplace_back(Line2{{xyxy[0], xyxy[1]}, {xyxy[2], xyxy[3]}});
  return path;
}

bool isCount(double value, std::size_t available, std::size_t each) {
  return value >= 0 && value == std::floor(value) && value * static_cast<double>(each) <= static_cast<double>(available);
}

/// "n, n segments" or "n, n points, m, m segments": told apart by which of them uses up all numbers.
Imported readSegments(const std::vector<double>& numbers) {
  std::size_t points = 0, at = 0;
  const auto usesUp = [&](std::size_t place) {
    return place < numbers.size() && isCount(numbers[place], numbers.size(), 4) &&
           place + 1 + 4 * static_cast<std::size_t>(numbers[place]) == numbers.size();
  };
  if (!usesUp(0)) {
    if (numbers.empty() || !isCount(numbers[0], numbers.size(), 2)) refuse(1, "the first number is not a count");
    points = static_cast<std::size_t>(numbers[0]);
    at = 1 + 2 * points;
    if (!usesUp(at)) refuse(1, "the counts do not fit the numbers that follow");
  }
  Curves drawing;
  for (std::size_t k = at + 1; k + 4 <= numbers.size(); k += 4) drawing.paths.push_back(segmentPath(&numbers[k]));
  if (drawing.paths.empty()) refuse(1, "the file holds no segment");
  Imported imported;
  if (points > 0) {
    imported.skipped["point"] = points;
    imported.warnings.push_back(fmt::format("{} single points were left out.", points));
  }
  imported.entities["segment"] = drawing.paths.size();
  imported.shape = Shape(std::move(drawing));
  return imported;
}

Path polygonOf(const std::vector<double>& xy, bool closed, std::string layer) {
  Path path;
  path.closed = closed;
  path.layer = std::move(layer);
  const std::size_t count = xy.size() / 2;
  for (std::size_t k = 0; k < (closed ? count : count - 1); ++k) {
    const std::size_t next = (k + 1) % count;
    path.segments.emplace_back(Line2{{xy[2 * k], xy[2 * k + 1]}, {xy[2 * next], xy[2 * next + 1]}});
  }
  return path;
}

Imported readCases(const std::string& text, const Progress& progress) {
  Curves drawing;
  Imported imported;
  std::string caption, part;
  std::size_t cases = 0;
  parse::Lines lines(text);
  for (std::string_view line; lines.next(line);) {
    if (lines.number() % 4096 == 0) progress.check();
    const auto numbers = numbersOf(line);
    if (numbers && numbers->empty()) continue;
    if (!numbers) {
      if (line.starts_with("CAPTION:")) {
        caption = line.substr(std::min<std::size_t>(9, line.size()));
        ++cases;
      }
      part = line.substr(0, line.find_first_of(": "));
      continue;
    }
    const bool open = part == "SUBJECTS_OPEN";
    if (part != "SUBJECTS" && part != "CLIPS" && !open) refuse(lines.number(), "numbers outside of SUBJECTS and CLIPS");
    if (numbers->size() % 2 != 0 || numbers->size() < 4) refuse(lines.number(), "a polygon is not made of pairs x,y");
    drawing.paths.push_back(polygonOf(*numbers, !open, fmt::format("{} {}", caption, part)));
  }
  if (drawing.paths.empty()) refuse(lines.number(), "the file holds no polygon");
  imported.entities["case"] = cases;
  imported.entities["polygon"] = drawing.paths.size();
  imported.shape = Shape(std::move(drawing));
  return imported;
}

Imported readOutlines(const std::filesystem::path& path, const Value&, const Progress& progress) {
  const std::string text = readFile(path);
  if (const auto numbers = numbersOf(text)) return readSegments(*numbers);
  if (text.find("CAPTION:") == std::string::npos) refuse(1, "neither numbers nor captioned polygons");
  return readCases(text, progress);
}

}  // namespace

Format outlinesFormat() {
  Format format;
  format.id = "outlines";
  format.title = "Polygons and segments (text)";
  format.extensions = {"txt"};
  format.read = readOutlines;
  return format;
}

}  // namespace blossom
