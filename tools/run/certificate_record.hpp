// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "tools/run/record.hpp"

namespace legwright {

/// A constraint where it is broken most.
struct ViolationRecord {
  std::string term, equation, where;
  int knot = 0;
  double time = 0.0;    // [s]
  double amount = 0.0;  // in `unit`; of an inequality that is met below zero
  std::string unit;
  double relative = 0.0;  // to the constraint's own scale
};
void fields(Fields& f, ViolationRecord& violation);

/// dF/ds of one parameter, by the adjoint and by central differences.
struct GradientRecord {
  double adjoint = 0.0, difference = 0.0, error = 0.0;
};
void fields(Fields& f, GradientRecord& gradient);

/// What is proven of the motion of a task.
struct TaskCertificateRecord {
  double stationarity = 0.0;
  std::string motion_status;
  bool motion_hessian_positive = false;
  double adjoint_residual = 0.0;
  bool motions_resolved = false;  // those that the differences were taken from
  ByName<GradientRecord> design_gradient;
  std::vector<ViolationRecord> violations;
};
void fields(Fields& f, TaskCertificateRecord& task);

struct ActiveBoundRecord {
  std::string parameter, bound;  // "lower" or "upper"
  double gradient = 0.0;
};
void fields(Fields& f, ActiveBoundRecord& bound);

/// result/certificate.json: what is proven of a result, for each task and for the design.
struct CertificateRecord {
  static constexpr RecordKind kKind{"legwright/certificate", 1, "optimize"};
  double projected_gradient_norm = 0.0, worst_gradient_error = 0.0;
  std::vector<double> design_curvatures;  // in the free directions
  std::vector<ActiveBoundRecord> active_bounds;
  ByName<TaskCertificateRecord> tasks;
  std::optional<std::string> of;  // where result/ holds another gait by now
};
void fields(Fields& f, CertificateRecord& certificate);

}  // namespace legwright
