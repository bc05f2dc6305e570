#include "worker/limits.h"

#include <malloc.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <fstream>

#include "core/sanitizers.h"

namespace blossom {

namespace {

using Resource = decltype(RLIMIT_AS);

rlimit currentLimit(Resource resource) {
  rlimit current{};
  ::getrlimit(resource, &current);
  return current;
}

/// Those this process was started with.
rlim_t inheritedSeconds() {
  static const rlim_t inherited = currentLimit(RLIMIT_CPU).rlim_cur;
  return inherited;
}
rlim_t inheritedMemory() {
  static const rlim_t inherited = currentLimit(RLIMIT_AS).rlim_cur;
  return inherited;
}

/// A value above the limit of the system's administrator leaves `otherwise`.
void limit(Resource resource, rlim_t value, rlim_t otherwise) {
  rlimit current = currentLimit(resource);
  current.rlim_cur = current.rlim_max != RLIM_INFINITY && value > current.rlim_max ? otherwise : value;
  ::setrlimit(resource, &current);
}

double secondsComputed() {
  rusage usage{};
  ::getrusage(RUSAGE_SELF, &usage);
  const auto seconds = [](const timeval& t) { return static_cast<double>(t.tv_sec) + static_cast<double>(t.tv_usec) / 1e6; };
  return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

rlim_t physicalMemory() {
  return static_cast<rlim_t>(::sysconf(_SC_PHYS_PAGES)) * static_cast<rlim_t>(::sysconf(_SC_PAGESIZE));
}

/// Bytes in memory that are this process's own, without what it shares with others.
double ownMemory() {
  std::ifstream stream("/proc/self/statm");
  double size = 0, resident = 0, shared = 0;
  stream >> size >> resident >> shared;
  return (resident - shared) * static_cast<double>(::sysconf(_SC_PAGESIZE));
}

}  // namespace

void applyLimits(const Value& request) {
  limit(RLIMIT_CORE, 0, 0);  // a crash on a damaged file is an answer, not something to dump gigabytes for
  const double seconds = request.value("cpu_seconds", 0.0);
  limit(RLIMIT_CPU, seconds > 0 ? static_cast<rlim_t>(std::ceil(secondsComputed() + seconds)) : inheritedSeconds(),
        inheritedSeconds());
  if (hasShadowMemory) return;
  const rlim_t memory = request.value("memory", rlim_t{0});
  limit(RLIMIT_AS, memory > 0 ? memory : physicalMemory(), inheritedMemory());
}

bool mayServeAgain() {
  if (inheritedSeconds() != RLIM_INFINITY) return false;  // that of all its calls together would count
  if (hasShadowMemory) return true;
  constexpr double most = 128e6;
  if (ownMemory() <= most) return true;
  ::malloc_trim(0);
  return ownMemory() <= most;
}

}  // namespace blossom
