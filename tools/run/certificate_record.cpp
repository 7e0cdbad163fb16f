// SPDX-License-Identifier: Apache-2.0
#include "tools/run/certificate_record.hpp"

namespace legwright {

void fields(Fields& f, ViolationRecord& violation) {
  f("term", violation.term);
  f("equation", violation.equation);
  f("where", violation.where);
  f("knot", violation.knot);
  f("time_s", violation.time);
  f("amount", violation.amount, "below zero: an inequality, and this far from its wall");
  f("unit", violation.unit);
  f("relative", violation.relative, "to the constraint's own scale");
}

void fields(Fields& f, GradientRecord& gradient) {
  f("adjoint", gradient.adjoint);
  f("difference", gradient.difference);
  f("error", gradient.error);
}

void fields(Fields& f, TaskCertificateRecord& task) {
  f("stationarity", task.stationarity, "largest entry of dF/dm");
  f("motion_status", task.motion_status);
  f("motion_hessian_positive", task.motion_hessian_positive);
  f("adjoint_residual", task.adjoint_residual);
  f("motions_resolved", task.motions_resolved, "those that the differences were taken from");
  f("design_gradient", task.design_gradient);
  f("violations", task.violations, "each constraint at its worst, worst first");
}

void fields(Fields& f, ActiveBoundRecord& bound) {
  f("parameter", bound.parameter);
  f.one_of("bound", bound.bound, {"lower", "upper"});
  f("gradient", bound.gradient);
}

void fields(Fields& f, CertificateRecord& certificate) {
  f("projected_gradient_norm", certificate.projected_gradient_norm);
  f("worst_gradient_error", certificate.worst_gradient_error);
  f("design_curvatures", certificate.design_curvatures, "in the free directions");
  f("active_bounds", certificate.active_bounds);
  f("tasks", certificate.tasks);
  f("of", certificate.of, "of which gait, where result/ holds another by now");
}

}  // namespace legwright
