#pragma once
#include <fmt/format.h>

#include <cctype>
#include <cmath>
#include <cstdint>
#include <random>
#include <string>
#include <vector>

#include "support/planar_parts.h"
#include "support/random.h"

/// Pocket programs as people and other programs write them: by hand for several controls, in millimetres and inches,
/// absolute and relative, with centres in every notation.
namespace blossom::test {

struct HandMove {
  int motion = 0;  ///< G0 .. G3
  Vec3 to = Vec3::Zero();
  Vec2 center = Vec2::Zero();
  double feed = 0;
};

/// What is cut, and the moves that cut it.
struct HandJob {
  Region part;
  double depth = 0, diameter = 0;
  std::vector<HandMove> moves;  ///< the first two: over the place, and down to the safe height
};

enum class Centres { Offsets, Absolute, Radius };
enum class Dialect { LinuxCnc, Grbl, Fanuc, Mach };

struct HandStyle {
  Dialect dialect = Dialect::LinuxCnc;
  bool inch = false, relative = false, modal = true, numbered = false, lower = false, spaced = true, padded = false;
  bool comments = false, coolant = false;
  Centres centres = Centres::Offsets;
};

namespace hand {

class Path {
 public:
  explicit Path(double safe) : safe_(safe) {}
  void over(const Vec2& p) {
    if (!moves_.empty()) add(0, {at_.x(), at_.y(), safe_});
    add(0, {p.x(), p.y(), safe_});
    if (moves_.size() == 1) add(0, {p.x(), p.y(), safe_}, {}, true);
  }
  void down(double z) { add(0, {at_.x(), at_.y(), z}); }
  void line(const Vec3& to) { add(1, to); }
  void line(const Vec2& to) { add(1, {to.x(), to.y(), at_.z()}); }
  void arc(int turn, const Vec2& to, const Vec2& center) { add(turn > 0 ? 3 : 2, {to.x(), to.y(), at_.z()}, center); }
  void arc(int turn, const Vec3& to, const Vec2& center) { add(turn > 0 ? 3 : 2, to, center); }
  std::vector<HandMove> end() {
    add(0, {at_.x(), at_.y(), safe_});
    return std::move(moves_);
  }
  [[nodiscard]] const Vec3& at() const { return at_; }

