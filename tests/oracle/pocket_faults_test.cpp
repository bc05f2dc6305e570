// Programs with one fault each, of every kind that ruins work, and good ones beside them: the simulation tells every fault
// with its line, and leaves the good ones alone.
#include <array>
#include <regex>

#include "core/file.h"
#include "exchange/format/format.h"
#include "exchange/gcode/gcode_write.h"
#include "support/hand_programs.h"
#include "support/modeling.h"
#include "support/program_faults.h"

using namespace blossom;
using namespace blossom::test;

namespace {

struct GoodProgram {
  std::string text;
  Region part;
  double depth = 0, diameter = 0;  ///< 0: its head tells them
};

GoodProgram byHand(std::mt19937_64& random) {
  HandStyle style = anyStyle(random);
  HandJob job = anyJob(random, style);
  return {writtenByHand(job, style), std::move(job.part), job.depth, job.diameter};
}

Region ownPart(std::mt19937_64& random) {
  const double x = uniform(random, -50, 50), y = uniform(random, -50, 50);
  switch (random() % 4) {
    case 0:
      return {{boxPath(x, y, x + 60, y + 40), circlePath({x + 30, y + 20}, 7, true)}};
    case 1:
      return {{wavyPath({x, y}, 25, 4, 5)}};
    case 2:
      return hand::rectangleJob(random).part;
    default:
      return {{circlePath({x, y}, 18), circlePath({x + 5, y}, 4, true)}};
  }
}

/// One of Blossom's own, for any control.
GoodProgram own(std::mt19937_64& random) {
  const auto one = [&](std::initializer_list<const char*> names) { return std::data(names)[random() % names.size()]; };
  GoodProgram program{.text = {}, .part = ownPart(random)};
  const Value parameters{{"tool-diameter", 3 + static_cast<double>(random() % 4)},
                         {"depth", 2 + static_cast<double>(random() % 3)},
                         {"entry", one({"ramp", "helix", "plunge"})},
                         {"direction", one({"climb", "conventional"})},
                         {"finish", random() % 2 == 0 ? 0.0 : 0.3},
                         {"zero", one({"drawing", "corner", "center"})},
                         {"zero-height", one({"top", "bottom"})}};
  const Evaluated path = made("pocket", parameters, {Shape(program.part)});
  program.text = gcodeText(*path.shape.get<Toolpath>(), {{"post", one({"linuxcnc", "grbl", "mach3", "fanuc"})},
                                                         {"unit", one({"mm", "inch"})},
                                                         {"decimals", 3.0 + static_cast<double>(random() % 2)},
                                                         {"line-numbers", random() % 2 == 0}});
  return program;
}

/// Everything that reading and simulating it tell.
std::vector<std::string> toldOf(const std::string& text, const GoodProgram& program) {
  const TemporaryFolder folder;
  const fs::path file = folder.path() / "program.nc";
  writeAtomically(file, text);
  std::vector<std::string> told;
  try {
    const Imported read = readShape(*theApp().formats, file);
    told = read.warnings;
    const Value options{{"depth", program.depth}, {"tool-diameter", program.diameter}};
    const Evaluated swept = made("simulate", options, {read.shape, Shape(program.part)});
    told.insert(told.end(), swept.warnings.begin(), swept.warnings.end());
    return told;
  } catch (const Error& error) {
    told.push_back(error.message() + " " + error.hint());
    return told;
  }
}

bool names(const std::vector<std::string>& told, const std::set<std::size_t>& lines) {
  static const std::regex mention("[Ll]ine (\\d+)");
  for (const std::string& sentence : told)
    for (auto it = std::sregex_iterator(sentence.begin(), sentence.end(), mention); it != std::sregex_iterator(); ++it)
      if (lines.empty() || lines.contains(std::stoul((*it)[1]))) return true;
  return false;
}

std::string joinedText(const std::vector<std::string>& told) {
  std::string all;
  for (const std::string& each : told) all += "\n    " + each;
  return all.empty() ? "\n    nothing is told" : all;
}

std::size_t howMany() {
  const char* given = std::getenv("BLOSSOM_FAULTY_PROGRAMS");
  return given ? std::strtoul(given, nullptr, 10) : 24;
}

GoodProgram any(std::mt19937_64& random) { return random() % 5 < 2 ? own(random) : byHand(random); }

void keep(const std::string& text, const std::string& name) {
  if (const char* folder = std::getenv("BLOSSOM_KEEP_PROGRAMS")) writeAtomically(fs::path(folder) / name, text);
}

}  // namespace

class PocketFaultsTest final : public QObject {
  Q_OBJECT
 private slots:
  void everyFaultIsToldWithItsLine() {
    auto random = seededRandom();
    std::array<int, faults.size()> made{}, missed{};
    std::string first;
    const std::size_t wanted = howMany();
    for (std::size_t i = 0; i < wanted;) {
      const std::size_t kind = i % faults.size();
      const GoodProgram program = any(random);
      const auto faulty = withFault(faults[kind], program.text, random);
      if (!faulty) continue;
      ++made[kind];
      ++i;
      const std::vector<std::string> told = toldOf(faulty->text, program);
      if (names(told, faulty->lines)) continue;
      ++missed[kind];
      keep(faulty->text, fmt::format("missed-{}-{}.nc", kind, i));
      keep(program.text, fmt::format("missed-{}-{}-good.nc", kind, i));
      const std::string line = faulty->lines.empty() ? "any" : std::to_string(*faulty->lines.begin());
      first += fmt::format("\n  program {}, {} in line {}:{}", i, faultNames[kind], line, joinedText(told));
    }
    int told = 0;
    for (std::size_t k = 0; k < faults.size(); ++k) {
      std::printf("figure told_%zu %d of %d: %s\n", k, made[k] - missed[k], made[k], faultNames[k]);
      told += made[k] - missed[k];
    }
    std::printf("figure faulty %zu\nfigure faults_told %d\n", wanted, told);
    std::fflush(stdout);
    QVERIFY2(first.empty(), first.c_str());
  }

  void goodProgramsAreLeftAlone() {
    auto random = seededRandom();
    std::size_t flagged = 0;
    std::string first;
    const std::size_t wanted = howMany();
    for (std::size_t i = 0; i < wanted; ++i) {
      const GoodProgram program = any(random);
      const std::vector<std::string> told = toldOf(program.text, program);
      if (told.empty()) continue;
      ++flagged;
      keep(program.text, fmt::format("flagged-{}.nc", i));
      first += fmt::format("\n  program {}:{}", i, joinedText(told));
    }
    std::printf("figure good %zu\nfigure good_flagged %zu\n", wanted, flagged);
    std::fflush(stdout);
    QVERIFY2(flagged * 100 <= wanted, first.c_str());
  }
};

BLOSSOM_TEST(PocketFaultsTest)
#include "pocket_faults_test.moc"
