// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Compiles a function for several generations of the x86-64 processor; the program takes the one it runs on. So a
/// package built for any of them uses the wide registers where they are there.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && !defined(__AVX2__) && \
    !defined(__SANITIZE_ADDRESS__)
#define INTERPHASE_CLONES __attribute__((target_clones("arch=x86-64-v4", "arch=x86-64-v3", "default")))
#else
#define INTERPHASE_CLONES
#endif

/// A function for processors with registers of 512 bits only, to be called where has_widest().
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__)
#define INTERPHASE_WIDEST __attribute__((target("arch=x86-64-v4")))
#else
#define INTERPHASE_WIDEST
#endif

/// All that such a function calls becomes part of it, where its text is there.
#define INTERPHASE_FLATTEN __attribute__((flatten))

/// Without it the clones would call one function compiled for the oldest processor.
#define INTERPHASE_INLINE inline __attribute__((always_inline))

#if defined(__SSE2__)
#include <xmmintrin.h>
#endif

namespace interphase::hard_sphere {

inline bool has_widest()
{
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__)
    static const bool found = __builtin_cpu_supports("x86-64-v4");
    return found;
#else
    return false;
#endif
}

/// While one of these lives, numbers too small for full precision (below 1e-38 in single) count as zero. Processors
/// are many times slower with them, and spheres at rest are full of them.
class TinyIsZero {
public:
#if defined(__SSE2__)
    TinyIsZero() : before_(_mm_getcsr()) { _mm_setcsr(before_ | 0x8040); }
    ~TinyIsZero() { _mm_setcsr(before_); }

private:
    unsigned before_;
#else
    TinyIsZero() {}
    ~TinyIsZero() {}
#endif
};

}  // namespace interphase::hard_sphere
