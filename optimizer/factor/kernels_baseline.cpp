// SPDX-License-Identifier: Apache-2.0
// Without intrinsics: pairs of numbers, which every 64-bit processor has.
#include "optimizer/factor/kernel_table.hpp"

namespace legwright {
namespace {

using Vector = double __attribute__((vector_size(16)));
constexpr int kLanes = 2, kPanelWidth = 4;

inline Vector load(const double* p) { return Vector{p[0], p[1]}; }
inline void store(double* p, Vector v) {
  p[0] = v[0];
  p[1] = v[1];
}
inline void store_first(double* p, Vector v, int count) {
  p[0] = v[0];
  if (count > 1) p[1] = v[1];
}
inline Vector load_first(const double* p, int count) { return Vector{p[0], count > 1 ? p[1] : 0}; }
inline Vector spread(double x) { return Vector{x, x}; }
inline Vector times(Vector a, Vector b) { return a * b; }
inline Vector plus_product(Vector a, Vector b, Vector c) { return c + a * b; }
inline Vector minus_product(Vector a, Vector b, Vector c) { return c - a * b; }
inline Vector absolute(Vector a) { return Vector{__builtin_fabs(a[0]), __builtin_fabs(a[1])}; }

}  // namespace
}  // namespace legwright

#define LEGWRIGHT_KERNELS baseline_kernels
#include "optimizer/factor/kernel_bodies.hpp"
