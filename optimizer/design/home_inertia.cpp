// SPDX-License-Identifier: Apache-2.0
#include "optimizer/design/home_inertia.hpp"

#include <algorithm>
#include <numeric>

#include "optimizer/design/growth.hpp"
#include "optimizer/design/inertia.hpp"
#include "optimizer/design/kinematics.hpp"
#include "optimizer/design/momentum.hpp"

namespace legwright {
namespace {

using Eigen::Matrix3d;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

/// A number with its exact first and second derivatives by the parameters.
struct Jet {
  double value = 0.0;
  VectorXd first;
  MatrixXd second;

  void add(double factor, const Jet& other) {
    value += factor * other.value;
    first += factor * other.first;
    second += factor * other.second;
  }
};

Jet zero(Eigen::Index size) { return {0.0, VectorXd::Zero(size), MatrixXd::Zero(size, size)}; }

Jet operator*(const Jet& a, const Jet& b) {
  return {a.value * b.value, a.value * b.first + b.value * a.first,
          a.value * b.second + b.value * a.second + a.first * b.first.transpose() +
              b.first * a.first.transpose()};
}

/// The robot in its home pose, and what reads off its derivatives by some parameters.
class Home {
 public:
  Home(const Morphology& morphology, const std::vector<int>& parameters, const VectorXd& s)
      : morphology_(morphology),
        geometry_(morphology, s),
        ancestry_(morphology),
        columns_(static_cast<std::size_t>(morphology.pose_size() + s.size())) {
    std::iota(columns_.begin(), columns_.end(), 0);
    for (const int parameter : parameters) kept_.push_back(morphology.pose_size() + parameter);
    VectorXd q = VectorXd::Zero(morphology.pose_size());
    q.tail(morphology.joint_count()) = morphology.nominal_joints();
    pose_.compute(morphology, geometry_, q, PoseDetail::design);
  }

  std::array<Jet, 3> com() const {
    PointDerivatives out;
    com_from_pose(geometry_, ancestry_, pose_, columns_, out);
    return jets(out, out.value);
  }

  /// Σ m p × R p over all point masses, R a quarter turn about an axis. About z that is
  /// Σ m (yz − xz, −yz − xz, x² + y²), about the others likewise, round the ring.
  std::array<Jet, 3> swept_by_quarter_turn(int axis) const {
    Matrix3d turn = Matrix3d::Zero();
    turn(axis, axis) = 1.0;
    turn((axis + 2) % 3, (axis + 1) % 3) = 1.0;
    turn((axis + 1) % 3, (axis + 2) % 3) = -1.0;
    PoseKinematics turned;
    turned.assign_moved(pose_, geometry_, turn, Vector3d::Zero());
    PairMoments moments;
    moments.compute(morphology_, pose_, turned);
    PairDerivatives out;
    out.compute_swept_momentum(geometry_, ancestry_, 0, moments, pose_, turned, columns_, columns_);
    return jets(out, out.value);
  }

 private:
  template <class Derivatives>
  std::array<Jet, 3> jets(const Derivatives& of, const Vector3d& value) const {
    const auto all = static_cast<Eigen::Index>(columns_.size());
    MatrixXd jacobian = MatrixXd::Zero(all, 3);
    of.add_jacobian(jacobian);
    std::array<Jet, 3> out;
    for (int k = 0; k < 3; ++k) {
      MatrixXd lower = MatrixXd::Zero(all, all);
      of.add_curvature(ancestry_, Vector3d::Unit(k), lower);
      const MatrixXd full = lower.selfadjointView<Eigen::Lower>();
      out[static_cast<std::size_t>(k)] = {value[k], jacobian.col(k)(kept_), full(kept_, kept_)};
    }
    return out;
  }

  const Morphology& morphology_;
  GeometryAtDesign geometry_;
  Ancestry ancestry_;
  Columns columns_;                 // of all coordinates of [q; s]
  std::vector<Eigen::Index> kept_;  // those of the parameters
  PoseKinematics pose_;
};

Jet mass_of(const Morphology& morphology, const std::vector<int>& parameters, const VectorXd& s) {
  const GrowthSum sum = growth_sum(morphology, Amount::mass, s);
  const std::vector<int> growing = growth_parameters(morphology);
  Jet mass = zero(static_cast<Eigen::Index>(parameters.size()));
  mass.value = sum.value;
  const auto place = [&](int parameter) {
    return std::find(parameters.begin(), parameters.end(), parameter) - parameters.begin();
  };
  for (std::size_t a = 0; a < growing.size(); ++a) {
    const Eigen::Index k = place(growing[a]), own = static_cast<Eigen::Index>(a);
    mass.first[k] = sum.gradient[own];
    for (std::size_t b = 0; b < growing.size(); ++b)
      mass.second(k, place(growing[b])) = sum.hessian(own, static_cast<Eigen::Index>(b));
  }
  return mass;
}

}  // namespace

HomeInertia home_inertia(const Morphology& morphology, const std::vector<int>& parameters,
                         const VectorXd& s) {
  const auto size = static_cast<Eigen::Index>(parameters.size());
  const Home home(morphology, parameters, s);
  std::array<Jet, 6> entries;
  entries.fill(zero(size));
  // About the trunk's origin: squares from the axis itself, products from the two beside it.
  const std::array<Jet, 3> about_x = home.swept_by_quarter_turn(0),
                           about_y = home.swept_by_quarter_turn(1),
                           about_z = home.swept_by_quarter_turn(2);
  entries[0].add(1.0, about_x[0]);
  entries[1].add(1.0, about_y[1]);
  entries[2].add(1.0, about_z[2]);
  entries[3].add(0.5, about_x[1]);  // about x: (y² + z², xz − xy, −xz − xy)
  entries[3].add(0.5, about_x[2]);
  entries[4].add(0.5, about_z[0]);  // about z: (yz − xz, −yz − xz, x² + y²)
  entries[4].add(0.5, about_z[1]);
  entries[5].add(0.5, about_z[1]);
  entries[5].add(-0.5, about_z[0]);
  // On to the centre of mass c: less M (|c|² − c cᵀ).
  const Jet mass = mass_of(morphology, parameters, s);
  const std::array<Jet, 3> c = home.com();
  for (std::size_t a = 0; a < 3; ++a) {
    const Jet square = mass * (c[a] * c[a]);
    entries[(a + 1) % 3].add(-1.0, square);
    entries[(a + 2) % 3].add(-1.0, square);
  }
  entries[3].add(1.0, mass * (c[0] * c[1]));
  entries[4].add(1.0, mass * (c[0] * c[2]));
  entries[5].add(1.0, mass * (c[1] * c[2]));
  HomeInertia out;
  out.jacobian.resize(size, 6);
  for (int k = 0; k < 6; ++k) {
    const Jet& entry = entries[static_cast<std::size_t>(k)];
    out.value[k] = entry.value;
    out.jacobian.col(k) = entry.first;
    out.hessian.push_back(entry.second);
  }
  return out;
}

Matrix3d symmetric_matrix(const HomeInertia::Entries& entries) {
  Matrix3d out;
  out << entries[0], entries[3], entries[4],  //
      entries[3], entries[1], entries[5],     //
      entries[4], entries[5], entries[2];
  return out;
}

}  // namespace legwright
