#include "exchange/gcode/gcode_write.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>

#include "core/angle.h"
#include "core/error.h"
#include "core/file.h"
#include "core/units.h"
#include "exchange/gcode/gcode_comments.h"
#include "exchange/gcode/gcode_program.h"

namespace blossom {
namespace {

/// What a control understands.
struct Post {
  std::string_view name;
  std::string_view title;
  bool changesTools;    ///< T and M6
  bool offsetsLengths;  ///< G43
  bool blendsPath;      ///< G64 P
  bool framed;          ///< "%" and a program number
  bool pointed;         ///< whole numbers need a decimal point: X10.
  int maximumDecimals;  ///< in mm; finer ones are an alarm or cut off by the control
  std::string_view modes, end;
  std::string_view top;    ///< up to the machine's top, wherever the tool is; empty where the control need not know it
  std::string_view dwell;  ///< until the spindle has its speed
};

constexpr std::array<Post, 4> posts{{
    {"linuxcnc", "LinuxCNC", true, true, true, false, false, 6, "G17 G90 G91.1 G94 G40 G49 G80", "M2", "G53 G0 Z0", "G4 P2"},
    {"grbl", "GRBL 1.1", false, false, false, false, false, 6, "G17 G90 G91.1 G94 G40", "M2", "", "G4 P2"},
    {"mach3", "Mach3 and Mach4", true, true, false, false, false, 6, "G17 G90 G91.1 G94 G40 G49 G80", "M30", "G53 G0 Z0",
     "G4 P2"},
    {"fanuc", "Fanuc", true, true, false, true, true, 3, "G17 G90 G94 G40 G49 G80", "M30", "G91 G28 Z0.\nG90", "G4 P2000"},
}};

const Post& postNamed(const std::string& name) {
  const auto found = std::find_if(posts.begin(), posts.end(), [&](const Post& post) { return post.name == name; });
  if (found == posts.end()) throw Error(ErrorCode::InvalidParameter, fmt::format("There is no post \"{}\".", name));
  return *found;
}

/// LinuxCNC may round corners by so much to keep its speed, where the toolpath does not say less; mm.
constexpr double maximumBlending = 0.005;
/// Largest difference of an arc's radius at its two ends that every control accepts; mm.
constexpr double largestMismatch = 0.005;
/// Arcs of larger radii are straight within the resolution of a control; mm.
constexpr double largestRadius = 1e4;
/// LinuxCNC refuses arcs of smaller radii as points; mm.
constexpr double smallestRadius = 0.005;

using Ticks = std::array<std::int64_t, 3>;  ///< a position in units of the last decimal

class GcodeWriter {
 public:
  GcodeWriter(const Toolpath& path, const Value& options)
      : path_(path), post_(postNamed(options.value("post", "linuxcnc"))) {
    inch_ = options.value("unit", "mm") == "inch";
    numbered_ = options.value("line-numbers", false);
    decimals_ = std::min(static_cast<int>(options.value("decimals", 4.0)), post_.maximumDecimals) + (inch_ ? 1 : 0);
    perMm_ = std::pow(10, decimals_) / (inch_ ? millimetresPerInch : 1);
  }

  std::string write(const Progress& progress) {
    validate();
    if (post_.framed) text_ += "%\nO0001\n";
    header();
    setup();
    begin(path_.start);
    for (std::size_t i = 0; i < path_.moves.size(); ++i) {
      if (i % 4096 == 0)
        progress.report(static_cast<double>(i) / static_cast<double>(path_.moves.size()), "Writing the program");
      move(startOf(path_, i), path_.moves[i]);
    }
    retract();
    if (path_.flood || path_.mist) line("M9");
    if (path_.cutter.spindle > 0) line("M5");
    line(std::string(post_.end));
    if (post_.framed) text_ += "%\n";
    tellGouge(progress);
    return std::move(text_);
  }

