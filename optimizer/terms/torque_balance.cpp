// SPDX-License-Identifier: Apache-2.0
#include <Eigen/Geometry>
#include <array>

#include "optimizer/design/home_inertia.hpp"
#include "optimizer/design/rotation.hpp"
#include "optimizer/terms/factories.hpp"

namespace legwright {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using Eigen::VectorXd;

/// Eq (13), second half, with the angular momentum of the whole robot in place of I ö:
///   Σ_j (e_iʲ − r_j ẑ − x_i) × f_iʲ = Σ_p m_p (p_i − x_i) × (p_{i−1} − 2 p_i + p_{i+1})/h²
/// over all point masses p.
/// Forces act where the balls touch the ground, a radius r_j below their centres e_iʲ.
/// Because p × p = 0 the right-hand side is
///   (A_i − A_{i−1} − M x_i × (c_{i−1} − 2 c_i + c_{i+1}))/h²
/// with the swept momentum A_i = Σ m p_i × p_{i+1} and c = φ_COM, all of which have slots. Residual
/// over weight times length. Where M depends on the design its share of the initial mass is the
/// last local variable.
class TorqueBalance final : public Term {
 public:
  explicit TorqueBalance(const TermContext& context)
      : scale_(1.0 / (context.weight * context.length)),
        mass_(context.mass),
        path_(context.path),
        grows_(context.morphology.grows() ? 1 : 0) {
    const Layout& layout = context.layout;
    const double h = context.task.gait.time_step();
    rate_ = scale_ / (h * h);
    radii_.resize(static_cast<std::size_t>(layout.knot_count()));
    for (int i = 0; i < layout.knot_count(); ++i) {
      Element element{i, -1, 3, {}};
      const auto push = [&element](int slot) {
        for (int k = 0; k < 3; ++k) element.slots.push_back(slot + k);
      };
      push(layout.swept_momentum(i));
      push(i > 0 ? layout.swept_momentum(i - 1) : layout.wrapping_momentum());
      push(layout.com_from_pose(i > 0 ? i - 1 : layout.knot_count() - 1));
      push(layout.com_from_pose(i));
      push(layout.com_from_pose(i + 1));
      push(layout.com(i));
      for (int j = 0; j < layout.foot_count(); ++j) {
        if (layout.force(i, j) < 0) continue;
        push(layout.foot(i, j));
        push(layout.force(i, j));
        radii_[static_cast<std::size_t>(i)].push_back(context.morphology.feet[j].radius);
      }
      if (grows_ > 0) element.slots.push_back(layout.mass_share());
      elements_.push_back(std::move(element));
    }
  }
  std::string_view name() const override { return "torque_balance"; }
  ResidualUnit unit(int, int) const override { return {1.0 / scale_, "N m"}; }

  void residual(int element, const Eigen::VectorXd& z, Eigen::VectorXd& r) const override {
    const Vector3d x = z.segment<3>(kX);
    r = -rate_ *
        (z.segment<3>(kAfter) - z.segment<3>(kBefore) - mass(z) * x.cross(bend(element, z)));
    for (int k = kFeet; k < z.size() - grows_; k += 6)
      r += scale_ * (contact(element, z, k) - x).cross(z.segment<3>(k + 3));
  }

  void jacobian(int element, const Eigen::VectorXd& z, Eigen::MatrixXd& jacobian) const override {
    const Vector3d x = z.segment<3>(kX);
    jacobian.setZero();
    jacobian.middleCols<3>(kAfter) = -rate_ * Matrix3d::Identity();
    jacobian.middleCols<3>(kBefore) = rate_ * Matrix3d::Identity();
    const Matrix3d lever = rate_ * mass(z) * skew(x);
    jacobian.middleCols<3>(kComBefore) = lever * back(element);
    jacobian.middleCols<3>(kCom) = -2 * lever;
    jacobian.middleCols<3>(kComAfter) = lever;
    jacobian.middleCols<3>(kX) = -rate_ * mass(z) * skew(bend(element, z));
    if (grows_ > 0) jacobian.col(z.size() - 1) = rate_ * mass_ * x.cross(bend(element, z));
    for (int k = kFeet; k < z.size() - grows_; k += 6) {
      const Matrix3d force = scale_ * skew(z.segment<3>(k + 3));
      jacobian.middleCols<3>(kX) += force;
      jacobian.middleCols<3>(k) = -force;
      jacobian.middleCols<3>(k + 3) = scale_ * skew(contact(element, z, k) - x);
    }
  }

  void add_curvature(int element, const Eigen::VectorXd& z, const Eigen::VectorXd& multiplier,
                     Eigen::MatrixXd& hessian) const override {
    // multiplier · (a × b) = aᵀ form b.
    const Matrix3d form = -skew(multiplier.head<3>());
    const auto add = [&hessian](int a, int b, const Matrix3d& block) {
      hessian.block<3, 3>(a, b) += block;
      hessian.block<3, 3>(b, a) += block.transpose();
    };
    const Matrix3d lever = rate_ * mass(z) * form;
    add(kX, kComBefore, lever * back(element));
    add(kX, kCom, -2 * lever);
    add(kX, kComAfter, lever);
    if (grows_ > 0) add_growth(element, z, rate_ * mass_ * form, hessian);
    for (int k = kFeet; k < z.size() - grows_; k += 6) {
      add(k, k + 3, scale_ * form);
      add(kX, k + 3, -scale_ * form);
    }
  }