 private:
  void add(int motion, const Vec3& to, const Vec2& center = Vec2::Zero(), bool always = false) {
    if (motion < 2 && !moves_.empty() && to == at_ && !always) return;
    const double feed = motion == 0 ? 0 : to.z() < at_.z() ? 120 : 640;
    moves_.push_back({motion, to, center, feed});
    at_ = to;
  }
  double safe_;
  Vec3 at_ = Vec3::Zero();
  std::vector<HandMove> moves_;
};

inline double rounded(double value, double step) { return std::round(value / step) * step; }

/// A rectangle with round corners at `away` from the walls, once around from the middle of its lower side.
inline void aroundRectangle(Path& path, const Vec2& low, const Vec2& high, double corner, double away, int turn) {
  const Vec2 a = low + Vec2(away, away), b = high - Vec2(away, away);
  const double r = corner - away;
  const Vec2 start((a.x() + b.x()) / 2, a.y());
  path.line(start);
  const double bend = std::max(r, 0.0);
  const std::vector<Vec2> middles{{b.x() - bend, a.y() + bend},
                                  {b.x() - bend, b.y() - bend},
                                  {a.x() + bend, b.y() - bend},
                                  {a.x() + bend, a.y() + bend}};
  const std::vector<Vec2> out{{0, -1}, {1, 0}, {0, 1}, {-1, 0}};
  for (std::size_t k = 0; k < 4; ++k) {
    const std::size_t i = turn > 0 ? k : 3 - k;
    const Vec2 first = middles[i] + bend * out[i], last = middles[i] + bend * out[(i + 1) % 4];
    path.line(turn > 0 ? first : last);
    if (bend > 0) path.arc(turn, turn > 0 ? last : first, middles[i]);
  }
  path.line(start);
}

/// Down to a level at p: straight, or to and fro along a ramp.
inline void enter(Path& path, const Vec2& p, double above, double z, bool ramps, double reach) {
  path.over(p);
  path.down(above + 1);
  if (!ramps) return path.line(Vec3(p.x(), p.y(), z));
  path.line(Vec3(p.x(), p.y(), above));
  path.line(Vec3(p.x() + reach, p.y(), (above + z) / 2));
  path.line(Vec3(p.x(), p.y(), z));
}

inline HandJob rectangleJob(std::mt19937_64& random) {
  HandJob job;
  const double step = 0.5;
  job.diameter = rounded(uniform(random, 3, 10), step);
  const double radius = job.diameter / 2, corner = radius + rounded(uniform(random, 0.5, 6), step);
  const Vec2 low(rounded(uniform(random, -40, 40), step), rounded(uniform(random, -40, 40), step));
  const Vec2 high =
      low + Vec2(rounded(uniform(random, 40, 90), step), rounded(uniform(random, 30, 60), step)) + Vec2(2 * corner, 0);
  Path path(random() % 2 == 0 ? 5 : 10);
  job.depth = rounded(uniform(random, 1, 8), 0.25);
  const int levels = 1 + static_cast<int>(random() % 3), turn = random() % 3 == 0 ? -1 : 1;
  const bool ramps = random() % 2 == 0;
  // The innermost way runs between a tenth of the diameter and the radius beside the middle: nothing is left there.
  const double over = 0.4 * job.diameter, widest = (high - low).minCoeff() / 2 - 0.1 * job.diameter;
  std::vector<double> aways;
  for (double away = radius; away < widest; away += over) aways.insert(aways.begin(), away);
  for (int k = 0; k < levels; ++k) {
    const double above = -job.depth * k / levels, z = -job.depth * (k + 1) / levels;
    const Vec2 start((low.x() + high.x()) / 2, low.y() + aways.front());
    enter(path, start, above, z, ramps, 5);
    for (const double away : aways) aroundRectangle(path, low, high, corner, away, turn);
  }
  job.moves = path.end();
  blossom::Path outline;
  outline.closed = true;
  const auto side = [&](const Vec2& a, const Vec2& b) { outline.segments.emplace_back(Line2{a, b}); };
  const auto bend = [&](const Vec2& c, double from) { outline.segments.emplace_back(Arc2{c, corner, from, fullTurn / 4}); };
  side({low.x() + corner, low.y()}, {high.x() - corner, low.y()});
  bend({high.x() - corner, low.y() + corner}, -fullTurn / 4);
  side({high.x(), low.y() + corner}, {high.x(), high.y() - corner});
  bend({high.x() - corner, high.y() - corner}, 0);
  side({high.x() - corner, high.y()}, {low.x() + corner, high.y()});
  bend({low.x() + corner, high.y() - corner}, fullTurn / 4);
  side({low.x(), high.y() - corner}, {low.x(), low.y() + corner});
  bend({low.x() + corner, low.y() + corner}, fullTurn / 2);
  job.part = {{outline}};
  return job;
}

inline void circle(Path& path, const Vec2& c, double r, int turn, int pieces) {
  for (int i = 1; i <= pieces; ++i) {
    const double angle = turn * fullTurn * i / pieces;
    path.arc(turn, i == pieces ? Vec2(c + Vec2(r, 0)) : Vec2(c + r * Vec2(std::cos(angle), std::sin(angle))), c);
  }
}

inline HandJob circleJob(std::mt19937_64& random) {
  HandJob job;
  job.diameter = rounded(uniform(random, 3, 10), 0.5);
  const double radius = job.diameter / 2, wall = job.diameter + rounded(uniform(random, 3, 25), 0.5);
  const Vec2 c(rounded(uniform(random, -60, 60), 0.25), rounded(uniform(random, -60, 60), 0.25));
  job.depth = rounded(uniform(random, 1, 8), 0.25);
  const int levels = 1 + static_cast<int>(random() % 3), turn = random() % 3 == 0 ? -1 : 1;
  const int pieces = random() % 2 == 0 ? 2 : 4;
  const bool winds = random() % 2 == 0;
  std::vector<double> radii;
  for (double r = wall - radius; r > 0.2 * radius; r -= 0.4 * job.diameter) radii.insert(radii.begin(), r);
  Path path(6);
  for (int k = 0; k < levels; ++k) {
    const double above = -job.depth * k / levels, z = -job.depth * (k + 1) / levels, r = radii.front();
    path.over(c + Vec2(r, 0));
    path.down(above + 1.5);
    path.line(Vec3(c.x() + r, c.y(), winds ? above : z));
    if (winds) {
      path.arc(turn, Vec3(c.x() - r, c.y(), (above + z) / 2), c);
      path.arc(turn, Vec3(c.x() + r, c.y(), z), c);
    }
    for (const double each : radii) {
      path.line(Vec2(c + Vec2(each, 0)));
      circle(path, c, each, turn, pieces);
    }
  }
  job.moves = path.end();
  job.part = {{circlePath(c, wall)}};
  return job;
}

/// A slot with round ends, cut along its middle and once around.
inline HandJob slotJob(std::mt19937_64& random) {
  HandJob job;
  job.diameter = rounded(uniform(random, 3, 8), 0.5);
  const double radius = job.diameter / 2, r = rounded(uniform(random, 0.5, 0.9) * radius, 0.25), wall = radius + r;
  const Vec2 a(rounded(uniform(random, -40, 40), 0.5), rounded(uniform(random, -40, 40), 0.5));
  const Vec2 b = a + Vec2(rounded(uniform(random, 20, 70), 0.5), 0);
  job.depth = rounded(uniform(random, 1, 6), 0.25);
  const int levels = 1 + static_cast<int>(random() % 3);
  Path path(5);
  for (int k = 0; k < levels; ++k) {
    const double above = -job.depth * k / levels, z = -job.depth * (k + 1) / levels;
    enter(path, a, above, z, random() % 2 == 0, 8);
    path.line(b);
    path.line(Vec2(b - Vec2(0, r)));
    path.arc(1, Vec2(b + Vec2(0, r)), b);
    path.line(Vec2(a + Vec2(0, r)));
    path.arc(1, Vec2(a - Vec2(0, r)), a);
    path.line(Vec2(b - Vec2(0, r)));
  }
  job.moves = path.end();
  blossom::Path outline;
  outline.closed = true;
  outline.segments = {Line2{a - Vec2(0, wall), b - Vec2(0, wall)}, Arc2{b, wall, -fullTurn / 4, fullTurn / 2},
                      Line2{b + Vec2(0, wall), a + Vec2(0, wall)}, Arc2{a, wall, fullTurn / 4, fullTurn / 2}};
  job.part = {{outline}};
  return job;
}

class Writer {
 public:
  Writer(const HandJob& job, const HandStyle& style) : job_(job), s_(style) {}

