#include "core/thread_priority.h"

#include <sys/resource.h>
#include <unistd.h>

namespace blossom {

namespace {
constexpr int behindTheWindow = 10;  // of 19: a tenth of the share of a thread of ordinary rank
}

// On Linux the nice value belongs to the thread. It may be refused where it is higher already, which is as good.
void lowerThreadPriority() { ::setpriority(PRIO_PROCESS, static_cast<id_t>(::gettid()), behindTheWindow); }

}  // namespace blossom
