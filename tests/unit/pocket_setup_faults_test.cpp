#include <algorithm>
#include <functional>
#include <string>

#include "geometry/shape/bounds.h"
#include "support/block_solids.h"
#include "support/modeling.h"
#include "support/random.h"
#include "support/support.h"

using namespace blossom;
using namespace blossom::test;

namespace {

/// A block with a pocket and a boss in it, how it is clamped, and the program of its pocket.
struct Job {
  Shape solid, setup;
  Value setupValues = Value::object(), pocketValues = Value::object();
  Block pocket;
  double tool = 6;
  Toolpath path;
};

Value boxValue(const Vec3& corner, const Vec3& size) {
  return {{"corner", {corner.x(), corner.y(), corner.z()}}, {"size", {size.x(), size.y(), size.z()}}};
}

Job randomJob(std::mt19937_64& random) {
  Job job;
  const Vec3 size(uniform(random, 50, 90), uniform(random, 40, 70), uniform(random, 15, 30));
  const double wall = uniform(random, 6, 10), depth = uniform(random, 4, size.z() - 4);
  job.pocket = {{wall, wall, size.z() - depth}, {size.x() - wall, size.y() - wall, size.z()}};
  job.solid = without(solidOf({{0, 0, 0}, size}), {job.pocket.low, job.pocket.high + Vec3(0, 0, 5)});
  job.tool = uniform(random, 3, 9);
  const bool hasBoss = uniformInt(random, 0, 1) == 1;
  const Vec3 boss = (job.pocket.low + job.pocket.high) / 2;
  if (hasBoss) job.solid = with(job.solid, {{boss.x() - 3, boss.y() - 3, 0}, {boss.x() + 3, boss.y() + 3, size.z()}});
  const double margin = uniform(random, 1, 6), above = uniformInt(random, 0, 1) * uniform(random, 0.2, 2);
  const double height = uniform(random, 5, 25);
  job.setupValues = {{"stock-margin", margin},
                     {"stock-above", above},
                     {"clamps",
                      {boxValue({-margin - 12, 5, size.z() - 5}, {12, 20, height}),
                       boxValue({size.x() + margin, 5, size.z() - 5}, {12, 20, height})}},
                     {"zero", std::array{"drawing", "corner", "center"}[static_cast<std::size_t>(uniformInt(random, 0, 2))]},
                     {"zero-height", std::array{"top", "bottom"}[static_cast<std::size_t>(uniformInt(random, 0, 1))]}};
  job.setup = made("setup", job.setupValues, {job.solid}).shape;
  const Brep& brep = *job.solid.get<Brep>();
  for (int face = 0; job.pocketValues.empty(); ++face) {
    const Bounds box = bounds(Shape(Brep(faceOf(brep, face))));
    if (box.high.z() - box.low.z() < 1e-6 && std::abs(box.low.z() - job.pocket.low.z()) < 1e-6)
      job.pocketValues = {{"face", pocketOnFace(face)}};
  }
  Value values = job.pocketValues;
  values["tool-diameter"] = job.tool;
  values["stepdown"] = uniform(random, 1, 6);
  values["stepover"] = std::to_string(uniformInt(random, 20, 90)) + "%";
  values["entry"] = std::array{"ramp", "helix", "plunge"}[static_cast<std::size_t>(uniformInt(random, 0, 2))];
  values["flute-length"] = depth + above + 1;
  values["stick-out"] = depth + above + 26;  // above the clamps
  values["holder-diameter"] = 30;
  job.path = *made("pocket", values, {job.solid, job.setup}).shape.get<Toolpath>();
  return job;
}

/// The warnings of a simulation of it, as one text.
std::string toldOf(const Job& job, const Toolpath& path, const Shape& setup, Value more = Value::object()) {
  Value values = job.pocketValues;
  values.update(more);
  std::string all;
  for (const std::string& each : made("simulate", values, {path, job.solid, setup}).warnings) all += each + "\n";
  return all;
}

bool tellsOfHit(const std::string& told) {
  return told.find("runs into") != std::string::npos || told.find("goes through the stock") != std::string::npos ||
         told.find("travel") != std::string::npos || told.find("gouged") != std::string::npos ||
         told.find("through material") != std::string::npos;
}

/// Somewhere in the middle of the program, at the pocket's floor.
std::size_t someCut(const Toolpath& path, std::mt19937_64& random) {
  while (true) {
    const auto i = static_cast<std::size_t>(uniformInt(random, 0, static_cast<int>(path.moves.size()) - 1));
    if (path.moves[i].kind == MoveKind::Feed) return i;
  }
}

using Fault = std::function<std::string(const Job&, std::mt19937_64&)>;

std::string holderTooLow(const Job& job, std::mt19937_64& random) {
  const double depth = job.pocket.high.z() - job.pocket.low.z();
  return toldOf(job, job.path, job.setup,
                {{"flute-length", depth / 4}, {"stick-out", uniform(random, 0.3, 0.9) * depth}, {"holder-diameter", 40}});
}

std::string clampInTheWay(const Job& job, std::mt19937_64& random) {
  const Setup& held = *job.setup.get<Setup>();
  const Vec3 tip = job.path.moves[someCut(job.path, random)].to;
  Setup other = held;
  const Vec3 corner = tip - Vec3(2, 2, 1);
  other.clamps = {{corner, corner + Vec3(4, 4, 30), false}};
  return toldOf(job, job.path, other);
}

std::string travelTooShort(const Job& job, std::mt19937_64& random) {
  Setup other = *job.setup.get<Setup>();
  Bounds way;
  for (const ToolMove& move : job.path.moves) way.add(move.to);
  other.travel = way;
  const int axis = uniformInt(random, 0, 2);
  (uniformInt(random, 0, 1) == 0 ? other.travel.high[axis] : other.travel.low[axis]) = way.center()[axis];
  return toldOf(job, job.path, other);
}

/// A rapid across, from the middle of the work to far aside, at the height of the cut.
std::string rapidAcross(const Job& job, std::mt19937_64& random) {
  Toolpath path = job.path;
  const std::size_t at = someCut(path, random);
  const Vec3 from = path.moves[at].to;
  path.moves.insert(path.moves.begin() + static_cast<std::ptrdiff_t>(at) + 1,
                    {{MoveKind::Rapid, from + Vec3(200, 0, 0), 0, {0, 0}, 0, 0}, {MoveKind::Rapid, from, 0, {0, 0}, 0, 0}});
  return toldOf(job, path, job.setup);
}

std::string cutIntoTheWall(const Job& job, std::mt19937_64& random) {
  Toolpath path = job.path;
  Bounds way;
  for (const ToolMove& move : path.moves)
    if (move.kind == MoveKind::Feed) way.add(move.to);
  const Vec3 out(way.high.x() + uniform(random, 0.2, 3), way.center().y(), way.low.z());
  const Vec3 last = path.moves.back().to;
  path.moves.push_back({MoveKind::Feed, out + Vec3(0, 0, 1), 0, {0, 0}, 500, 0});
  path.moves.push_back({MoveKind::Rapid, last, 0, {0, 0}, 0, 0});
  return toldOf(job, path, job.setup);
}

}  // namespace

