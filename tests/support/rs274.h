#pragma once
#include <QProcess>
#include <QStandardPaths>
#include <cctype>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <optional>
#include <sstream>
#include <string>

#include "geometry/shape/toolpath.h"

/// LinuxCNC's own interpreter as an oracle: it runs a program and prints what the machine would do, from which a toolpath
/// is made here without a line of our own reader.
namespace blossom::test {

inline bool haveInterpreter() { return !QStandardPaths::findExecutable("rs274").isEmpty(); }

#define NEED_INTERPRETER() \
  if (!blossom::test::haveInterpreter()) QSKIP("LinuxCNC's interpreter rs274 is not installed")

struct Interpreted {
  bool good = false;
  std::string log;  ///< what it printed, for messages
  Toolpath path;    ///< four places after the point, as it prints them
};

inline std::vector<double> numbersIn(const std::string& call) {
  std::string text = call.substr(call.find('(') + 1);
  for (char& c : text)
    if (c == ',' || c == ')') c = ' ';
  std::istringstream in(text);
  in.imbue(std::locale::classic());
  std::vector<double> numbers;
  for (double v = 0; in >> v;) numbers.push_back(v);
  return numbers;
}

/// The canonical calls: STRAIGHT_TRAVERSE(x, y, z, ..), STRAIGHT_FEED(x, y, z, ..), ARC_FEED(x, y, centre x, centre y,
/// turns, z, ..). A program that begins and ends at the machine's top goes there, across and down before its path begins,
/// and back up after it.
inline Toolpath toolpathOfCalls(const std::string& log, bool fromTop) {
  Toolpath path;
  int leading = fromTop ? 3 : 2;
  double feed = 0, unit = 1;
  std::istringstream lines(log);
  for (std::string line; std::getline(lines, line);) {
    const auto has = [&](const char* name) { return line.find(name) != std::string::npos; };
    if (has("COMMENT(")) continue;
    const std::vector<double> v = numbersIn(line);
    if (has("USE_LENGTH_UNITS(CANON_UNITS_INCHES)")) unit = 25.4;
    if (has("USE_LENGTH_UNITS(CANON_UNITS_MM)")) unit = 1;
    if (has("SET_FEED_RATE(")) feed = v.at(0) * unit;
    if (has("SET_SPINDLE_SPEED(")) path.cutter.spindle = v.at(1);
    const bool rapid = has("STRAIGHT_TRAVERSE("), straight = has("STRAIGHT_FEED("), arc = has("ARC_FEED(");
    if (!rapid && !straight && !arc) continue;
    ToolMove move;
    move.kind = rapid ? MoveKind::Rapid : MoveKind::Feed;
    move.feed = rapid ? 0 : feed;
    if (arc) {
      move.to = Vec3(v.at(0), v.at(1), v.at(5)) * unit;
      move.center = Vec2(v.at(2), v.at(3)) * unit;
      move.turn = v.at(4) > 0 ? 1 : -1;
    } else {
      move.to = Vec3(v.at(0), v.at(1), v.at(2)) * unit;
    }
    // The first rapids bring the tool to where the program begins.
    if (rapid && leading > 0 && path.moves.empty()) {
      --leading;
      path.start = move.to;
      continue;
    }
    if (!arc && move.to.z() < startOf(path, path.moves.size()).z()) move.kind = rapid ? MoveKind::Rapid : MoveKind::Plunge;
    path.moves.push_back(move);
  }
  if (fromTop && !path.moves.empty() && path.moves.back().kind == MoveKind::Rapid) path.moves.pop_back();
  return path;
}

inline Interpreted interpret(const std::filesystem::path& program) {
  QProcess process;
  process.setWorkingDirectory(QString::fromStdString(program.parent_path().string()));
  process.setProcessChannelMode(QProcess::SeparateChannels);
  process.start("rs274", {"-g", QString::fromStdString(program.string())});
  Interpreted result;
  if (!process.waitForFinished(120000)) {
    result.log = "rs274 did not end";
    return result;
  }
  const std::string calls = process.readAllStandardOutput().toStdString();
  result.good = process.exitStatus() == QProcess::NormalExit && process.exitCode() == 0 &&
                calls.find("PROGRAM_END") != std::string::npos;
  result.log = process.readAllStandardError().toStdString() + calls.substr(calls.size() > 600 ? calls.size() - 600 : 0);
  std::ifstream file(program);
  const std::string text{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  if (result.good) result.path = toolpathOfCalls(calls, text.find("G53 G0 Z0") != std::string::npos);
  return result;
}

}  // namespace blossom::test
