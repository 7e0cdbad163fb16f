// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <functional>

#include "tools/run/comparison_record.hpp"

namespace legwright {

/// Many quantities of a roll-out by phase. Within a bin of a cycle the samples are averaged, so
/// that what a stiff contact does from step to step adds up to its impulse; only then cycles are
/// compared.
class PhaseCurves {
 public:
  PhaseCurves(int quantities, int bins);

  int bins() const { return static_cast<int>(sums_.cols()); }
  /// @param values one per quantity
  void add(int bin, const Eigen::VectorXd& values);
  /// Ends a cycle. @param derive may change its means, quantities × bins, before they are taken in
  /// @param keep false: the cycle is forgotten
  void end_cycle(bool keep, const std::function<void(Eigen::MatrixXd&)>& derive = {});
  /// Forgets the cycles so far.
  void restart() { cycles_ = 0; }
  int cycles() const { return cycles_; }  // taken in
  /// Of the cycles taken in, of which there must be one at least; nothing planned.
  Curve curve(int quantity) const;

 private:
  Eigen::MatrixXd sums_, totals_, lows_, highs_;
  Eigen::VectorXi counts_;
  int cycles_ = 0;
};

}  // namespace legwright