 private:
  void validate() const {
    if (path_.moves.empty())
      throw Error(ErrorCode::InvalidInput, "The toolpath has no moves.", "Make one of a part that the tool fits into.");
    const auto isNear = [](const Vec3& p) { return p.allFinite() && p.cwiseAbs().maxCoeff() < maximumGcodeCoordinate; };
    const std::string hint = "Move the part or the work's zero: programs reach 10 km at most.";
    if (!isNear(path_.start)) throw Error(ErrorCode::InvalidInput, "The toolpath begins too far away.", hint);
    for (std::size_t i = 0; i < path_.moves.size(); ++i) {
      const ToolMove& m = path_.moves[i];
      if (!isNear(m.to) || !m.center.allFinite())
        throw Error(ErrorCode::InvalidInput, fmt::format("Move {} of the toolpath goes too far away.", i + 1), hint);
      if (m.kind != MoveKind::Rapid && !(m.feed > 0 && std::isfinite(m.feed)))
        throw Error(ErrorCode::InvalidInput,
                    fmt::format("Move {} of the toolpath, to ({:.3f}, {:.3f}, {:.3f}), cuts without a feed.", i + 1,
                                m.to.x(), m.to.y(), m.to.z()),
                    "Give a feed above 0.");
    }
  }

  void line(const std::string& words) {
    if (numbered_) text_ += fmt::format("N{} ", number_ = number_ >= 99990 ? 10 : number_ + 10);
    text_ += words;
    text_ += '\n';
  }
  void comment(const std::string& words) { text_ += fmt::format("({})\n", words); }

  /// Data for Blossom's own reader (the first three) and information for the operator. Lengths in mm.
  void header() {
    const Cutter& c = path_.cutter;
    comment("Blossom");
    comment(fmt::format("tool T {} diameter {} corner {} angle {}", c.number, formatNumber(c.diameter),
                        formatNumber(c.cornerRadius), formatNumber(toDegrees(c.vAngle))));
    const auto span = [](double low, double high) { return formatNumber(low) + " " + formatNumber(high); };
    const Bounds& stock = path_.stock;
    if (!stock.empty)
      comment(fmt::format("stock X {} Y {} Z {}", span(stock.low.x(), stock.high.x()), span(stock.low.y(), stock.high.y()),
                          span(stock.low.z(), stock.high.z())));
    if (path_.task) {
      const PocketTask& task = *path_.task;
      comment(fmt::format("part X {} Y {} Z {} depth {} wall {} floor {}", formatNumber(task.zero.x()),
                          formatNumber(task.zero.y()), formatNumber(task.zero.z()), formatNumber(task.depth),
                          formatNumber(task.leaveWall), formatNumber(task.leaveFloor)));
    }
    if (path_.passes > 0) comment(fmt::format("passes {}", path_.passes));
    comment(fmt::format("for {}, work zero {}, all lengths in comments in mm", post_.title, path_.workOffset));
    const auto seconds = static_cast<long long>(std::llround(secondsOf(path_).value_or(0)));
    comment(fmt::format("path {:.0f} mm, time about {} min {} s", lengthOf(path_), seconds / 60, seconds % 60));
    if (path_.gouge && path_.residue) measuredAt_ = text_.size();
  }

  /// The program is measured as written, with rounding, when the part is known.
  void tellGouge(const Progress& progress) {
    if (!measuredAt_) return;
    const std::string residue = fmt::format("residue before rounding {:.4f} mm2", *path_.residue);
    std::string told = fmt::format("simulated before rounding to {} mm: gouge {:.4f} mm, {}", formatNumber(resolution()),
                                   *path_.gouge, residue);
    if (path_.gougeOf) {
      const Toolpath read = toolpathOf(parseGcode(text_, progress.part(0.9, 0.92)));
      const double gouge = path_.gougeOf(read, progress.part(0.92, 1));
      told = fmt::format("simulated as it stands here: gouge {:.4f} mm, {}", gouge, residue);
    }
    text_.insert(*measuredAt_, fmt::format("({})\n", told));
  }

