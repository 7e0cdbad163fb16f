// SPDX-License-Identifier: Apache-2.0
#include "mjcf/assembly/module.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "mjcf/read/mirror.hpp"
#include "mjcf/text/numbers.hpp"

namespace legwright {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

/// A turn as MuJoCo writes it; nothing for none.
std::string turn_attribute(const Matrix3d& turn) {
  if (turn.isApprox(Matrix3d::Identity(), 1e-12)) return "";
  Eigen::Quaterniond q(turn);
  if (q.w() < 0.0) q.coeffs() = -q.coeffs();
  return fmt::format(" quat=\"{}\"", rounded_words(Eigen::Vector4d(q.w(), q.x(), q.y(), q.z())));
}

/// body ← shape. A box or a cylinder is its own mirror image in each plane of its axes.
Matrix3d turn_of(const OutlineShape& shape, const ModulePlace& place) {
  Matrix3d turn = (place.pose.linear() * shape.pose().linear()).eval();
  if (place.mirrored) {
    turn.row(1) *= -1.0;
    turn.col(1) *= -1.0;
  }
  return turn;
}

std::string size_words(const OutlineShape& shape) {
  const Vector3d half = shape.half();
  switch (shape.type) {
    case OutlineShape::Type::box:
      return rounded_words(half);
    case OutlineShape::Type::cylinder:
      return rounded_words(Eigen::Vector2d(half.x(), half.z()));
    case OutlineShape::Type::sphere:
      break;
  }
  return format_number(rounded(half.x()));
}

std::string arrow(const Vector3d& from, const Vector3d& along, double length, double width,
                  const char* colour) {
  return fmt::format("      <geom type=\"capsule\" size=\"{}\" fromto=\"{} {}\" rgba=\"{}\"/>\n",
                     format_number(rounded(width)), rounded_words(from),
                     rounded_words(from + length * along), colour);
}

}  // namespace

double OutlineShape::volume() const {
  switch (type) {
    case Type::box:
      return size.prod();
    case Type::cylinder:
      return std::numbers::pi * size.x() * size.x() * size.y();
    case Type::sphere:
      break;
  }
  return 4.0 / 3.0 * std::numbers::pi * std::pow(size.x(), 3);
}

Matrix3d OutlineShape::unit_inertia() const {
  Vector3d own;
  switch (type) {
    case Type::box: {
      const Vector3d squares = size.cwiseAbs2();
      own = (Vector3d::Constant(squares.sum()) - squares) / 12.0;
      break;
    }
    case Type::cylinder: {
      const double across_axis = (3.0 * size.x() * size.x() + size.y() * size.y()) / 12.0;
      own = {across_axis, across_axis, size.x() * size.x() / 2.0};
      break;
    }
    case Type::sphere:
      own = Vector3d::Constant(0.4 * size.x() * size.x());
      break;
  }
  const Matrix3d turn = pose().linear();
  return turn * own.asDiagonal() * turn.transpose();
}

Eigen::Isometry3d OutlineShape::pose() const {
  Eigen::Isometry3d out = Eigen::Isometry3d::Identity();
  out.translation() = position;
  if (type == Type::cylinder)
    out.linear() = Eigen::Quaterniond::FromTwoVectors(Vector3d::UnitZ(), axis).toRotationMatrix();
  return out;
}

Vector3d OutlineShape::half() const {
  switch (type) {
    case Type::box:
      return 0.5 * size;
    case Type::cylinder:
      return {size.x(), size.x(), 0.5 * size.y()};
    case Type::sphere:
      break;
  }
  return Vector3d::Constant(size.x());
}

ModuleExtent extent_of(const Module& module) {
  if (module.outline.empty()) return {};
  constexpr double kFar = std::numeric_limits<double>::infinity();
  Vector3d low = Vector3d::Constant(kFar), high = Vector3d::Constant(-kFar);
  for (const OutlineShape& shape : module.outline) {
    const Vector3d reach = shape.pose().linear().cwiseAbs() * shape.half();
    low = low.cwiseMin(shape.position - reach);
    high = high.cwiseMax(shape.position + reach);
  }
  return {0.5 * (high - low), 0.5 * (high + low)};
}

ModuleInertia inertia_of(const Module& module) {
  double volume = 0.0;
  ModuleInertia out;
  out.mass = module.mass;
  for (const OutlineShape& shape : module.outline) {
    volume += shape.volume();
    out.centre += shape.volume() * shape.position;
  }
  out.centre /= volume;
  out.inertia.setZero();
  for (const OutlineShape& shape : module.outline) {
    const Vector3d r = shape.position - out.centre;
    const double share = module.mass * shape.volume() / volume;
    out.inertia +=
        share * (shape.unit_inertia() + r.squaredNorm() * Matrix3d::Identity() - r * r.transpose());
  }
  return out;
}

