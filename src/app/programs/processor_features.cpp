// SPDX-License-Identifier: Apache-2.0
#include "app/programs/processor_features.hpp"

namespace nugget::app {

namespace {
// SSE and AVX; also the masks and registers of AVX-512. Which are used depends on -march.
[[maybe_unused]] constexpr unsigned with_wide = 0x6, with_wider = 0xe6;
}  // namespace

// Bits: Intel 64 and IA-32 Architectures Software Developer's Manual, volume 2A, CPUID; AMD64 Architecture Programmer's
// Manual, volume 3, for LZCNT.
extern const ProcessorFeature needed_features[] = {
#ifdef __SSE4_2__
    {"SSE4.2", 1, 2, 20, 0},
#endif
#ifdef __AVX__
    {"AVX", 1, 2, 28, with_wide},
#endif
#ifdef __AVX2__
    {"AVX2", 7, 1, 5, with_wide},
#endif
#ifdef __F16C__
    {"F16C", 1, 2, 29, with_wide},
#endif
#ifdef __BMI__
    {"BMI1", 7, 1, 3, 0},
#endif
#ifdef __BMI2__
    {"BMI2", 7, 1, 8, 0},
#endif
#ifdef __LZCNT__
    {"LZCNT", 0x80000001u, 2, 5, 0},
#endif
#ifdef __MOVBE__
    {"MOVBE", 1, 2, 22, 0},
#endif
#ifdef __AVX512F__
    {"AVX512F", 7, 1, 16, with_wider},
#endif
#ifdef __AVX512DQ__
    {"AVX512DQ", 7, 1, 17, with_wider},
#endif
#ifdef __AVX512CD__
    {"AVX512CD", 7, 1, 28, with_wider},
#endif
#ifdef __AVX512BW__
    {"AVX512BW", 7, 1, 30, with_wider},
#endif
#ifdef __AVX512VL__
    {"AVX512VL", 7, 1, 31, with_wider},
#endif
    {nullptr, 0, 0, 0, 0}};

}  // namespace nugget::app
