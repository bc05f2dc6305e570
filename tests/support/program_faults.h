#pragma once
#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <numbers>
#include <random>
#include <set>

#include "support/program_listing.h"

/// The faults that ruin work and that a program's text alone does not show: put into good programs one at a time.
namespace blossom::test {

enum class Fault {
  LengthOfAnotherTool,
  NoUnits,
  SpindleStopped,
  ZeroShifted,
  RapidInMaterial,
  TooDeep,
  ArcCentre,
  BareBlending
};
inline constexpr std::array faults{Fault::LengthOfAnotherTool, Fault::NoUnits, Fault::SpindleStopped, Fault::ZeroShifted,
                                   Fault::RapidInMaterial,     Fault::TooDeep, Fault::ArcCentre,      Fault::BareBlending};
inline constexpr std::array faultNames{"H unlike T",        "no G20/G21", "M5 before the last cut", "zero shifted",
                                       "rapid in material", "too deep",   "arc's centre",           "bare G64"};

struct FaultyProgram {
  std::string text;
  std::set<std::size_t> lines;  ///< any of which may be named; empty: whichever
};

namespace faulty {

inline int placesOf(double unit) { return unit > 1 ? 5 : 3; }

inline std::optional<FaultyProgram> lengthOfAnotherTool(Listing p, std::mt19937_64& random) {
  for (std::size_t i = 0; i < p.lines.size(); ++i) {
    if (!p.word(i, 'H')) continue;
    p.change(i, 'H', 1 + static_cast<double>(random() % 7), 0);
    return FaultyProgram{p.text(), {i + 1}};
  }
  return std::nullopt;
}

inline std::optional<FaultyProgram> noUnits(Listing p) {
  for (std::size_t i = 0; i < p.lines.size(); ++i)
    for (const ListedWord& w : wordsOf(p.lines[i]))
      if (w.letter == 'G' && (w.value() == 20 || w.value() == 21)) {
        p.erase(i, w);
        const auto moves = p.moves();
        const auto first = std::find_if(moves.begin(), moves.end(), [](const ListedMove& m) { return m.motion >= 0; });
        return FaultyProgram{p.text(), {static_cast<std::size_t>(first - moves.begin()) + 1}};
      }
  return std::nullopt;
}

inline std::optional<FaultyProgram> spindleStopped(Listing p) {
  const auto moves = p.moves();
  for (std::size_t i = moves.size(); i-- > 0;)
    if (moves[i].cuts()) {
      p.lines.insert(p.lines.begin() + static_cast<std::ptrdiff_t>(i), "M5");
      return FaultyProgram{p.text(), {i + 1, i + 2}};
    }
  return std::nullopt;
}

inline std::optional<FaultyProgram> zeroShifted(Listing p, std::mt19937_64& random) {
  std::uniform_real_distribution<double> amount(0.1001, 0.8);
  const std::size_t axis = random() % 3;
  const double by = (random() % 2 == 0 ? 1 : -1) * amount(random);
  bool absoluteCentres = false;
  const auto moves = p.moves();
  for (std::size_t i = 0; i < p.lines.size(); ++i) {
    for (const ListedWord& w : wordsOf(p.lines[i]))
      absoluteCentres = absoluteCentres || (w.letter == 'G' && w.number == "90.1");
    if (moves[i].motion < 0) continue;
    if (moves[i].absolute && p.word(i, "XYZ"[axis])) p.change(i, "XYZ"[axis], by / moves[i].unit, placesOf(moves[i].unit));
    if (absoluteCentres && axis < 2 && p.word(i, "IJ"[axis]))
      p.change(i, "IJ"[axis], by / moves[i].unit, placesOf(moves[i].unit));
  }
  return FaultyProgram{p.text(), {}};
}

inline std::optional<FaultyProgram> rapidInMaterial(Listing p, std::mt19937_64& random) {
  const auto moves = p.moves();
  const auto first =
      std::find_if(moves.begin(), moves.end(), [](const ListedMove& m) { return m.cuts() && m.to.z() < -1e-6; });
  if (first == moves.end()) return std::nullopt;
  const auto i = static_cast<std::size_t>(first - moves.begin());
  const bool plunges = (first->to - first->from).head<2>().norm() < 1e-6 && first->to.z() < -0.1;
  if (plunges && random() % 2 == 0) {
    const std::optional<ListedWord> g = p.word(i, 'G');
    if (g)
      p.lines[i].replace(g->at, g->length, "G0");
    else
      p.lines[i].insert(wordsOf(p.lines[i]).front().letter == 'N' ? wordsOf(p.lines[i])[0].length : 0, "G0 ");
    for (std::size_t k = i + 1; k < p.lines.size(); ++k) {
      if (moves[k].motion < 0) continue;
      if (!p.word(k, 'G')) {
        const auto words = wordsOf(p.lines[k]);
        p.lines[k].insert(words.front().letter == 'N' ? words.front().at + words.front().length : words.front().at,
                          " G" + std::to_string(moves[k].motion) + " ");
      }
      break;
    }
    return FaultyProgram{p.text(), {i + 1}};
  }
  // the rapid that comes down before it, or where there is none the plunge as one
  for (std::size_t k = i; k-- > 0;) {
    if (moves[k].motion < 0 || moves[k].cuts()) continue;
    if (!p.word(k, 'Z') || !moves[k].absolute) continue;
    const double depth = 0.1 + 0.2 * static_cast<double>(random() % 100) / 100;
    p.change(k, 'Z', (-depth - 0.001 - moves[k].to.z()) / moves[k].unit, placesOf(moves[k].unit));
    return FaultyProgram{p.text(), {k + 1, k + 2}};
  }
  return std::nullopt;
}

inline std::optional<FaultyProgram> tooDeep(Listing p, std::mt19937_64& random) {
  const auto moves = p.moves();
  double low = 0;
  for (const ListedMove& m : moves)
    if (m.cuts()) low = std::min(low, m.to.z());
  std::vector<std::size_t> deepest;
  for (std::size_t i = 0; i < moves.size(); ++i)
    if (moves[i].cuts() && moves[i].to.z() < low + 1e-6 && p.word(i, 'Z')) deepest.push_back(i);
  if (deepest.empty()) return std::nullopt;
  const std::size_t i = deepest[random() % deepest.size()];
  p.change(i, 'Z', -0.1 / moves[i].unit, placesOf(moves[i].unit));
  return FaultyProgram{p.text(), {i + 1}};
}

/// mm, the farthest that an arc between the same ends moves with its centre.
inline double arcMovedBy(const ListedMove& move, const Vec2& centre, const Vec2& slip) {
  const Vec2 first = move.from.head<2>() - centre, last = move.to.head<2>() - centre;
  const double turn = move.motion == 3 ? 1 : -1;
  double sweep = turn * std::atan2(cross(first, last), first.dot(last));
  if (sweep <= 1e-9) sweep += 2 * std::numbers::pi;
  double farthest = 0;
  for (const double t : {0.125, 0.25, 0.375, 0.5, 0.625, 0.75, 0.875}) {
    const Vec2 p = centre + Eigen::Rotation2Dd(turn * t * sweep) * first;
    const double radius = (1 - t) * (first - slip).norm() + t * (last - slip).norm();
    farthest = std::max(farthest, std::abs((p - centre - slip).norm() - radius));
  }
  return farthest;
}

/// The centre of an arc off by 0.05 mm, where that moves the tool by more than two steps of what programs are rounded to
/// (three places of mm, four of inches): the centre of a short arc of a large radius may lie anywhere.
inline std::optional<FaultyProgram> arcCentre(Listing p, std::mt19937_64& random) {
  const auto moves = p.moves();
  struct Centre {
    std::size_t line;
    char letter;
    double slip;
  };
  std::vector<Centre> centres;
  bool absolute = false;
  for (std::size_t i = 0; i < moves.size(); ++i) {
    for (const ListedWord& w : wordsOf(p.lines[i])) absolute = absolute || (w.letter == 'G' && w.number == "90.1");
    if (moves[i].motion < 2) continue;
    Vec2 centre = absolute ? Vec2(0, 0) : Vec2(moves[i].from.head<2>());
    for (const int axis : {0, 1})
      if (const auto word = p.word(i, "IJ"[axis])) centre[axis] += word->value() * moves[i].unit;
    for (const int axis : {0, 1})
      for (const double slip : {0.05, -0.05})
        if (p.word(i, "IJ"[axis]) &&
            arcMovedBy(moves[i], centre, slip * Vec2::Unit(axis)) > moves[i].unit * (moves[i].unit > 1 ? 2e-4 : 2e-3))
          centres.push_back({i, "IJ"[axis], slip});
  }
  if (centres.empty()) return std::nullopt;
  const auto [i, letter, slip] = centres[random() % centres.size()];
  p.change(i, letter, slip / moves[i].unit, placesOf(moves[i].unit));
  return FaultyProgram{p.text(), {i + 1}};
}

inline std::optional<FaultyProgram> bareBlending(Listing p) {
  std::size_t first = p.lines.size();
  for (std::size_t i = 0; i < p.lines.size(); ++i)
    for (const ListedWord& w : wordsOf(p.lines[i])) {
      if (w.letter != 'G') continue;
      if (w.value() == 64 && p.word(i, 'P')) {
        p.erase(i, *p.word(i, 'P'));
        return FaultyProgram{p.text(), {i + 1}};
      }
      if (first == p.lines.size() && (w.value() == 20 || w.value() == 21)) first = i;
    }
  if (first == p.lines.size()) return std::nullopt;
  p.lines.insert(p.lines.begin() + static_cast<std::ptrdiff_t>(first) + 1, "G64");
  return FaultyProgram{p.text(), {first + 2}};
}

}  // namespace faulty

/// Nothing where the program has no place for such a fault: one without a tool's length has no wrong one.
inline std::optional<FaultyProgram> withFault(Fault fault, const std::string& program, std::mt19937_64& random) {
  const Listing p(program);
  switch (fault) {
    case Fault::LengthOfAnotherTool:
      return faulty::lengthOfAnotherTool(p, random);
    case Fault::NoUnits:
      return faulty::noUnits(p);
    case Fault::SpindleStopped:
      return faulty::spindleStopped(p);
    case Fault::ZeroShifted:
      return faulty::zeroShifted(p, random);
    case Fault::RapidInMaterial:
      return faulty::rapidInMaterial(p, random);
    case Fault::TooDeep:
      return faulty::tooDeep(p, random);
    case Fault::ArcCentre:
      return faulty::arcCentre(p, random);
    case Fault::BareBlending:
      return faulty::bareBlending(p);
  }
  return std::nullopt;
}

}  // namespace blossom::test
