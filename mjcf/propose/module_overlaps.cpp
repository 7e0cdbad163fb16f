// SPDX-License-Identifier: Apache-2.0
#include "mjcf/propose/module_overlaps.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "mjcf/read/declared_modules.hpp"
#include "mjcf/read/moving_parts.hpp"
#include "mjcf/text/compile.hpp"
#include "mjcf/text/listed.hpp"

namespace legwright {
namespace {

using Eigen::Vector3d;

constexpr double kNotNear = 1e-3;         // [m]: distances beyond need not be known
constexpr double kAlongOneAxis = 0.95;    // cosine
constexpr std::size_t kMostOverlaps = 4;  // of a robot's overlaps

using Points = Eigen::Map<const Vector3d>;

class Overlaps {
 public:
  Overlaps(const mjModel& model, const std::filesystem::path& file)
      : model_(model),
        data_(kinematics_at(model, home_qpos(model), file)),
        modules_(declared_modules(model)) {}

  std::vector<ModuleOverlap> run() const {
    std::vector<ModuleOverlap> out;
    for (std::size_t b = 0; b < modules_.size(); ++b)
      for (std::size_t a = 0; a < b; ++a) {
        if (may_be_within(modules_[a], modules_[b])) continue;
        const ModuleOverlap found = overlap(modules_[a], modules_[b]);
        if (found.depth >= kToldOverlap) out.push_back(found);
      }
    return out;
  }

 private:
  bool may_be_within(const DeclaredModule& a, const DeclaredModule& b) const {
    const auto is_on = [&](const DeclaredModule& trunk, const DeclaredModule& other) {
      return trunk.is_trunk() && model_.body_parentid[other.body] == trunk.body &&
             other.kind != "foot";
    };
    return is_on(a, b) || is_on(b, a);
  }

  ModuleOverlap overlap(const DeclaredModule& a, const DeclaredModule& b) const {
    ModuleOverlap out{a.of, b.of};
    for (const int one : a.geoms)
      for (const int other : b.geoms) {
        if (are_far(one, other)) continue;
        std::array<mjtNum, 6> ends{};
        const double depth =
            -mj_geomDistance(&model_, data_.get(), one, other, kNotNear, ends.data());
        if (depth <= out.depth) continue;
        out.depth = depth;
        out.along = (Points(ends.data() + 3) - Points(ends.data())).normalized();
      }
    const bool of_trunk = a.is_trunk() || b.is_trunk();
    out.is_deep = out.depth > 0.0 && !of_trunk && (is_in(middle(a), b) || is_in(middle(b), a));
    return out;
  }

  bool are_far(int one, int other) const {
    return (place(one) - place(other)).norm() > model_.geom_rbound[one] + model_.geom_rbound[other];
  }

  Vector3d place(int geom) const { return Points(data_->geom_xpos + std::ptrdiff_t{3} * geom); }

  /// Of its shapes, larger ones weighing more.
  Vector3d middle(const DeclaredModule& module) const {
    double weight = 0.0;
    Vector3d sum = Vector3d::Zero();
    for (const int geom : module.geoms) {
      const double size = std::pow(model_.geom_rbound[geom], 3);
      sum += size * place(geom);
      weight += size;
    }
    return sum / weight;
  }

  bool is_in(const Vector3d& point, const DeclaredModule& module) const {
    return std::any_of(module.geoms.begin(), module.geoms.end(),
                       [&](int geom) { return is_in_geom(point, geom); });
  }

  bool is_in_geom(const Vector3d& point, int geom) const {
    const Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>> axes(
        data_->geom_xmat + std::ptrdiff_t{9} * geom);
    const Vector3d at = axes.transpose() * (point - place(geom)),
                   size = Points(model_.geom_size + std::ptrdiff_t{3} * geom);
    switch (model_.geom_type[geom]) {
      case mjGEOM_BOX:
        return (at.cwiseAbs().array() < size.array()).all();
      case mjGEOM_CYLINDER:
        return at.head<2>().norm() < size.x() && std::abs(at.z()) < size.y();
      default:
        return at.norm() < size.x();
    }
  }

  const mjModel& model_;
  const DataPointer data_;
  const std::vector<DeclaredModule> modules_;
};

}  // namespace

std::vector<ModuleOverlap> module_overlaps(const mjModel& model,
                                           const std::filesystem::path& file) {
  const Overlaps overlaps(model, file);
  std::vector<ModuleOverlap> out;
  call_engine(file, [&] { out = overlaps.run(); });
  return out;
}

std::string depth_words(const ModuleOverlap& overlap, const std::string& other) {
  std::string way;
  for (Eigen::Index k = 0; k < 3; ++k)
    if (std::abs(overlap.along[k]) > kAlongOneAxis) way = fmt::format(" along {}", "xyz"[k]);
  return fmt::format("{:.2g} mm inside {}{}", 1e3 * overlap.depth, other, way);
}

std::vector<std::string> overlapping_modules(const RobotModel& robot) {
  std::vector<ModuleOverlap> overlaps =
      module_overlaps(*compile_mjcf(robot.xml, robot.file), robot.file);
  if (overlaps.empty()) return {};
  std::stable_sort(
      overlaps.begin(), overlaps.end(),
      [](const ModuleOverlap& a, const ModuleOverlap& b) { return a.depth > b.depth; });
  std::vector<std::string> told;
  told.reserve(overlaps.size());
  for (const ModuleOverlap& each : overlaps)
    told.push_back(
        fmt::format("'{}' is {}", each.first, depth_words(each, "'" + each.second + "'")));
  return {fmt::format(
      "modules stand inside each other in the home pose: {}; nobody can put such a robot together: "
      "in its assembly move them apart by position, hip, step or offset, or turn a servo by roll, "
      "and build it anew",
      listed(told, kMostOverlaps, "; "))};
}

}  // namespace legwright
