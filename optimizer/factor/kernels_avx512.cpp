// SPDX-License-Identifier: Apache-2.0
#include <immintrin.h>

#include "optimizer/factor/kernel_table.hpp"

namespace legwright {
namespace {

using Vector = __m512d;
constexpr int kLanes = 8, kPanelWidth = 8;

inline Vector load(const double* p) { return _mm512_loadu_pd(p); }
inline void store(double* p, Vector v) { _mm512_storeu_pd(p, v); }
inline void store_first(double* p, Vector v, int count) {
  _mm512_mask_storeu_pd(p, static_cast<__mmask8>((1u << count) - 1u), v);
}
inline Vector load_first(const double* p, int count) {
  return _mm512_maskz_mov_pd(static_cast<__mmask8>((1u << count) - 1u), load(p));
}
inline Vector spread(double x) { return _mm512_set1_pd(x); }
inline Vector times(Vector a, Vector b) { return _mm512_mul_pd(a, b); }
inline Vector plus_product(Vector a, Vector b, Vector c) { return _mm512_fmadd_pd(a, b, c); }
inline Vector minus_product(Vector a, Vector b, Vector c) { return _mm512_fnmadd_pd(a, b, c); }
inline Vector absolute(Vector a) { return _mm512_abs_pd(a); }

}  // namespace
}  // namespace legwright

#define LEGWRIGHT_KERNELS avx512_kernels
#include "optimizer/factor/kernel_bodies.hpp"
