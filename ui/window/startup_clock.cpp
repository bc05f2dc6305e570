#include "ui/window/startup_clock.h"

#include <unistd.h>
#include <ctime>
#include <fstream>
#include <set>
#include <sstream>
#include <string>

#include <cstdio>

namespace blossom::ui {

namespace {

bool printing = false;

double now() {
  timespec time{};
  clock_gettime(CLOCK_BOOTTIME, &time);
  return static_cast<double>(time.tv_sec) * 1e3 + static_cast<double>(time.tv_nsec) / 1e6;
}

// Field 22 of /proc/self/stat, in ticks since the machine was started. The name in field 2 may hold spaces.
double processStart() {
  constexpr int fieldsAfterName = 19;
  std::ifstream file("/proc/self/stat");
  std::string line;
  std::getline(file, line);
  std::istringstream fields(line.substr(line.rfind(')') + 2));
  std::string skipped;
  for (int i = 0; i < fieldsAfterName; ++i) fields >> skipped;
  double ticks = 0;
  fields >> ticks;
  return ticks * 1e3 / static_cast<double>(sysconf(_SC_CLK_TCK));
}

}  // namespace

double msSinceStart() {
  static const double start = processStart();
  return now() - start;
}

void printTimings(bool wanted) { printing = wanted; }

void reached(const char* what) {
  static std::set<std::string> told;
  if (printing && told.insert(what).second) std::fprintf(stderr, "%6.0f ms  %s\n", msSinceStart(), what);
}

}  // namespace blossom::ui