/// Good programs in random setups, and the same with faults that only the whole setup shows.
class PocketSetupFaultsTest final : public QObject {
  Q_OBJECT
 private slots:
  void goodProgramsPassAndFaultyOnesAreTold() {
    std::mt19937_64 random = seededRandom();
    const std::vector<std::pair<const char*, Fault>> faults{{"holder too low", holderTooLow},
                                                            {"clamp in the way", clampInTheWay},
                                                            {"travel too short", travelTooShort},
                                                            {"rapid across", rapidAcross},
                                                            {"cut into the wall", cutIntoTheWall}};
    int good = 0, flagged = 0, faulty = 0, missed = 0;
    for (int k = 0; k < 12; ++k) {
      const Job job = randomJob(random);
      ++good;
      if (const std::string told = toldOf(job, job.path, job.setup); tellsOfHit(told)) {
        ++flagged;
        qInfo("good program %d: %s", k, told.c_str());
      }
      for (const auto& [name, fault] : faults) {
        ++faulty;
        if (tellsOfHit(fault(job, random))) continue;
        ++missed;
        qInfo("missed in program %d: %s", k, name);
      }
    }
    std::printf(
        "figure setup_good %d\nfigure setup_good_flagged %d\nfigure setup_faulty %d\nfigure setup_faulty_missed %d\n", good,
        flagged, faulty, missed);
    QCOMPARE(missed, 0);
    QCOMPARE(flagged, 0);
  }
};

BLOSSOM_TEST(PocketSetupFaultsTest)
#include "pocket_setup_faults_test.moc"