Module without_rod(const Module& module) {
  Module out = module;
  double whole = 0.0, body = 0.0;
  for (const OutlineShape& shape : module.outline) {
    whole += shape.volume();
    if (!shape.on_rod) body += shape.volume();
  }
  std::erase_if(out.outline, [](const OutlineShape& shape) { return shape.on_rod; });
  out.mass = module.mass * body / whole;
  return out;
}

std::optional<double> rod_radius(const Module& module) {
  std::optional<double> out;
  for (const OutlineShape& shape : module.outline)
    if (shape.on_rod)
      out = std::min(out.value_or(shape.half().minCoeff()), shape.half().minCoeff());
  return out;
}

Vector3d ModulePlace::point(const Vector3d& of_module) const {
  const Vector3d placed = pose * of_module;
  return mirrored ? point_in_mirror(placed, Across::y) : placed;
}

Vector3d ModulePlace::direction(const Vector3d& of_module) const {
  const Vector3d turned = pose.linear() * of_module;
  return mirrored ? point_in_mirror(turned, Across::y) : turned;
}

std::string rounded_words(const Eigen::Ref<const Eigen::VectorXd>& values) {
  return format_numbers(rounded(values));
}

std::vector<std::string> outline_geoms(const Module& module, const ModulePlace& place,
                                       const std::string& attributes) {
  std::vector<std::string> out;
  for (const OutlineShape& shape : module.outline) {
    constexpr std::array kTypes{"box", "cylinder", "sphere"};
    out.push_back(fmt::format("<geom type=\"{}\" size=\"{}\" pos=\"{}\"{}{}/>",
                              kTypes[static_cast<std::size_t>(shape.type)], size_words(shape),
                              rounded_words(place.point(shape.position)),
                              turn_attribute(turn_of(shape, place)), attributes));
  }
  return out;
}

std::string inertial_element(const Module& module, const ModulePlace& place) {
  const ModuleInertia own = inertia_of(module);
  Matrix3d inertia = place.pose.linear() * own.inertia * place.pose.linear().transpose();
  if (place.mirrored) {
    inertia.row(1) *= -1.0;
    inertia.col(1) *= -1.0;
  }
  Eigen::Matrix<double, 6, 1> full;
  full << inertia(0, 0), inertia(1, 1), inertia(2, 2), inertia(0, 1), inertia(0, 2), inertia(1, 2);
  return fmt::format("<inertial pos=\"{}\" mass=\"{}\" fullinertia=\"{}\"/>",
                     rounded_words(place.point(own.centre)), format_number(own.mass),
                     rounded_words(full));
}

std::string module_scene(const Module& module) {
  double reach = 0.0;
  for (const OutlineShape& shape : module.outline)
    reach = std::max(reach, shape.half().cwiseAbs().maxCoeff());
  std::string body;
  for (const std::string& geom : outline_geoms(module, {}, " rgba=\"0.42 0.45 0.5 1\""))
    body += "      " + geom + "\n";
  if (module.joint)
    body += arrow(module.joint->position, module.joint->axis, 0.5 * reach, 0.04 * reach,
                  "0.9 0.2 0.15 1");
  if (module.slide)
    body += arrow(module.slide->position + module.slide->retracted * module.slide->axis,
                  module.slide->axis, 0.5 * reach, 0.04 * reach, "0.9 0.2 0.15 1");
  for (const Attachment& at : module.attachments)
    body += arrow(at.position, at.normal, 0.2 * reach, (at.on_horn ? 0.08 : 0.04) * reach,
                  at.on_horn ? "0.95 0.6 0.1 1" : "0.1 0.5 0.9 1");
  return fmt::format(
      "<mujoco>\n  <asset>\n    <texture type=\"skybox\" builtin=\"gradient\" rgb1=\"0.95 0.97 1\" "
      "rgb2=\"0.7 0.75 0.82\" width=\"64\" height=\"64\"/>\n  </asset>\n  <worldbody>\n    <body "
      "pos=\"0 0 {}\">\n      <freejoint/>\n{}    </body>\n"
      "  </worldbody>\n</mujoco>\n",
      format_number(rounded(3.0 * reach)), body);
}

}  // namespace legwright
