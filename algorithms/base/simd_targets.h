// The instruction sets that SIMD kernels are compiled for; to be included before <hwy/foreach_target.h>. On x86:
// baseline (SSE2), SSE4, AVX2, AVX-512. Each adds the compile time of every kernel once more.
//
// Excluded: SSSE3, because no processor since 2008 ends there (it would run the baseline version, at a fifth of the
// rate), and instruction sets without a fixed vector width, because kernels store vectors in structures and arrays.
#pragma once

#undef HWY_DISABLED_TARGETS
#ifdef __SANITIZE_THREAD__
// Sanitizer builds use two instruction sets: threads interact in the same places on all of them, and instrumented
// kernels compile slowly.
#define RELIEF_UNSANITIZED_TARGETS (HWY_SSE4 | HWY_AVX3 | HWY_AVX3_DL)
#else
#define RELIEF_UNSANITIZED_TARGETS 0
#endif
#define HWY_DISABLED_TARGETS \
    (HWY_SSSE3 | HWY_SVE | HWY_SVE2 | HWY_SVE_256 | HWY_SVE2_128 | HWY_RVV | RELIEF_UNSANITIZED_TARGETS)