  Eigen::VectorXd sample(int element, std::mt19937& random) const override {
    std::normal_distribution<double> normal;
    Eigen::VectorXd z(static_cast<int>(elements_[element].slots.size()));
    for (double& value : z) value = 0.3 * normal(random);
    if (grows_ > 0) z[z.size() - 1] += 1.0;
    for (int k = kFeet; k < z.size() - grows_; k += 6) z.segment<3>(k + 3) *= 10.0;
    return z;
  }

 private:
  // Positions of the local variables: A_i, A_{i−1}, c_{i−1}, c_i, c_{i+1}, x_i, then foot and force
  // by turns.
  static constexpr int kAfter = 0, kBefore = 3, kComBefore = 6, kCom = 9, kComAfter = 12, kX = 15,
                       kFeet = 18;

  /// Knot T − 1, moved back by one cycle, stands before knot 0.
  Matrix3d back(int knot) const {
    return knot > 0 ? Matrix3d::Identity() : Matrix3d(path_.turn().transpose());
  }
  Vector3d bend(int knot, const Eigen::VectorXd& z) const {
    Vector3d before = z.segment<3>(kComBefore);
    if (knot == 0) before = back(0) * (before - path_.travel());
    return before - 2 * z.segment<3>(kCom) + z.segment<3>(kComAfter);
  }

  double mass(const Eigen::VectorXd& z) const {
    return grows_ > 0 ? mass_ * z[z.size() - 1] : mass_;
  }
  /// Mixed second derivatives of the mass share with x and the places of the centre of mass.
  void add_growth(int element, const Eigen::VectorXd& z, const Matrix3d& form,
                  Eigen::MatrixXd& hessian) const {
    const Eigen::Index last = z.size() - 1;
    const auto add = [&](int at, const Vector3d& mixed) {
      hessian.block<3, 1>(at, last) += mixed;
      hessian.block<1, 3>(last, at) += mixed.transpose();
    };
    const Vector3d by_bend = form.transpose() * z.segment<3>(kX);
    add(kX, form * bend(element, z));
    add(kComBefore, back(element).transpose() * by_bend);
    add(kCom, -2 * by_bend);
    add(kComAfter, by_bend);
  }

  /// Where the force of a foot acts: below the centre of its ball.
  Vector3d contact(int element, const Eigen::VectorXd& z, int k) const {
    const double radius =
        radii_[static_cast<std::size_t>(element)][static_cast<std::size_t>((k - kFeet) / 6)];
    return z.segment<3>(k) - radius * Vector3d::UnitZ();
  }

  std::vector<std::vector<double>> radii_;  // of the standing feet, by knot
  double scale_, mass_, rate_ = 0.0;
  WantedPath path_;
  int grows_;  // local variables for the mass
};

/// Eq (13), second half, as the paper has it: Σ_j (e_iʲ − r_j ẑ − x_i) × f_iʲ = I ö_i with the
/// second difference ö_i = (o_{i−1} − 2 o_i + o_{i+1})/h² of the root's rotation vector and the
/// robot's moments of inertia in its home pose, I(s), which do not change over the motion. They
/// stand in the frame of the wanted heading. Before knot 0 stands knot T − 1, less a cycle's turn.
class ConstantInertiaBalance final : public Term {
 public:
  explicit ConstantInertiaBalance(const TermContext& context)
      : scale_(1.0 / (context.weight * context.length)),
        inertia_unit_(context.mass * context.length * context.length),
        turn_(0.0, 0.0, context.path.turn_angle()) {
    const Layout& layout = context.layout;
    const double h = context.task.gait.time_step();
    rate_ = scale_ / (h * h);
    for (int i = 0; i < layout.knot_count(); ++i) {
      Element element{i, -1, 3, {}};
      const auto push = [&element](int slot, int size = 3) {
        for (int k = 0; k < size; ++k) element.slots.push_back(slot + k);
      };
      push(layout.home_inertia(), 6);
      push(layout.pose(i > 0 ? i - 1 : layout.knot_count() - 1) + 3);
      push(layout.pose(i) + 3);
      push(layout.pose(i + 1) + 3);
      push(layout.com(i));
      radii_.emplace_back();
      for (int j = 0; j < layout.foot_count(); ++j) {
        if (layout.force(i, j) < 0) continue;
        push(layout.foot(i, j));
        push(layout.force(i, j));
        radii_.back().push_back(context.morphology.feet[j].radius);
      }
      elements_.push_back(std::move(element));
      const Matrix3d heading = WantedPath::yaw_rotation(context.path.heading(i * h));
      parts_.emplace_back();
      for (int k = 0; k < 6; ++k)
        parts_.back()[static_cast<std::size_t>(k)] =
            heading * symmetric_matrix(HomeInertia::Entries::Unit(k)) * heading.transpose();
    }
  }
  std::string_view name() const override { return "torque_balance"; }
  ResidualUnit unit(int, int) const override { return {1.0 / scale_, "N m"}; }