  std::string write() {
    preamble();
    start();
    for (std::size_t i = 2; i < job_.moves.size(); ++i) move(job_.moves[i]);
    finish();
    return std::move(text_);
  }

 private:
  [[nodiscard]] int places() const { return s_.inch ? 4 : 3; }
  [[nodiscard]] double step() const { return std::pow(10.0, -places()); }
  [[nodiscard]] std::int64_t ticks(double mm) const { return std::llround(mm / (s_.inch ? 25.4 : 1) / step()); }

  [[nodiscard]] std::string word(char letter, std::int64_t value) const {
    std::string number = fmt::format("{:.{}f}", static_cast<double>(value) * step(), places());
    if (!s_.padded) {
      number.erase(number.find_last_not_of('0') + 1);
      if (number.back() == '.' && s_.dialect != Dialect::Fanuc) number.pop_back();
      if (number == "-0") number = "0";
    }
    return letter + number;
  }
  [[nodiscard]] std::string g(int number) const { return fmt::format("G{:0{}d}", number, s_.padded ? 2 : 1); }
  [[nodiscard]] std::string m(int number) const { return fmt::format("M{:0{}d}", number, s_.padded ? 2 : 1); }

  void line(const std::vector<std::string>& words) {
    std::string all;
    if (s_.numbered) all = fmt::format("N{}", number_ += 5);
    for (const std::string& each : words) all += (all.empty() || !s_.spaced ? "" : " ") + each;
    if (s_.lower)
      for (char& c : all) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    text_ += all + (s_.comments && ++lines_ % 7 == 0 ? " (a remark: M5 and G2 X1 are no words here)" : "") + "\n";
  }

  void preamble() {
    const std::string units = s_.inch ? "G20" : "G21";
    switch (s_.dialect) {
      case Dialect::LinuxCnc:
        line({units, "G17", "G40", "G49", "G80", "G90", "G94"});
        line({"G64", s_.inch ? "P0.0004" : "P0.01"});
        line({"G54"});
        line({"T3", m(6)});
        line({"G43", "H3"});
        break;
      case Dialect::Grbl:
        line({"G17", units, "G90", "G94"});
        line({"G54"});
        break;
      case Dialect::Fanuc:
        text_ += "%\nO1234 (POCKET)\n";
        line({units, "G17", "G40", "G49", "G80"});
        line({"G91", "G28", "Z0."});
        line({"G90", "G54"});
        line({"T12", m(6)});
        break;
      case Dialect::Mach:
        line({g(0), "G49", "G40", "G17", "G80", "G50", "G90"});
        line({units});
        line({m(6), "T2"});
        line({"G43", "H2"});
        break;
    }
    if (s_.centres == Centres::Absolute) line({"G90.1"});
    if (s_.centres == Centres::Offsets && s_.dialect == Dialect::LinuxCnc) line({"G91.1"});
  }

