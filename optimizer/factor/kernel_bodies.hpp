// SPDX-License-Identifier: Apache-2.0
// The kernels, in terms of `Vector` and a dozen operations on it that the including file defines.
// Everything has internal linkage: see kernel_table.hpp.
#include "optimizer/factor/kernel_tiles.hpp"

namespace legwright {
namespace {

void subtract_update(const double* source, int source_stride, int depth, int columns,
                     const RowSegment* segments, int segment_count, const int* place,
                     double* target, int target_stride) {
  for (int c = 0; c < columns; c += kPanelWidth)
    with_width(width_at(c, columns), [&]<int Columns>() {
      subtract_columns<Columns>(source, source_stride, depth, c, segments, segment_count, place,
                                target, target_stride);
    });
}

/// Cholesky of the head of a strip of `Columns` columns; further rows in the same vectors are
/// solved along. Returns the column of a bad pivot or −1.
template <int Columns>
int factor_head(double* strip, long stride, int rows, const double* least_pivot, double* inverse) {
  constexpr int vectors = (Columns + kLanes - 1) / kLanes;
  const int last = rows < vectors * kLanes ? rows - (vectors - 1) * kLanes : kLanes;
  Vector x[Columns][vectors];
#pragma GCC unroll 8
  for (int c = 0; c < Columns; ++c)
#pragma GCC unroll 2
    for (long v = 0; v < vectors; ++v) x[c][v] = load(strip + c * stride + v * kLanes);
#pragma GCC unroll 8
  for (int c = 0; c < Columns; ++c) {
    double head[vectors * kLanes];
#pragma GCC unroll 2
    for (int v = 0; v < vectors; ++v) store(head + v * kLanes, x[c][v]);
    const double pivot = head[c];
    if (!(pivot > least_pivot[c]) || !(pivot < __builtin_inf())) return c;
    inverse[c] = 1.0 / __builtin_sqrt(pivot);
#pragma GCC unroll 2
    for (long v = 0; v < vectors; ++v) {
      x[c][v] = times(x[c][v], spread(inverse[c]));
      store(head + v * kLanes, x[c][v]);
      double* const to = strip + c * stride + v * kLanes;
      if (v + 1 < vectors || last == kLanes)
        store(to, x[c][v]);
      else
        store_first(to, x[c][v], last);
    }
#pragma GCC unroll 8
    for (int l = c + 1; l < Columns; ++l)
#pragma GCC unroll 2
      for (int v = 0; v < vectors; ++v) x[l][v] = minus_product(x[c][v], spread(head[l]), x[l][v]);
  }
  return -1;
}

/// The rows of a strip below its head: X ← X L₁₁⁻ᵀ.
template <int Columns>
void solve_strip(double* strip, long stride, int first, int rows, const double* inverse) {
  for (int i = first; i < rows; i += kLanes) {
    Vector x[Columns];
#pragma GCC unroll 8
    for (int c = 0; c < Columns; ++c) x[c] = load(strip + c * stride + i);
#pragma GCC unroll 8
    for (int c = 0; c < Columns; ++c) {
      x[c] = times(x[c], spread(inverse[c]));
#pragma GCC unroll 8
      for (int l = c + 1; l < Columns; ++l)
        x[l] = minus_product(x[c], spread(strip[c * stride + l]), x[l]);
    }
    const int count = rows - i;
#pragma GCC unroll 8
    for (int c = 0; c < Columns; ++c) {
      if (count >= kLanes)
        store(strip + c * stride + i, x[c]);
      else
        store_first(strip + c * stride + i, x[c], count);
    }
  }
}

int factor_panel(double* panel, int panel_stride, int rows, int columns, const double* least_pivot,
                 double* inverse_diagonal) {
  const long stride = panel_stride;
  int bad = -1;
  for (int j = 0; j < columns && bad < 0; j += kPanelWidth)
    with_width(width_at(j, columns), [&]<int Columns>() {
      constexpr int head = (Columns + kLanes - 1) / kLanes * kLanes;
      double* column[Columns];
      for (int c = 0; c < Columns; ++c) column[c] = panel + (j + c) * stride;
      if (j > 0)
        subtract_rows<Columns>(column, j, rows - j, j, panel + j, stride, panel + j, stride);
      double* const strip = panel + j * stride + j;
      const int found =
          factor_head<Columns>(strip, stride, rows - j, least_pivot + j, inverse_diagonal + j);
      if (found >= 0) bad = j + found;
      if (found < 0) solve_strip<Columns>(strip, stride, head, rows - j, inverse_diagonal + j);
    });
  return bad;
}

template <int Columns>
void forward_strip(const double* strip, long stride, int rows, const double* inverse, double* x) {
  double y[Columns];
  for (int c = 0; c < Columns; ++c) {
    y[c] = x[c] *= inverse[c];
    for (int l = c + 1; l < Columns; ++l) x[l] -= strip[c * stride + l] * y[c];
  }
  for (int i = Columns; i < rows; i += kLanes) {
    Vector sum = load(x + i);
#pragma GCC unroll 8
    for (int c = 0; c < Columns; ++c)
      sum = minus_product(load(strip + c * stride + i), spread(y[c]), sum);
    const int count = rows - i;
    if (count >= kLanes)
      store(x + i, sum);
    else
      store_first(x + i, sum, count);
  }
}

void forward(const double* panel, int stride, int rows, int columns, const double* inverse_diagonal,
             double* x) {
  for (int j = 0; j < columns; j += kPanelWidth)
    with_width(width_at(j, columns), [&]<int Columns>() {
      forward_strip<Columns>(panel + j * static_cast<long>(stride) + j, stride, rows - j,
                             inverse_diagonal + j, x + j);
    });
}

LEGWRIGHT_INLINE double total(Vector v) {
  double part[kLanes];
  store(part, v);
  double sum = 0.0;
  for (int i = 0; i < kLanes; ++i) sum += part[i];
  return sum;
}

template <int Columns>
void backward_strip(const double* strip, long stride, int rows, const double* inverse, double* x) {
  Vector sum[Columns];
#pragma GCC unroll 8
  for (int c = 0; c < Columns; ++c) sum[c] = spread(0.0);
  int i = Columns;
  for (; i + kLanes <= rows; i += kLanes) {
    const Vector below = load(x + i);
#pragma GCC unroll 8
    for (int c = 0; c < Columns; ++c)
      sum[c] = plus_product(load(strip + c * stride + i), below, sum[c]);
  }
  if (i < rows) {
    const Vector below = load_first(x + i, rows - i);
#pragma GCC unroll 8
    for (int c = 0; c < Columns; ++c)
      sum[c] = plus_product(load_first(strip + c * stride + i, rows - i), below, sum[c]);
  }
  for (int c = 0; c < Columns; ++c) x[c] -= total(sum[c]);
  for (int c = Columns - 1; c >= 0; --c) {
    double value = x[c];
    for (int l = c + 1; l < Columns; ++l) value -= strip[c * stride + l] * x[l];
    x[c] = value * inverse[c];
  }
}

LEGWRIGHT_INLINE int last_strip(int columns) { return (columns - 1) / kPanelWidth * kPanelWidth; }

void backward(const double* panel, int stride, int rows, int columns,
              const double* inverse_diagonal, double* x) {
  for (int j = last_strip(columns); j >= 0; j -= kPanelWidth)
    with_width(width_at(j, columns), [&]<int Columns>() {
      backward_strip<Columns>(panel + j * static_cast<long>(stride) + j, stride, rows - j,
                              inverse_diagonal + j, x + j);
    });
}

void forward_many(const double* panel, int panel_stride, int rows, int columns,
                  const double* inverse_diagonal, const int* row_index, double* x, int x_stride,
                  int vectors) {
  const long stride = panel_stride, width = x_stride;
  double* const own = x + row_index[0] * width;
  const int count = vectors * kLanes;
  for (int j = 0; j < columns; j += kPanelWidth)
    with_width(width_at(j, columns), [&]<int Columns>() {
      double* column[Columns];
      for (int c = 0; c < Columns; ++c) column[c] = own + (j + c) * width;
      if (j > 0) subtract_rows<Columns>(column, 0, count, j, own, width, panel + j, stride);
      const double* const strip = panel + j * stride + j;
      for (int v = 0; v < count; v += kLanes)
        for (int c = 0; c < Columns; ++c) {
          const Vector y = times(load(column[c] + v), spread(inverse_diagonal[j + c]));
          store(column[c] + v, y);
          for (int l = c + 1; l < Columns; ++l)
            store(column[l] + v,
                  minus_product(y, spread(strip[c * stride + l]), load(column[l] + v)));
        }
    });
  for (int r = columns; r < rows; r += kPanelWidth)
    with_width(width_at(r, rows), [&]<int Columns>() {
      double* column[Columns];
      for (int c = 0; c < Columns; ++c) column[c] = x + row_index[r + c] * width;
      subtract_rows<Columns>(column, 0, count, columns, own, width, panel + r, stride);
    });
}

void backward_many(const double* panel, int panel_stride, int rows, int columns,
                   const double* inverse_diagonal, const int* row_index, double* x, int x_stride,
                   int vectors, double* below) {
  const long stride = panel_stride, width = x_stride;
  double* const own = x + row_index[0] * width;
  const int count = vectors * kLanes;
  for (int r = columns; r < rows; ++r)
    for (int v = 0; v < count; v += kLanes)
      store(below + (r - columns) * width + v, load(x + row_index[r] * width + v));
  for (int j = last_strip(columns); j >= 0; j -= kPanelWidth)
    with_width(width_at(j, columns), [&]<int Columns>() {
      double* column[Columns];
      for (int c = 0; c < Columns; ++c) column[c] = own + (j + c) * width;
      const double* const from = panel + j * stride;
      const int after = j + Columns;
      subtract_rows<Columns, true>(column, 0, count, columns - after, own + after * width, width,
                                   from + after, stride);
      subtract_rows<Columns, true>(column, 0, count, rows - columns, below, width, from + columns,
                                   stride);
      for (int v = 0; v < count; v += kLanes)
        for (int c = Columns - 1; c >= 0; --c) {
          Vector y = load(column[c] + v);
          for (int l = c + 1; l < Columns; ++l)
            y = minus_product(load(column[l] + v), spread(from[c * stride + j + l]), y);
          store(column[c] + v, times(y, spread(inverse_diagonal[j + c])));
        }
    });
}

void subtract_symmetric(int size, const int* run_start, const ColumnRun* runs, const double* values,
                        const double* x, double* residual, double* magnitude) {
  for (int j = 0; j < size; ++j) {
    const Vector factor = spread(x[j]), weight = absolute(factor);
    Vector sum = spread(0.0), absolute_sum = spread(0.0);
    for (int k = run_start[j]; k < run_start[j + 1]; ++k) {
      const double* a = values + runs[k].value;
      for (int i = runs[k].row, left = runs[k].length; left > 0;
           i += kLanes, left -= kLanes, a += kLanes) {
        const bool whole = left >= kLanes;
        const Vector entry = whole ? load(a) : load_first(a, left);
        const Vector positive = absolute(entry), other = load(x + i);
        const Vector rest = minus_product(entry, factor, load(residual + i));
        const Vector mass = plus_product(positive, weight, load(magnitude + i));
        store(residual + i, rest);  // beyond the run an entry is 0
        store(magnitude + i, mass);
        sum = plus_product(entry, other, sum);
        absolute_sum = plus_product(positive, absolute(other), absolute_sum);
      }
    }
    residual[j] -= total(sum);
    magnitude[j] += total(absolute_sum);
  }
}

bool copy_finite(const double* from, long count, double* to) {
  // 0·x is 0 for a finite x and NaN for any other.
  Vector sum = spread(0.0);
  long i = 0;
  for (; i + kLanes <= count; i += kLanes) {
    const Vector x = load(from + i);
    store(to + i, x);
    sum = plus_product(x, spread(0.0), sum);
  }
  double rest = 0.0;
  for (; i < count; ++i) {
    to[i] = from[i];
    rest += from[i] * 0.0;
  }
  return total(sum) + rest == 0.0;
}

}  // namespace

const CholeskyKernels LEGWRIGHT_KERNELS = {kLanes,        subtract_update,    factor_panel,
                                           forward,       backward,           forward_many,
                                           backward_many, subtract_symmetric, copy_finite};

}  // namespace legwright
