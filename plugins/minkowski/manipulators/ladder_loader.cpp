#include "manipulators/ladder_loader.h"

#include <exception>
#include <utility>

#include "geometry/planar/planar.h"
#include "geometry/shape/bounds.h"
#include "kernel/morph/ladder.h"

namespace blossom::minkowski {
namespace {

constexpr std::size_t workOfSomeSeconds = 400'000'000;  // see effort.h
constexpr double chordOfSize = 5e-4;

LadderShape drawnShape(const Region& shape) {
  LadderShape drawn;
  const double size = bounds(Shape(shape)).diagonal();
  if (!(size > 0)) return drawn;
  drawn.area = area(shape);
  for (const Path& loop : shape.loops) {
    std::vector<Vec3>& line = drawn.lines.emplace_back();
    for (const Vec2& p : flatten(loop, chordOfSize * size)) line.emplace_back(p.x(), p.y(), 0);
    line.push_back(line.front());
  }
  return drawn;
}

/// Without the ends, which are drawn anyway.
LadderLines linesOf(const LadderQuestion& question, const Progress& progress) {
  std::vector<Region> shapes = question.shapes;
  faceSectors(shapes, question.sectors, question.tolerance, progress);
  const LadderResult result =
      ladder(shapes, question.t, {.tolerance = question.tolerance, .maximumWork = workOfSomeSeconds}, progress);
  LadderLines lines;
  lines.complete = result.complete;
  for (std::size_t r = 1; r < result.levels.size() && r + 1 < question.shapes.size(); ++r) {
    std::vector<LadderShape>& level = lines.levels.emplace_back();
    for (const Region& shape : result.levels[r]) {
      progress.check();
      level.push_back(drawnShape(shape));
    }
  }
  return lines;
}

}  // namespace

LadderLoader::LadderLoader(Arrived arrived) : arrived_(std::move(arrived)) {}

LadderLoader::~LadderLoader() { token_.cancel(); }

void LadderLoader::ask(std::optional<LadderQuestion> question) {
  if (question == asked_) return;
  asked_ = std::move(question);
  waiting_ = asked_.has_value();
  if (!asked_) token_.cancel();
  if (waiting_ && !running_) start();
}

void LadderLoader::start() {
  waiting_ = false;
  running_ = true;
  token_ = {};
  thread_.start([this, question = *asked_, token = token_] { compute(question, token); });
}

void LadderLoader::compute(const LadderQuestion& question, const CancelToken& token) {
  std::shared_ptr<const LadderLines> lines;
  try {
    lines = std::make_shared<const LadderLines>(linesOf(question, Progress(token)));
  } catch (const std::exception&) {
    lines = nullptr;  // the morph itself says what is wrong with it
  }
  here_.post([this, token, lines = std::move(lines)] { finished(lines, token); });
}

void LadderLoader::finished(std::shared_ptr<const LadderLines> lines, const CancelToken& token) {
  running_ = false;
  if (waiting_) start();
  const Arrived arrived = arrived_;  // who is told may end the loader
  if (!token.cancelled()) arrived(std::move(lines));
}

}  // namespace blossom::minkowski
