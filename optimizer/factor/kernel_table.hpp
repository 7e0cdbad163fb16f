// SPDX-License-Identifier: Apache-2.0
#pragma once

// Included by files that are compiled for one processor only: no inline function of any library may
// come in here, or the linker could hand its AVX-512 copy to everyone.

namespace legwright {

/// Neighbouring rows of a source panel that go to neighbouring rows of a target panel.
struct RowSegment {
  int source;  // first row, counted from the first row of the update
  int target;  // first row of the target panel; −1: no neighbours there, look each row up
  int length;
};

/// Entries of a sparse matrix in neighbouring rows of one column.
struct ColumnRun {
  int row, length;
  long value;  // the first one's place among the values of the matrix
};

/// Dense arithmetic on panels. A panel holds the columns of one supernode: column-major, `rows`
/// rows of which the first `columns` are the triangle L₁₁, the others L₂₁. What lies above the
/// diagonal is undefined. Vectors of 8 are read whole, so memory must go on for 8 numbers after
/// each panel and each x; nothing is written there.
struct CholeskyKernels {
  int lanes;  // numbers per vector; `many` right-hand sides come in whole vectors

  /// target −= A Bᵀ, A all rows of the segments, B the first `columns` rows of `source`, both of
  /// `depth` columns. Column c goes to column place[c] of the target, rows as segments or place
  /// say.
  void (*subtract_update)(const double* source, int source_stride, int depth, int columns,
                          const RowSegment* segments, int segment_count, const int* place,
                          double* target, int target_stride);

  /// Cholesky factor of a panel, in place. Stops at the first pivot that is not above its least one
  /// and returns its column; −1 where there is none.
  int (*factor_panel)(double* panel, int stride, int rows, int columns, const double* least_pivot,
                      double* inverse_diagonal);

  /// x₁ ← L₁₁⁻¹ x₁, x₂ ← x₂ − L₂₁ x₁; x = (x₁, x₂) of size rows.
  void (*forward)(const double* panel, int stride, int rows, int columns,
                  const double* inverse_diagonal, double* x);
  /// x₁ ← L₁₁⁻ᵀ (x₁ − L₂₁ᵀ x₂).
  void (*backward)(const double* panel, int stride, int rows, int columns,
                   const double* inverse_diagonal, double* x);

  /// The same for 1, 2 or 3 vectors of right-hand sides. Those of unknown i stand side by side from
  /// x + i·x_stride on; panel row r is unknown row_index[r].
  void (*forward_many)(const double* panel, int stride, int rows, int columns,
                       const double* inverse_diagonal, const int* row_index, double* x,
                       int x_stride, int vectors);
  /// @param below scratch of (rows − columns)·x_stride.
  void (*backward_many)(const double* panel, int stride, int rows, int columns,
                        const double* inverse_diagonal, const int* row_index, double* x,
                        int x_stride, int vectors, double* below);

  /// residual −= A x and magnitude += |A| |x| for the symmetric matrix A whose strictly lower
  /// triangle has, in column j, runs[run_start[j]] … below runs[run_start[j + 1]].
  void (*subtract_symmetric)(int size, const int* run_start, const ColumnRun* runs,
                             const double* values, const double* x, double* residual,
                             double* magnitude);

  /// Copies and returns whether all are finite.
  bool (*copy_finite)(const double* from, long count, double* to);
};

extern const CholeskyKernels baseline_kernels, avx2_kernels, avx512_kernels;

}  // namespace legwright
