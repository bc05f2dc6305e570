#include <algorithm>
#include <cmath>

#include "core/file.h"
#include "example.h"
#include "exchange/format/text.h"
#include "geometry/planar/planar.h"

using namespace blossom;

namespace {

/// "PU0,0;PD40,0,40,40;": PU lifts the pen and moves, PD draws; IN and SP draw nothing. All else is refused.
Imported readPlot(const std::filesystem::path& file, const Value& options, const Progress& progress) {
  std::string text = readFile(file);
  std::replace(text.begin(), text.end(), ';', '\n');
  std::replace(text.begin(), text.end(), ',', ' ');
  Curves lines;
  Vec2 pen(0, 0);
  parse::Lines commands(text);
  for (std::string_view command; commands.next(command);) {
    progress.check();
    command = parse::trimmed(command);
    const std::string_view name = command.substr(0, 2);
    if (command.empty() || name == "IN" || name == "SP") continue;
    const Error damaged(ErrorCode::FormatDamaged, "The command " + parse::shown(command) + " is not understood.");
    if (name != "PU" && name != "PD") throw damaged;
    for (std::string_view rest = command.substr(2); !parse::trimmed(rest).empty();) {
      const auto x = parse::toNumber(parse::takeWord(rest)), y = parse::toNumber(parse::takeWord(rest));
      if (!x || !y) throw damaged;
      const Vec2 to = Vec2(*x, *y) * options.value("unit", 0.025);
      if (name == "PD" && to != pen) lines.paths.push_back({{Line2{pen, to}}, false, {}, {}});
      pen = to;
    }
  }
  return {joined(lines), {{"line", lines.paths.size()}}, Value::object(), {}};
}

void writePlot(const Shape& shape, const std::filesystem::path& file, const Value& options, const Progress& progress) {
  const double unit = options.value("unit", 0.025);
  const auto units = [&](double length) { return std::to_string(std::lround(length / unit)); };
  std::string text = "IN;SP1;";
  for (const Path& path : shape.get<Region>() ? shape.get<Region>()->loops : shape.get<Curves>()->paths) {
    progress.check();
    std::vector<Vec2> points = flatten(path, unit / 2);
    if (path.closed) points.push_back(points.front());
    for (const Vec2& p : points) text += (&p == points.data() ? "\nPU" : "PD") + units(p.x()) + ',' + units(p.y()) + ';';
  }
  writeAtomically(file, text + "\nPU0,0;\n");
}

}  // namespace

Format example::plotterFormat() {
  ParameterSpec unit = positiveLength();
  unit.name = "unit", unit.help = "Length of a unit of the plotter.", unit.fallback = 0.025;
  Format format;
  format.id = "hpgl", format.title = "Pen plotter (HPGL)", format.extensions = {"plt"};
  format.readOptions = format.writeOptions = {unit};
  format.read = readPlot, format.write = writePlot;
  format.writes = {ShapeKind::Region, ShapeKind::Curves};
  return format;
}