  void residual(int element, const VectorXd& z, VectorXd& r) const override {
    r = -rate_ * (inertia(element, z) * bend(element, z));
    for (int k = kFeet; k < z.size(); k += 6)
      r += scale_ * arm(element, z, k).cross(z.segment<3>(k + 3));
  }

  void jacobian(int element, const VectorXd& z, Eigen::MatrixXd& jacobian) const override {
    const Vector3d bent = bend(element, z);
    for (int k = 0; k < 6; ++k) jacobian.col(k) = -rate_ * (part(element, k) * bent);
    const Matrix3d by_bend = -rate_ * inertia(element, z);
    for (int at = 0; at < 3; ++at) jacobian.middleCols<3>(kTurns + 3 * at) = kBend[at] * by_bend;
    jacobian.middleCols<3>(kX).setZero();
    for (int k = kFeet; k < z.size(); k += 6) {
      const Matrix3d force = scale_ * skew(z.segment<3>(k + 3));
      jacobian.middleCols<3>(kX) += force;
      jacobian.middleCols<3>(k) = -force;
      jacobian.middleCols<3>(k + 3) = scale_ * skew(arm(element, z, k));
    }
  }

  void add_curvature(int element, const VectorXd& z, const VectorXd& multiplier,
                     Eigen::MatrixXd& hessian) const override {
    const Vector3d wanted = multiplier.head<3>();
    const auto add = [&hessian](int a, int b, const auto& block) {
      hessian.block(a, b, block.rows(), block.cols()) += block;
      hessian.block(b, a, block.cols(), block.rows()) += block.transpose();
    };
    for (int k = 0; k < 6; ++k) {
      const Vector3d mixed = -rate_ * (part(element, k) * wanted);
      for (int at = 0; at < 3; ++at) add(kTurns + 3 * at, k, Vector3d(kBend[at] * mixed));
    }
    const Matrix3d form = -scale_ * skew(wanted);  // wanted · (a × b) = aᵀ form b
    for (int k = kFeet; k < z.size(); k += 6) {
      add(k, k + 3, form);
      add(kX, k + 3, Matrix3d(-form));
    }
  }

  VectorXd sample(int element, std::mt19937& random) const override {
    std::normal_distribution<double> normal;
    VectorXd z(static_cast<int>(elements_[element].slots.size()));
    for (double& value : z) value = 0.3 * normal(random);
    z.head<6>() *= inertia_unit_;
    for (int k = kFeet; k < z.size(); k += 6) z.segment<3>(k + 3) *= 10.0;
    return z;
  }

 private:
  // Positions of the local variables: I, o_{i−1}, o_i, o_{i+1}, x_i, then foot and force by turns.
  static constexpr int kTurns = 6, kX = 15, kFeet = 18;
  static constexpr double kBend[3] = {1.0, -2.0, 1.0};

  Vector3d bend(int knot, const VectorXd& z) const {
    Vector3d before = z.segment<3>(kTurns);
    if (knot == 0) before -= turn_;
    return before - 2 * z.segment<3>(kTurns + 3) + z.segment<3>(kTurns + 6);
  }
  /// What entry k of I adds to it, in the world.
  const Matrix3d& part(int knot, int k) const {
    return parts_[static_cast<std::size_t>(knot)][static_cast<std::size_t>(k)];
  }
  Matrix3d inertia(int knot, const VectorXd& z) const {
    Matrix3d sum = Matrix3d::Zero();
    for (int k = 0; k < 6; ++k) sum += z[k] * part(knot, k);
    return sum;
  }
  /// From the centre of mass to where the force of a foot acts: below the centre of its ball.
  Vector3d arm(int knot, const VectorXd& z, int k) const {
    const double radius =
        radii_[static_cast<std::size_t>(knot)][static_cast<std::size_t>((k - kFeet) / 6)];
    return z.segment<3>(k) - radius * Vector3d::UnitZ() - z.segment<3>(kX);
  }

  std::vector<std::vector<double>> radii_;      // of the standing feet, by knot
  std::vector<std::array<Matrix3d, 6>> parts_;  // by knot
  double scale_, inertia_unit_, rate_ = 0.0;
  Vector3d turn_;  // one cycle's, as a rotation vector
};

}  // namespace

std::unique_ptr<Term> make_torque_balance(const TermContext& context) {
  if (context.task.dynamics == Dynamics::constant_inertia)
    return std::make_unique<ConstantInertiaBalance>(context);
  return std::make_unique<TorqueBalance>(context);
}

}  // namespace legwright
