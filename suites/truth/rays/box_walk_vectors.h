// Vectors as walks compute with them: compiled anew for every set of instructions, so all of it is
// local to the file that includes it.
#pragma once

#if defined(__SSE2__)
#include <immintrin.h>
#endif

#include "suites/truth/rays/box_walk.h"

// Vectors are returned by what is compiled into its caller alone: no ABI matters.
#pragma GCC diagnostic ignored "-Wpsabi"

namespace sb {
namespace {

using Floats = float __attribute__((vector_size(4 * kBoxes)));
using Ints = int __attribute__((vector_size(4 * kBoxes)));
constexpr uint32_t kLanes = 4;  ///< doubles side by side
using FourFloats = float __attribute__((vector_size(4 * kLanes)));
using FourInts = int __attribute__((vector_size(4 * kLanes)));
using Doubles = double __attribute__((vector_size(8 * kLanes)));
using Longs = decltype(Doubles{} < Doubles{});
static_assert(kPacket == kBoxes && kLeafTriangles == kLanes && kPacket == 2 * kLanes);

/// One bit per place.
[[gnu::always_inline]] inline uint32_t bits(const Ints& mask) {
#if defined(__AVX__)
  return uint32_t(_mm256_movemask_ps(__m256(mask)));
#elif defined(__SSE2__)
  const auto* half = reinterpret_cast<const __m128*>(&mask);
  return uint32_t(_mm_movemask_ps(half[0]) | _mm_movemask_ps(half[1]) << 4);
#else
  uint32_t bits = 0;
  for (uint32_t i = 0; i < kBoxes; ++i) bits |= uint32_t(mask[i] & 1) << i;
  return bits;
#endif
}
[[gnu::always_inline]] inline uint32_t bits(const FourInts& mask) {
#if defined(__SSE2__)
  return uint32_t(_mm_movemask_ps(__m128(mask)));
#else
  uint32_t bits = 0;
  for (uint32_t i = 0; i < kLanes; ++i) bits |= uint32_t(mask[i] & 1) << i;
  return bits;
#endif
}
[[gnu::always_inline]] inline uint32_t bits(const Longs& mask) {
#if defined(__AVX__)
  return uint32_t(_mm256_movemask_pd(__m256d(mask)));
#elif defined(__SSE2__)
  const auto* half = reinterpret_cast<const __m128d*>(&mask);
  return uint32_t(_mm_movemask_pd(half[0]) | _mm_movemask_pd(half[1]) << 2);
#else
  uint32_t bits = 0;
  for (uint32_t i = 0; i < kLanes; ++i) bits |= uint32_t(mask[i] & 1) << i;
  return bits;
#endif
}
/// The places whose bits are set.
[[gnu::always_inline]] inline Longs lanes(uint32_t bits) {
  const Longs each{1, 2, 4, 8};
  return (each & (Longs{} + bits)) != 0;
}

// Of vectors and of single numbers.
template <class V>
[[gnu::always_inline]] inline V larger(const V& a, const V& b) {
  return a > b ? a : b;
}
template <class V>
[[gnu::always_inline]] inline V smaller(const V& a, const V& b) {
  return a < b ? a : b;
}
template <class V>
[[gnu::always_inline]] inline V absolute(const V& a) {
  return a < 0 ? -a : a;
}
[[gnu::always_inline]] inline FourFloats toFloats(const Doubles& v) {
  return __builtin_convertvector(v, FourFloats);
}

/// Least and greatest of a packet's rays.
struct Interval {
  float low, high;
  [[gnu::always_inline]] explicit Interval(const Floats& v) {
    const Ints halves{4, 5, 6, 7, 0, 1, 2, 3}, pairs{2, 3, 0, 1, 6, 7, 4, 5},
        singles{1, 0, 3, 2, 5, 4, 7, 6};
    Floats a = smaller(v, __builtin_shuffle(v, halves)),
           b = larger(v, __builtin_shuffle(v, halves));
    a = smaller(a, __builtin_shuffle(a, pairs)), b = larger(b, __builtin_shuffle(b, pairs));
    low = smaller(a, __builtin_shuffle(a, singles))[0];
    high = larger(b, __builtin_shuffle(b, singles))[0];
  }
};
}  // namespace
}  // namespace sb
