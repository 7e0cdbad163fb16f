// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <string>
#include <string_view>
#include <vector>

namespace legwright {

/// What a design parameter is: a length that stretches bodies, an angle that turns joint axes, or
/// a coordinate of attachment points in their bodies' frames.
enum class ParameterKind { length, axis_angle, position };

/// The kind as files write it: its enumerator's name.
const char* to_string(ParameterKind kind);

/// One entry of s, eq (1). Ties are part of it: `tied_count` bodies or joints follow this number.
struct DesignParameter {
  std::string name;      // without the prefix legwright/
  std::string unit;      // "m" or "rad"
  std::string sentence;  // what it is, for people
  ParameterKind kind = ParameterKind::length;
  double initial = 0.0;
  double lower = 0.0;  // hard bounds, lower ≤ initial ≤ upper
  double upper = 0.0;
  int tied_count = 1;

  /// A parameter that cannot move stays in s: solvers hold it, reports list it.
  bool frozen() const { return lower == upper; }
};

/// The parameters of a design in order; the values themselves travel as a plain vector s.
struct DesignSpace {
  std::vector<DesignParameter> parameters;

  int size() const { return static_cast<int>(parameters.size()); }
  Eigen::VectorXd initial() const;
  Eigen::VectorXd lower() const;
  Eigen::VectorXd upper() const;
  Eigen::VectorXd clamp(const Eigen::VectorXd& s) const;
  /// Natural unit of each parameter: its initial length, one radian, or half the way that a
  /// position may go.
  Eigen::VectorXd scale() const;
  /// Position of a parameter in s, −1 if there is none of this name.
  int find(std::string_view name) const;
};

}  // namespace legwright
