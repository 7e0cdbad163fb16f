// SPDX-License-Identifier: Apache-2.0
#include "optimizer/design/actuator_length.hpp"

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <set>

#include "optimizer/design/inertia.hpp"

namespace legwright {
namespace {

using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

/// A number with its gradient and Hessian in the actuator's parameters.
struct ParameterJet {
  double value = 0.0;
  VectorXd gradient;
  MatrixXd hessian;
};
using JetVector = std::array<ParameterJet, 3>;

ParameterJet operator+(ParameterJet a, const ParameterJet& b) {
  a.value += b.value;
  a.gradient += b.gradient;
  a.hessian += b.hessian;
  return a;
}

ParameterJet operator*(double factor, ParameterJet a) {
  a.value *= factor;
  a.gradient *= factor;
  a.hessian *= factor;
  return a;
}

ParameterJet operator*(const ParameterJet& a, const ParameterJet& b) {
  const MatrixXd mixed = a.gradient * b.gradient.transpose();
  return {a.value * b.value, a.value * b.gradient + b.value * a.gradient,
          a.value * b.hessian + b.value * a.hessian + mixed + mixed.transpose()};
}

ParameterJet dot(const JetVector& a, const JetVector& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

JetVector cross(const JetVector& a, const JetVector& b) {
  const auto component = [&](int i, int j) { return a[i] * b[j] + (-1.0) * (a[j] * b[i]); };
  return {component(1, 2), component(2, 0), component(0, 1)};
}

JetVector constant(const Vector3d& v, int size) {
  JetVector out;
  for (int i = 0; i < 3; ++i) out[i] = {v[i], VectorXd::Zero(size), MatrixXd::Zero(size, size)};
  return out;
}

/// Adds rotation · v(s), v affine.
void add_affine(const AffineVector& v, const Eigen::Matrix3d& rotation, const VectorXd& s,
                const std::vector<int>& parameters, JetVector& out) {
  const Vector3d value = rotation * v.at(s);
  for (int i = 0; i < 3; ++i) out[i].value += value[i];
  for (const AffineVector::Slope& slope : v.slopes)
    for (std::size_t k = 0; k < parameters.size(); ++k)
      if (parameters[k] == slope.parameter)
        for (int i = 0; i < 3; ++i)
          out[i].gradient[static_cast<int>(k)] += rotation.row(i).dot(slope.slope);
}

JetVector axis_jet(const JointAxis& axis, const VectorXd& s, const std::vector<int>& parameters) {
  const int size = static_cast<int>(parameters.size());
  const AxisAtDesign at = axis_at(axis, s);
  JetVector out = constant(at.axis, size);
  const auto column = [&](int parameter) {
    int k = 0;
    while (parameters[k] != parameter) ++k;
    return k;
  };
  for (std::size_t k = 0; k < at.parameters.size(); ++k)
    for (int i = 0; i < 3; ++i) {
      const int a = column(at.parameters[k]);
      out[i].gradient[a] += at.first[k][i];
      for (std::size_t l = 0; l < at.parameters.size(); ++l)
        out[i].hessian(a, column(at.parameters[l])) += at.second[k][l][i];
    }
  return out;
}

}  // namespace

std::vector<int> actuator_parameters(const Morphology& morphology, const LinearActuator& actuator) {
  std::set<int> parameters;
  const Link& link = morphology.links[actuator.joint + 1];
  for (const AffineVector* v : {&link.origin, &actuator.upper, &actuator.lower})
    for (const AffineVector::Slope& slope : v->slopes) parameters.insert(slope.parameter);
  for (const JointAxis::Turn& turn : link.joint.axis.turns) parameters.insert(turn.parameter);
  return {parameters.begin(), parameters.end()};
}

ActuatorShape actuator_shape(const Morphology& morphology, const LinearActuator& actuator,
                             const VectorXd& s) {
  const Link& link = morphology.links[actuator.joint + 1];
  ActuatorShape out;
  out.parameters = actuator_parameters(morphology, actuator);
  const int size = static_cast<int>(out.parameters.size());
  const Eigen::Matrix3d to_link = link.orientation.transpose();
  JetVector w = constant(Vector3d::Zero(), size), l = w;
  add_affine(link.origin, to_link, s, out.parameters, w);
  add_affine(actuator.upper, -to_link, s, out.parameters, w);
  add_affine(actuator.lower, Eigen::Matrix3d::Identity(), s, out.parameters, l);
  const JetVector a = axis_jet(link.joint.axis, s, out.parameters);

  const ParameterJet along = 2.0 * (dot(w, a) * dot(l, a));
  const double unit = 1.0 / (morphology.leg_length * morphology.leg_length);
  const std::array<ParameterJet, 3> shape{
      dot(w, w) + dot(l, l) + along, 2.0 * dot(w, l) + (-1.0) * along, 2.0 * dot(w, cross(a, l))};
  out.jacobian.resize(3, size);
  for (int i = 0; i < 3; ++i) {
    out.value[i] = unit * shape[i].value;
    out.jacobian.row(i) = unit * shape[i].gradient.transpose();
    out.hessian.push_back(unit * shape[i].hessian);
  }
  return out;
}

double actuator_length(const Vector3d& shape, double q) {
  return std::sqrt(shape[0] + shape[1] * std::cos(q) + shape[2] * std::sin(q));
}

double moment_arm(const Vector3d& shape, double q) {
  return (shape[2] * std::cos(q) - shape[1] * std::sin(q)) / (2.0 * actuator_length(shape, q));
}

}  // namespace legwright
