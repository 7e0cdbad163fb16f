// SPDX-License-Identifier: Apache-2.0
// C −= A Bᵀ by tiles that stay in registers: what kernel_bodies.hpp is made of. Included by it
// alone.

namespace legwright {
namespace {

#define LEGWRIGHT_INLINE [[gnu::always_inline]] inline

constexpr int kMaxVectors = 3;  // of a tile: 3 × kPanelWidth sums fill the registers

/// sum −= A Bᵀ over `depth` columns; A is Rows vectors high, B has Columns rows. B is stored as it
/// is, or transposed.
template <int Rows, int Columns, bool Transposed>
LEGWRIGHT_INLINE void subtract_product(Vector (&sum)[Rows][Columns], int depth, const double* a,
                                       long a_stride, const double* b, long b_stride) {
  for (int l = 0; l < depth; ++l) {
    Vector left[Rows];
#pragma GCC unroll 3
    for (long r = 0; r < Rows; ++r) left[r] = load(a + r * kLanes);
#pragma GCC unroll 8
    for (int c = 0; c < Columns; ++c) {
      const Vector right = spread(Transposed ? b[c * b_stride] : b[c]);
#pragma GCC unroll 3
      for (int r = 0; r < Rows; ++r) sum[r][c] = minus_product(left[r], right, sum[r][c]);
    }
    a += a_stride;
    b += Transposed ? 1 : b_stride;
  }
}

/// The same for a tile whose columns lie anywhere; of its last vector `last` numbers are written.
template <int Rows, int Columns, bool Transposed>
LEGWRIGHT_INLINE void subtract_tile(double* const* column, long row, int last, int depth,
                                    const double* a, long a_stride, const double* b,
                                    long b_stride) {
  Vector sum[Rows][Columns];
#pragma GCC unroll 8
  for (int c = 0; c < Columns; ++c)
#pragma GCC unroll 3
    for (long r = 0; r < Rows; ++r) sum[r][c] = load(column[c] + row + r * kLanes);
  subtract_product<Rows, Columns, Transposed>(sum, depth, a, a_stride, b, b_stride);
#pragma GCC unroll 8
  for (int c = 0; c < Columns; ++c) {
#pragma GCC unroll 3
    for (long r = 0; r + 1 < Rows; ++r) store(column[c] + row + r * kLanes, sum[r][c]);
    double* const end = column[c] + row + (Rows - 1L) * kLanes;
    if (last == kLanes)
      store(end, sum[Rows - 1][c]);
    else
      store_first(end, sum[Rows - 1][c], last);
  }
}

/// Any number of neighbouring rows.
template <int Columns, bool Transposed = false>
void subtract_rows(double* const* column, long row, int rows, int depth, const double* a,
                   long a_stride, const double* b, long b_stride) {
  constexpr int step = kMaxVectors * kLanes;
  for (; rows > step; rows -= step, row += step, a += step)
    subtract_tile<3, Columns, Transposed>(column, row, kLanes, depth, a, a_stride, b, b_stride);
  if (rows > 2 * kLanes)
    subtract_tile<3, Columns, Transposed>(column, row, rows - 2 * kLanes, depth, a, a_stride, b,
                                          b_stride);
  else if (rows > kLanes)
    subtract_tile<2, Columns, Transposed>(column, row, rows - kLanes, depth, a, a_stride, b,
                                          b_stride);
  else if (rows > 0)
    subtract_tile<1, Columns, Transposed>(column, row, rows, depth, a, a_stride, b, b_stride);
}

/// Rows that go to scattered places: one vector at a time through memory.
template <int Columns>
void subtract_scattered(double* const* column, const int* place, int rows, int depth,
                        const double* a, long a_stride, const double* b, long b_stride) {
  for (int done = 0; done < rows; done += kLanes) {
    Vector sum[1][Columns];
#pragma GCC unroll 8
    for (int c = 0; c < Columns; ++c) sum[0][c] = spread(0.0);
    subtract_product<1, Columns, false>(sum, depth, a + done, a_stride, b, b_stride);
    const int count = rows - done < kLanes ? rows - done : kLanes;
    for (int c = 0; c < Columns; ++c) {
      double part[kLanes];
      store(part, sum[0][c]);
      for (int i = 0; i < count; ++i) column[c][place[done + i]] += part[i];
    }
  }
}

template <int Columns>
void subtract_columns(const double* source, long source_stride, int depth, int c,
                      const RowSegment* segments, int segment_count, const int* place,
                      double* target, long target_stride) {
  double* column[Columns];
  for (int k = 0; k < Columns; ++k) column[k] = target + place[c + k] * target_stride;
  for (int s = 0; s < segment_count; ++s) {
    const RowSegment& segment = segments[s];
    const int begin = segment.source < c ? c : segment.source;  // above: the other triangle
    const int rows = segment.source + segment.length - begin;
    if (rows <= 0) continue;
    if (segment.target >= 0)
      subtract_rows<Columns>(column, segment.target + (begin - segment.source), rows, depth,
                             source + begin, source_stride, source + c, source_stride);
    else
      subtract_scattered<Columns>(column, place + begin, rows, depth, source + begin, source_stride,
                                  source + c, source_stride);
  }
}

/// Calls body.template operator()<1 … kPanelWidth>.
template <class Body>
LEGWRIGHT_INLINE void with_width(int columns, const Body& body) {
  if constexpr (kPanelWidth > 4) {
    switch (columns) {
      case 8:
        return body.template operator()<8>();
      case 7:
        return body.template operator()<7>();
      case 6:
        return body.template operator()<6>();
      case 5:
        return body.template operator()<5>();
      default:
        break;
    }
  }
  switch (columns) {
    case 4:
      return body.template operator()<4>();
    case 3:
      return body.template operator()<3>();
    case 2:
      return body.template operator()<2>();
    default:
      return body.template operator()<1>();
  }
}

LEGWRIGHT_INLINE int width_at(int j, int columns) {
  return columns - j < kPanelWidth ? columns - j : kPanelWidth;
}

}  // namespace
}  // namespace legwright
