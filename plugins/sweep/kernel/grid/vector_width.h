#pragma once

// One source, compiled for several vector widths; the loader picks. Sanitizers do not get along with such symbols.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && !defined(__SANITIZE_ADDRESS__) && \
    !defined(__SANITIZE_THREAD__)
#define BLOSSOM_FOR_EACH_VECTOR_WIDTH __attribute__((target_clones("avx512f", "fma", "default")))
#else
#define BLOSSOM_FOR_EACH_VECTOR_WIDTH
#endif
// What such a function calls has to become part of it: a call would run for the narrowest width only, and would itself cost
// as much as dozens of operations where the width changes.
#define BLOSSOM_INLINE inline __attribute__((always_inline))

// The steps of the loop below do not depend on each other through memory.
#if defined(__GNUC__) && !defined(__clang__)
#define BLOSSOM_INDEPENDENT_STEPS _Pragma("GCC ivdep")
#else
#define BLOSSOM_INDEPENDENT_STEPS
#endif
