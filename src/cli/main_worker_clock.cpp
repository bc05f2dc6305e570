#include <sys/time.h>

#include <algorithm>
#include <cstdlib>
#include <ctime>

// OCCT asks gettimeofday for the dates that it writes into files, and ends the process when the year is before 1979. The
// worker, in which alone it reads and writes files, answers in the place of the C library: with the date that
// SOURCE_DATE_EPOCH names (seconds since 1970, as for every reproducible file), else with the clock's, if that has been set.
namespace {

constexpr std::time_t earliest = 315619200;  // 2 January 1980: that year in every time zone

std::time_t dateOfFiles() {
  if (const char* named = std::getenv("SOURCE_DATE_EPOCH"); named && *named)
    return std::max<std::time_t>(std::strtoll(named, nullptr, 10), earliest);
  return std::max(std::time(nullptr), earliest);
}

}  // namespace

extern "C" __attribute__((visibility("default"))) int gettimeofday(timeval* now, void*) noexcept {
  *now = {dateOfFiles(), 0};
  return 0;
}
