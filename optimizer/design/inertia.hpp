// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <vector>

#include "optimizer/design/morphology.hpp"

namespace legwright {

/// A joint axis, or another vector that a design turns, at one design, with its exact first and
/// second derivatives in the parameters that turn it.
struct AxisAtDesign {
  Eigen::Vector3d axis;
  std::vector<int> parameters;
  std::vector<Eigen::Vector3d> first;                // ∂a/∂s_k, in the order of `parameters`
  std::vector<std::vector<Eigen::Vector3d>> second;  // ∂²a/∂s_k∂s_l
};

AxisAtDesign axis_at(const JointAxis& joint_axis, const Eigen::VectorXd& s);

/// How a parameter moves the point masses inside their link, and makes them heavier. Mass and place
/// of a point are one vector of four, v = √m [u; 1], because all that is made of them is
/// a sum of v vᵀ; v_k = ∂v/∂s_k.
struct InnerMotion {
  int parameter;
  Eigen::Vector4d first;    // ∂/∂s_k of Σ m [u; 1]; the last entry is the link's growth
  Eigen::Matrix4d moments;  // Σ v_k vᵀ
  std::vector<Eigen::Matrix4d> products;  // Σ v_k v_lᵀ, by index of another InnerMotion
  std::vector<Eigen::Matrix4d> seconds;   // Σ v_kl vᵀ, likewise; zero where nothing bends
  /// ∂²/∂s_k∂s_l of Σ m [u; 1].
  Eigen::Vector4d second_first(const InnerMotion& other, int own_index, int index) const {
    return (seconds[index] + seconds[index].transpose() + products[index] +
            other.products[own_index])
        .col(3);
  }
};

/// A link's measures at one design. `moments` = Σ m [u; 1][u; 1]ᵀ holds mass, centre and inertia at
/// once.
struct LinkAtDesign {
  Eigen::Vector3d origin;  // in the parent's frame
  AxisAtDesign axis;
  Eigen::Matrix4d moments;
  std::vector<InnerMotion> inner;
  bool grows = false;  // whether its mass depends on the design
  bool bends = false;  // whether v_kl of a point is not zero: its mass grows, or an arm turns
};

/// M and I of a design, and every other measure kinematics needs; depends on s only.
struct GeometryAtDesign {
  GeometryAtDesign() = default;
  GeometryAtDesign(const Morphology& morphology, const Eigen::VectorXd& s);

  std::vector<LinkAtDesign> links;
  std::vector<Eigen::Vector3d> feet;          // in their link's frame
  std::vector<Eigen::Vector3d> capsule_ends;  // from, to of each capsule, in their link's frame
  std::vector<double> mass_below;             // of a link and all below it [kg]
  double total_mass = 0.0;
  bool grows = false;
};

}  // namespace legwright
