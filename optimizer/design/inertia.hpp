// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <vector>

#include "optimizer/design/morphology.hpp"

namespace legwright {

/// A joint axis at one design, with its exact first and second derivatives in the parameters that turn it.
struct AxisAtDesign {
  Eigen::Vector3d axis;
  std::vector<int> parameters;
  std::vector<Eigen::Vector3d> first;                // ∂a/∂s_k, in the order of `parameters`
  std::vector<std::vector<Eigen::Vector3d>> second;  // ∂²a/∂s_k∂s_l
};

AxisAtDesign axis_at(const JointAxis& joint_axis, const Eigen::VectorXd& s);

/// How a parameter moves the point masses inside their link: moments of the slopes u_k = ∂u/∂s_k.
struct InnerMotion {
  int parameter;
  Eigen::Vector3d first;                // Σ m u_k
  Eigen::Matrix<double, 3, 4> moments;  // Σ m u_k [u; 1]ᵀ
  std::vector<std::pair<int, Eigen::Matrix3d>>
      products;  // (index of another InnerMotion, Σ m u_k u_lᵀ)
};

/// A link's measures at one design. `moments` = Σ m [u; 1][u; 1]ᵀ holds mass, centre and inertia at once.
struct LinkAtDesign {
  Eigen::Vector3d origin;  // in the parent's frame
  AxisAtDesign axis;
  Eigen::Matrix4d moments;
  std::vector<InnerMotion> inner;
};

/// M and I of a design, and every other measure kinematics needs; depends on s only.
struct GeometryAtDesign {
  GeometryAtDesign() = default;
  GeometryAtDesign(const Morphology& morphology, const Eigen::VectorXd& s);

  std::vector<LinkAtDesign> links;
  std::vector<Eigen::Vector3d> feet;  // in their link's frame
  std::vector<double> mass_below;      // of a link and all below it [kg]
  double total_mass = 0.0;
};

}  // namespace legwright
