#include "core/memory.h"

#if __has_include(<malloc.h>)
#include <malloc.h>
#endif

namespace blossom {

void keepFreedMemory() noexcept {
#ifdef M_MMAP_THRESHOLD
  constexpr int megabyte = 1 << 20;
  ::mallopt(M_MMAP_THRESHOLD, 32 * megabyte);  // the largest that glibc takes
  ::mallopt(M_TRIM_THRESHOLD, 256 * megabyte);
#endif
}

}  // namespace blossom