  void setup() {
    line(fmt::format("{} {}", inch_ ? "G20" : "G21", post_.modes));
    // In its own digits: rounded to 0 it would allow any corner to be cut.
    const double blending = path_.blending > 0 ? std::min(path_.blending, maximumBlending) : maximumBlending;
    if (post_.blendsPath)
      line(inch_ ? fmt::format("G64 P{:.7f}", blending / millimetresPerInch)
                 : fmt::format("G64 P{}", formatNumber(blending)));
    line(path_.workOffset);
    toMachineTop();
    if (post_.changesTools) line(fmt::format("T{} M6", path_.cutter.number));
    if (post_.offsetsLengths) line(fmt::format("G43 H{}", path_.cutter.number));
    if (path_.cutter.spindle > 0) {
      line(fmt::format("S{:.0f} M3", std::max(path_.cutter.spindle, 1.0)));
      line(std::string(post_.dwell));
    }
    if (path_.mist) line("M7");
    if (path_.flood) line("M8");
  }

  void toMachineTop() {
    for (std::string_view rest = post_.top; !rest.empty();) {
      const std::size_t end = std::min(rest.find('\n'), rest.size());
      line(std::string(rest.substr(0, end)));
      rest.remove_prefix(std::min(end + 1, rest.size()));
    }
  }

  /// Out of the work before the spindle stops.
  void retract() {
    if (!post_.top.empty()) return toMachineTop();
    const std::int64_t top = ticks(path_.start.z());
    if (at_[2] < top) straight("G0", {at_[0], at_[1], top}, 0);
  }

  [[nodiscard]] std::int64_t ticks(double mm) const { return std::llround(mm * perMm_); }
  [[nodiscard]] Ticks ticks(const Vec3& p) const { return {ticks(p.x()), ticks(p.y()), ticks(p.z())}; }
  [[nodiscard]] double resolution() const { return 1 / perMm_; }

  /// "-0.5", "12", for Fanuc "12.": whole ticks as a decimal number without needless zeros.
  [[nodiscard]] std::string decimal(std::int64_t value) const {
    const bool negative = value < 0;
    std::string digits = std::to_string(negative ? -value : value);
    if (static_cast<int>(digits.size()) <= decimals_)
      digits.insert(0, static_cast<std::size_t>(decimals_) + 1 - digits.size(), '0');
    digits.insert(digits.size() - static_cast<std::size_t>(decimals_), ".");
    digits.erase(digits.find_last_not_of('0') + 1);
    if (digits.back() == '.' && !post_.pointed) digits.pop_back();
    return (negative ? "-" : "") + digits;
  }

  /// Where the tool is when the program starts is not known: across at the machine's top, then down; where the control need
  /// not know that height, up to the safe one first.
  void begin(const Vec3& p) {
    at_ = ticks(p);
    const std::string height = "Z" + decimal(at_[2]), place = "X" + decimal(at_[0]) + " Y" + decimal(at_[1]);
    const bool known = !post_.top.empty();
    line("G0 " + (known ? place : height));
    line(known ? height : place);
    motion_ = "G0";
  }

  void move(const Vec3& from, const ToolMove& m) {
    if (m.kind == MoveKind::Rapid) return straight("G0", ticks(m.to), 0);
    if (m.turn == 0) return straight("G1", ticks(m.to), m.feed);
    if (!round(from, m)) asLines(from, m);
  }

  void emit(const std::string& motion, const std::string& words, double feed) {
    std::string all;
    if (motion != motion_) all = motion + " ";
    all += words;
    motion_ = motion;
    const std::string f = feed > 0 ? fmt::format("F{}", number(inch_ ? feed / millimetresPerInch : feed)) : "";
    if (!f.empty() && f != feed_) {
      all += " " + f;
      feed_ = f;
    }
    line(all);
  }

  /// A feed to three decimals, never 0.
  [[nodiscard]] std::string number(double value) const {
    std::string text = fmt::format("{:.3f}", std::max(value, 0.001));
    text.erase(text.find_last_not_of('0') + 1);
    if (text.back() == '.' && !post_.pointed) text.pop_back();
    return text;
  }