  void start() {
    const HandMove& first = job_.moves[0];
    at_ = {ticks(first.to.x()), ticks(first.to.y()), ticks(first.to.z())};
    line({"S9000", m(3)});
    if (s_.dialect != Dialect::Fanuc) line({"G4", "P1"});
    line({g(0), word('X', at_[0]), word('Y', at_[1])});
    if (s_.dialect == Dialect::Fanuc)
      line({"G43", word('Z', at_[2]), "H12"});
    else
      line({g(0), word('Z', at_[2])});
    if (s_.coolant) line({m(8)});
    if (s_.relative) line({"G91"});
  }

  void move(const HandMove& move) {
    const std::array<std::int64_t, 3> to{ticks(move.to.x()), ticks(move.to.y()), ticks(move.to.z())};
    std::vector<std::string> words;
    if (!s_.modal || move.motion != motion_) words.push_back(g(move.motion));
    motion_ = move.motion;
    for (std::size_t k = 0; k < 3; ++k)
      if (to[k] != at_[k] || (move.motion > 1 && k < 2))
        words.push_back(word("XYZ"[k], s_.relative ? to[k] - at_[k] : to[k]));
    if (move.motion > 1) centre(move, words);
    if (move.feed > 0 && move.feed != feed_) words.push_back(fmt::format("F{:.1f}", move.feed / (s_.inch ? 25.4 : 1)));
    if (move.feed > 0) feed_ = move.feed;
    at_ = to;
    line(words);
  }

  void centre(const HandMove& move, std::vector<std::string>& words) const {
    const std::array<std::int64_t, 2> c{ticks(move.center.x()), ticks(move.center.y())};
    if (s_.centres == Centres::Radius) {
      const double radius = (move.to.head<2>() - move.center).norm();
      words.push_back(word('R', ticks(radius)));
      return;
    }
    const bool absolute = s_.centres == Centres::Absolute;
    words.push_back(word('I', absolute ? c[0] : c[0] - at_[0]));
    words.push_back(word('J', absolute ? c[1] : c[1] - at_[1]));
  }

  void finish() {
    if (s_.relative) line({"G90"});
    if (s_.coolant) line({m(9)});
    line({m(5)});
    if (s_.dialect == Dialect::Fanuc) {
      line({"G91", "G28", "Z0."});
      line({"G90"});
    }
    if (s_.dialect == Dialect::LinuxCnc) line({"G53", g(0), "Z0"});
    line({s_.dialect == Dialect::Grbl ? "M2" : "M30"});
    if (s_.dialect == Dialect::Fanuc) text_ += "%\n";
  }

  const HandJob& job_;
  HandStyle s_;
  std::string text_;
  int number_ = 0, lines_ = 0, motion_ = 0;
  double feed_ = 0;
  std::array<std::int64_t, 3> at_{};
};

}  // namespace hand

inline HandStyle anyStyle(std::mt19937_64& random) {
  const auto coin = [&] { return random() % 2 == 0; };
  HandStyle s;
  s.dialect = static_cast<Dialect>(random() % 4);
  s.inch = coin();
  s.relative = random() % 4 == 0;
  s.modal = coin();
  s.numbered = coin();
  s.lower = random() % 4 == 0;
  s.spaced = random() % 4 != 0;
  s.padded = coin();
  s.comments = coin();
  s.coolant = coin();
  s.centres = random() % 3 == 0 ? Centres::Absolute : Centres::Offsets;
  return s;
}

/// Radius notation is only meant for arcs well below half a turn: corners of rectangles.
inline HandJob anyJob(std::mt19937_64& random, HandStyle& style) {
  switch (random() % 3) {
    case 0:
      if (random() % 3 == 0) style.centres = Centres::Radius;
      return hand::rectangleJob(random);
    case 1:
      return hand::circleJob(random);
    default:
      return hand::slotJob(random);
  }
}

inline std::string writtenByHand(const HandJob& job, const HandStyle& style) { return hand::Writer(job, style).write(); }

}  // namespace blossom::test
