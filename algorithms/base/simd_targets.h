// The instruction sets that SIMD kernels are compiled for; to be included before <hwy/foreach_target.h>. On x86: the
// plain one, SSE4, AVX2, AVX-512. Each costs every kernel's compile time once more.
//
// Left out: SSSE3 alone, which no processor after 2008 stops at (there the plain form runs, at a fifth of the rate),
// and instruction sets without a fixed width, because kernels keep vectors in structures and arrays.
#pragma once

#undef HWY_DISABLED_TARGETS
#ifdef __SANITIZE_THREAD__
// Threads meet in the same places whatever the instruction set, and instrumented kernels compile slowly: two suffice.
#define RELIEF_UNSANITIZED_TARGETS (HWY_SSE4 | HWY_AVX3 | HWY_AVX3_DL)
#else
#define RELIEF_UNSANITIZED_TARGETS 0
#endif
#define HWY_DISABLED_TARGETS \
    (HWY_SSSE3 | HWY_SVE | HWY_SVE2 | HWY_SVE_256 | HWY_SVE2_128 | HWY_RVV | RELIEF_UNSANITIZED_TARGETS)