  void straight(const std::string& motion, const Ticks& to, double feed) {
    std::string words;
    for (std::size_t k = 0; k < 3; ++k)
      if (to[k] != at_[k]) words += (words.empty() ? "" : " ") + std::string(1, "XYZ"[k]) + decimal(to[k]);
    at_ = to;
    if (!words.empty()) emit(motion, words, feed);
  }

  /// False when rounding leaves no arc that every control accepts.
  bool round(const Vec3& from, const ToolMove& m) {
    if ((m.center - from.head<2>()).norm() > 2 * largestRadius) return false;  // and may be beyond all ticks
    const Ticks to = ticks(m.to);
    const std::array<std::int64_t, 2> offset{ticks(m.center.x()) - at_[0], ticks(m.center.y()) - at_[1]};
    const auto vector = [&](std::int64_t x, std::int64_t y) {
      return Vec2(static_cast<double>(x) * resolution(), static_cast<double>(y) * resolution());
    };
    const Vec2 first = vector(-offset[0], -offset[1]);
    const Vec2 last = vector(to[0] - at_[0] - offset[0], to[1] - at_[1] - offset[1]);
    const double radius = first.norm();
    if (radius > largestRadius || radius < std::max(2 * resolution(), smallestRadius) ||
        std::abs(radius - last.norm()) > largestMismatch / 2)
      return false;
    ToolMove rounded;
    rounded.turn = m.turn;
    rounded.to = {last.x(), last.y(), 0};
    const double wanted = sweepOf(from, m), kept = sweepOf({first.x(), first.y(), 0}, rounded);
    if (std::abs(wanted - kept) * radius > 4 * resolution()) return false;
    if (radius * (1 - std::cos(std::min(std::abs(kept) / 2, fullTurn / 4))) < resolution() / 2) return false;
    std::string words = "X" + decimal(to[0]) + " Y" + decimal(to[1]);
    if (to[2] != at_[2]) words += " Z" + decimal(to[2]);
    words += " I" + decimal(offset[0]) + " J" + decimal(offset[1]);
    at_ = to;
    emit(m.turn > 0 ? "G3" : "G2", words, m.feed);
    return true;
  }

  void asLines(const Vec3& from, const ToolMove& m) {
    for (const Vec3& p : polylineOf(from, m, 1e-3)) straight("G1", ticks(p), m.feed);
  }

  const Toolpath& path_;
  const Post& post_;
  bool inch_ = false, numbered_ = false;
  int decimals_ = 4;
  double perMm_ = 1e4;
  int number_ = 0;
  Ticks at_{};
  std::string motion_, feed_, text_;
  std::optional<std::size_t> measuredAt_;  ///< position in the head where the gouge is inserted
};

}  // namespace

std::vector<ParameterSpec> gcodeWriteOptions() {
  std::vector<std::string> names;
  names.reserve(std::size(posts));
  for (const Post& post : posts) names.emplace_back(post.name);
  ParameterSpec post = choice(names);
  post.name = "post";
  post.fallback = "linuxcnc";
  post.help = "The control that the program is written for.";
  ParameterSpec decimals = count(2, 6);
  decimals.name = "decimals";
  decimals.fallback = 4;
  decimals.help = "Places after the point, in inches one more; for Fanuc at most 3.";
  ParameterSpec unit = choice({"mm", "inch"});
  unit.name = "unit";
  unit.fallback = "mm";
  unit.help = "What lengths are written in: G21 or G20.";
  ParameterSpec numbers = flag();
  numbers.name = "line-numbers";
  numbers.fallback = false;
  numbers.help = "Number the lines N10, N20, ..";
  return {post, decimals, unit, numbers};
}

std::string gcodeText(const Toolpath& path, const Value& options, const Progress& progress) {
  return GcodeWriter(path, options).write(progress);
}

void writeGcode(const Toolpath& path, const std::filesystem::path& file, const Value& options, const Progress& progress) {
  writeAtomically(file, gcodeText(path, options, progress));
}

}  // namespace blossom
