#pragma once

namespace blossom {

/// Whether this program was built with -fsanitize=address or thread. Their shadow memory takes terabytes of address space.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool hasShadowMemory = true;
#elif defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
constexpr bool hasShadowMemory = true;
#else
constexpr bool hasShadowMemory = false;
#endif
#else
constexpr bool hasShadowMemory = false;
#endif

}  // namespace blossom
