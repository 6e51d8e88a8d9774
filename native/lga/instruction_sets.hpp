// The instruction sets that the bit-sliced engine is compiled for: AVX-512 with AES on whole
// vectors, AVX2 with AES, or plain C++. To be included before Highway.
#pragma once

#define HWY_WANT_AVX3_DL
#define HWY_DISABLED_TARGETS (HWY_SSSE3 | HWY_SSE4 | HWY_AVX3)
