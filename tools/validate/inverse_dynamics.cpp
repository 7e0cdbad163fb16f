// SPDX-License-Identifier: Apache-2.0
#include "tools/validate/inverse_dynamics.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "tools/simulate/plan_dynamics.hpp"
#include "tools/validate/floor_friction.hpp"
#include "tools/validate/foot_touch.hpp"

namespace legwright {
namespace {

struct Residual {
  double force, torque;
};

std::vector<FootOnBody> feet_of(const Scene& scene) {
  std::vector<FootOnBody> feet;
  for (const int geom : scene.foot_geom)
    feet.push_back({scene.model->geom_bodyid[geom], foot_radius(*scene.model, geom)});
  return feet;
}

void look_at_forces(const Scene& scene, double weight, InverseDynamics& out) {
  const Trajectory& plan = scene.trajectory;
  out.normal_min = std::numeric_limits<double>::infinity();
  for (int knot = 0; knot < plan.knot_count; ++knot) {
    const double phase = static_cast<double>(knot) / plan.knot_count;
    for (int foot = 0; foot < plan.foot_count(); ++foot) {
      if (plan.at(knot, plan.contact_column(foot)) < 0.5) continue;
      const auto& name = plan.foot_names[static_cast<std::size_t>(foot)];
      const auto force = [&](int axis) { return plan.at(knot, plan.force_column(foot, axis)); };
      const double normal = force(2), tangential = std::hypot(force(0), force(1));
      if (normal < out.normal_min) {
        out.normal_min = normal;
        out.normal_foot = name;
        out.normal_phase = phase;
      }
      // A foot that pulls at the ground or only drags has no friction to use.
      const double used = normal > 0       ? tangential / normal
                          : tangential > 0 ? std::numeric_limits<double>::infinity()
                                           : 0.0;
      if (used > out.friction_max) {
        out.friction_max = used;
        out.friction_foot = name;
        out.friction_phase = phase;
      }
    }
  }
  out.normal_min_share = out.normal_min / weight;
  out.friction_coefficient = floor_friction(scene);
}

// How far the feet roll and slip while they stand, as the plan has it.
void look_at_feet(const Scene& scene, PlanDynamics& dynamics, PlanAgainstDynamics& out) {
  constexpr int kPartsOfKnot = 4;
  const Trajectory& plan = scene.trajectory;
  const int parts = kPartsOfKnot * plan.knot_count;
  const double step = plan.period / parts;
  const auto feet = static_cast<std::size_t>(plan.foot_count());
  std::vector<Eigen::Vector2d> roll(feet, Eigen::Vector2d::Zero());
  std::vector<int> landings(feet, 0);
  out.foot_slip.assign(feet, 0.0);
  for (int part = 0; part < parts; ++part) {
    dynamics.unexplained((part + 0.5) * step);
    const int knot = part / kPartsOfKnot, next = (knot + 1) % plan.knot_count;
    for (std::size_t j = 0; j < feet; ++j) {
      const int column = plan.contact_column(static_cast<int>(j));
      const bool stands = plan.at(knot, column) > 0.5, will_stand = plan.at(next, column) > 0.5;
      if (!stands && will_stand && part % kPartsOfKnot == 0) ++landings[j];
      if (!stands || !will_stand) continue;
      const FootMotion motion = foot_motion(dynamics.model(), dynamics.data(), scene.foot_geom[j]);
      roll[j] += motion.roll_rate * step;
      out.foot_slip[j] += motion.bottom_velocity.head<2>().norm() * step;
    }
  }
  for (std::size_t j = 0; j < feet; ++j) {
    out.foot_roll.push_back(roll[j].norm() / std::max(1, landings[j]));
    out.foot_slip[j] /= std::max(1, landings[j]);
  }
}

}  // namespace

PlanAgainstDynamics inverse_dynamics(const Scene& scene, int bins) {
  const Trajectory& plan = scene.trajectory;
  PlanDynamics dynamics(*scene.model, plan, feet_of(scene));
  const int root = dynamics.joints().root_dof, height = dynamics.joints().root_qpos + 2;
  const double weight = dynamics.weight();
  PlanAgainstDynamics out;
  const auto look = [&](double phase) {
    const Eigen::VectorXd& left = dynamics.unexplained(phase * plan.period);
    const Residual residual{
        left.segment<3>(root).norm() / weight,
        left.segment<3>(root + 3).norm() / (weight * std::abs(dynamics.data().qpos[height]))};
    if (residual.force > out.force_max) {
      out.force_max = residual.force;
      out.worst_phase = phase;
    }
    out.torque_max = std::max(out.torque_max, residual.torque);
    return residual;
  };
  for (int knot = 0; knot < plan.knot_count; ++knot)
    look(static_cast<double>(knot) / plan.knot_count);
  out.force.resize(bins);
  double torque_squared = 0.0;
  for (int bin = 0; bin < bins; ++bin) {
    const Residual residual = look((bin + 0.5) / bins);
    out.force[bin] = residual.force;
    torque_squared += residual.torque * residual.torque;
  }
  out.force_rms = std::sqrt(out.force.squaredNorm() / bins);
  out.torque_rms = std::sqrt(torque_squared / bins);
  look_at_forces(scene, weight, out);
  look_at_feet(scene, dynamics, out);
  return out;
}

std::string describe(const InverseDynamics& d) {
  return fmt::format(
      "plan in MuJoCo's equations: root residual {:.1f} % of the weight at most (phase {:.2f}), "
      "friction {:.2f} of {:.2f}, least normal force {:.1f} % of the weight ({})",
      100 * d.force_max, d.worst_phase, d.friction_max, d.friction_coefficient,
      100 * d.normal_min_share, d.normal_foot);
}

}  // namespace legwright
