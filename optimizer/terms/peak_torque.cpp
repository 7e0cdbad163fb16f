// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <utility>

#include "optimizer/design/kinematics.hpp"
#include "optimizer/terms/factories.hpp"
#include "optimizer/terms/registry.hpp"

namespace legwright {
namespace {

/// Share of the step after its last loaded knot for which a foot is held, and before its first one
/// from which on; measured: 0.7 to 0.8.
constexpr double kHeld = 0.75;
/// kp of the stiffest servos that are judged, over that of the robot; of kd the square root.
constexpr double kStiffest = 2.0;

using Eigen::Vector3d;
using Eigen::VectorXd;

/// Not in the paper, for outer objectives (weight zero unless asked for): the largest torque that
/// any motor needs at any knot, servo tracking included, by the 16-norm, a smooth maximum that
/// needs no rounding. Residual (τ/(weight · length))^16, counted as it is: the peak is
/// value^(1/16) · weight · length [N m].
///
/// τ is the torque of inverse dynamics, and for each foot below the motor two more: as it lifts off
/// and as it touches down. The played B-spline moves the joint's target on while the ground still
/// holds the foot. With knot k the foot's last one with load, k + 1 planted and k + 2 free, target
/// and joint part from k on; at k + θ by θ³/6 Δ²q and at a rate of θ²/(2h) Δ²q with
/// Δ²q = q_{k+2} − 2 q_{k+1} + q_k. The servo answers by τ' = kp θ³/6 Δ²q + kd θ²/(2h) Δ²q, as far
/// as friction holds the foot, in proportion to its load f_k over the robot's weight:
/// τ = (1 − θ) τ_k + θ τ_{k+1} + τ' f_k/weight. A touchdown is the mirror image, but for the
/// distance: the target still has to go it when the foot sticks, so it is kd's part alone, and
/// resists. A foot that is planted for longer before and after its stance has no such torques.
class PeakTorque final : public Term {
 public:
  explicit PeakTorque(const TermContext& context)
      : weight_(context.weight), unit_(context.weight * context.length) {
    const Layout& layout = context.layout;
    const Gait& gait = context.task.gait;
    const Ancestry ancestry(context.morphology);
    for (int i = 0; i < layout.knot_count(); ++i)
      for (int a = 0; a < layout.joint_count(); ++a) {
        add(context, a, {i, -1, 1, {layout.joint_torque(i, a)}}, 0.0);
        if (layout.planted_margin() > 1) continue;
        const Joint& joint = context.morphology.links[a + 1].joint;
        const double place = kHeld * kHeld * kHeld / 6.0 * kStiffest * joint.servo_kp;
        const double rate =
            kHeld * kHeld / (2.0 * gait.time_step()) * std::sqrt(kStiffest) * joint.servo_kd;
        for (int j = 0; j < layout.foot_count(); ++j) {
          if (!ancestry.contains(a + 1, context.morphology.feet[j].link)) continue;
          if (!gait.in_contact(i, j)) continue;
          if (!gait.in_contact(i + 1, j)) add_held(context, i, a, j, i + 1, place + rate);
          if (!gait.in_contact(i - 1, j)) add_held(context, i, a, j, i - 1, -rate);
        }
      }
  }
  std::string_view name() const override { return "peak_torque"; }
  Penalty penalty() const override { return Penalty::linear; }

  void residual(int element, const VectorXd& z, VectorXd& r) const override {
    r[0] = std::pow(share(element, z), kPeakNorm);
  }
  void jacobian(int element, const VectorXd& z, Eigen::MatrixXd& jacobian) const override {
    jacobian =
        kPeakNorm * std::pow(share(element, z), kPeakNorm - 1) * slope(element, z).transpose();
  }
  void add_curvature(int element, const VectorXd& z, const VectorXd& multiplier,
                     Eigen::MatrixXd& hessian) const override {
    const double at = share(element, z), first = multiplier[0] * kPeakNorm;
    const VectorXd g = slope(element, z);
    hessian += first * (kPeakNorm - 1) * std::pow(at, kPeakNorm - 2) * g * g.transpose();
    if (z.size() == 1) return;
    const Vector3d mixed = first * std::pow(at, kPeakNorm - 1) * answers_[element] * kSecond;
    hessian.block<3, 1>(2, 5) += mixed;
    hessian.block<1, 3>(5, 2) += mixed.transpose();
  }
  ResidualUnit unit(int, int) const override { return {unit_, "N m"}; }
  std::string subject(int element, int) const override { return names_[element]; }
  VectorXd sample(int element, std::mt19937& random) const override {
    std::normal_distribution<double> normal;
    VectorXd z(elements_[element].slots.size());
    z[0] = unit_ * (0.9 + 0.1 * normal(random));
    if (z.size() == 1) return z;
    z[1] = unit_ * (0.9 + 0.1 * normal(random));
    for (int k = 2; k < 5; ++k) z[k] = 0.01 * normal(random);
    z[5] = weight_ * (0.5 + 0.1 * normal(random));
    return z;
  }

 private:
  static inline const Vector3d kSecond{1.0, -2.0, 1.0};

  void add(const TermContext& context, int joint, Element element, double stiffness) {
    elements_.push_back(std::move(element));
    answers_.push_back(stiffness / (weight_ * unit_));
    names_.push_back(context.morphology.links[joint + 1].joint.name);
  }
  /// Loaded knot i of a foot beside one without load, `free`.
  void add_held(const TermContext& context, int i, int joint, int foot, int free,
                double stiffness) {
    const Layout& layout = context.layout;
    const int count = layout.knot_count();
    const auto wrapped = [&](int knot) { return (knot + count) % count; };
    const auto angle = [&](int knot) { return layout.pose(wrapped(knot)) + 6 + joint; };
    add(context, joint,
        {i,
         foot,
         1,
         {layout.joint_torque(i, joint), layout.joint_torque(wrapped(free), joint), angle(free - 1),
          angle(free), angle(free + 1), layout.force(i, foot) + 2}},
        stiffness);
  }
  /// τ/(weight · length) and its gradient.
  double share(int element, const VectorXd& z) const {
    if (z.size() == 1) return z[0] / unit_;
    return ((1.0 - kHeld) * z[0] + kHeld * z[1]) / unit_ +
           answers_[element] * z[5] * kSecond.dot(z.segment<3>(2));
  }
  VectorXd slope(int element, const VectorXd& z) const {
    if (z.size() == 1) return VectorXd::Constant(1, 1.0 / unit_);
    VectorXd g(6);
    g << (1.0 - kHeld) / unit_, kHeld / unit_, answers_[element] * z[5] * kSecond,
        answers_[element] * kSecond.dot(z.segment<3>(2));
    return g;
  }

  double weight_, unit_;         // [N], [N m]
  std::vector<double> answers_;  // by element: of the servo to Δ²q and load, share per rad and N
  std::vector<std::string> names_;
};

}  // namespace

std::unique_ptr<Term> make_peak_torque(const TermContext& context) {
  return std::make_unique<PeakTorque>(context);
}

}  // namespace legwright
