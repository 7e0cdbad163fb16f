// SPDX-License-Identifier: Apache-2.0
#include <immintrin.h>

#include "optimizer/factor/kernel_table.hpp"

namespace legwright {
namespace {

using Vector = __m256d;
constexpr int kLanes = 4, kPanelWidth = 4;

inline Vector load(const double* p) { return _mm256_loadu_pd(p); }
inline void store(double* p, Vector v) { _mm256_storeu_pd(p, v); }
inline void store_first(double* p, Vector v, int count) {  // masked stores are slow on some
  if (count >= 4) return _mm256_storeu_pd(p, v);
  if (count >= 2) _mm_storeu_pd(p, _mm256_castpd256_pd128(v));
  if (count == 1) _mm_store_sd(p, _mm256_castpd256_pd128(v));
  if (count == 3) _mm_store_sd(p + 2, _mm256_extractf128_pd(v, 1));
}
inline Vector load_first(const double* p, int count) {
  const __m256i lane = _mm256_set_epi64x(3, 2, 1, 0);
  return _mm256_maskload_pd(p, _mm256_cmpgt_epi64(_mm256_set1_epi64x(count), lane));
}
inline Vector spread(double x) { return _mm256_set1_pd(x); }
inline Vector times(Vector a, Vector b) { return _mm256_mul_pd(a, b); }
inline Vector plus_product(Vector a, Vector b, Vector c) { return _mm256_fmadd_pd(a, b, c); }
inline Vector minus_product(Vector a, Vector b, Vector c) { return _mm256_fnmadd_pd(a, b, c); }
inline Vector absolute(Vector a) { return _mm256_andnot_pd(_mm256_set1_pd(-0.0), a); }

}  // namespace
}  // namespace legwright

#define LEGWRIGHT_KERNELS avx2_kernels
#include "optimizer/factor/kernel_bodies.hpp"
