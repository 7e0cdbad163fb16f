// SPDX-License-Identifier: Apache-2.0
#include "mjcf/propose/doubtful_masses.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "mjcf/read/checks.hpp"
#include "mjcf/read/moving_parts.hpp"
#include "mjcf/read/tree_checks.hpp"
#include "mjcf/text/compile.hpp"
#include "mjcf/text/input_error.hpp"
#include "mjcf/text/model_arrays.hpp"

namespace legwright {
namespace {

using Eigen::Vector3d;

constexpr double kSmallMass = 1e-3;    // of the robot's: what weighs less is a stand-in
constexpr double kBeside = 1.0;        // radii of the shape from its middle: no mass is there
constexpr double kLeastBeside = 0.02;  // [m]
constexpr double kWider = 3.0;         // radii of gyration over the shape's: other units

/// A ball around the geoms of a body and of what is welded to it, its own frame and those of the
/// bodies that it carries [m, world].
struct Ball {
  Vector3d middle = Vector3d::Zero();
  double radius = 0.0;
};

/// Whether the frame of one body is fixed to that of another.
bool are_welded(const mjModel& model, int one, int other) {
  return model.body_weldid[one] == model.body_weldid[other];
}

std::optional<Ball> ball_around(const mjModel& model, const mjData& data, int body) {
  const int weld = model.body_weldid[body];
  Vector3d least = vector_at(data.xpos, body), most = least;
  bool shown = false;
  const auto add = [&](const Vector3d& at, double reach) {
    least = least.cwiseMin(at - Vector3d::Constant(reach));
    most = most.cwiseMax(at + Vector3d::Constant(reach));
  };
  for (int g = 0; g < model.ngeom; ++g) {
    if (!are_welded(model, model.geom_bodyid[g], body)) continue;
    add(vector_at(data.geom_xpos, g), model.geom_rbound[g]);
    shown = true;
  }
  for (int b = 1; b < model.nbody; ++b)
    if (model.body_weldid[b] == weld || model.body_weldid[model.body_parentid[b]] == weld)
      add(vector_at(data.xpos, b), 0.0);
  if (!shown) return std::nullopt;
  return Ball{(least + most) / 2.0, (most - least).norm() / 2.0};
}

/// How far a body's mass is from the middle of its shape, and how widely it is spread [m].
struct Spread {
  double off, gyration, reach;
  bool is_beside() const { return off > kBeside * reach + kLeastBeside; }
  bool is_wide() const { return gyration > kWider * (reach + off); }
};

/// Visits the bodies of a robot that weigh and show something.
template <class Visit>
void for_each_spread(const mjModel& model, int trunk, const std::filesystem::path& file,
                     const Visit& visit) {
  const DataPointer data = kinematics_at(model, home_qpos(model), file);
  const double least = kSmallMass * model.body_subtreemass[trunk];
  for (int b = 1; b < model.nbody; ++b) {
    if (model.body_rootid[b] != trunk || !(model.body_mass[b] > least)) continue;
    const auto shape = ball_around(model, *data, b);
    if (!shape) continue;
    visit(b, Spread{(vector_at(data->xipos, b) - shape->middle).norm(),
                    std::sqrt(vector_at(model.body_inertia, b).maxCoeff() / model.body_mass[b]),
                    shape->radius});
  }
}

/// The worst body of a kind, and how many there are.
struct Worst {
  int body = -1, count = 0;
  double factor = 0.0, size = 0.0, shape = 0.0;
  void see(int candidate, double own_factor, double own_size, double own_shape) {
    ++count;
    if (own_factor <= factor) return;
    *this = {candidate, count, own_factor, own_size, own_shape};
  }
  std::string others() const {
    return count == 1 ? "" : fmt::format(", and so of {} more", count - 1);
  }
};

std::vector<std::string> doubts_of(const mjModel& model, int trunk,
                                   const std::filesystem::path& file) {
  Worst beside, wide;
  for_each_spread(model, trunk, file, [&](int body, const Spread& spread) {
    if (spread.is_beside()) beside.see(body, spread.off / spread.reach, spread.off, spread.reach);
    if (spread.is_wide())
      wide.see(body, spread.gyration / spread.reach, spread.gyration, spread.reach);
  });
  std::vector<std::string> out;
  const auto name = [&](const Worst& worst) { return name_of(model, mjOBJ_BODY, worst.body); };
  if (beside.body >= 0)
    out.push_back(fmt::format(
        "the centre of mass of body '{}' is {:.2g} m from the middle of its shape, which reaches "
        "{:.2g} m{}: the <inertial> seems to be of another frame or unit",
        name(beside), beside.size, beside.shape, beside.others()));
  if (wide.body >= 0)
    out.push_back(
        fmt::format("the moments of inertia of body '{}' are those of {:.3g} kg at {:.2g} m from "
                    "its centre, but "
                    "its shape reaches {:.2g} m{}: they seem to be in another unit than kg m²",
                    name(wide), model.body_mass[wide.body], wide.size, wide.shape, wide.others()));
  return out;
}

}  // namespace

std::vector<std::string> doubtful_masses(const RobotModel& robot) {
  return doubts_of(*compile_mjcf(robot.xml, robot.file), robot.structure.trunk, robot.file);
}

std::vector<std::string> doubtful_masses(const RobotFiles& files) {
  try {
    const auto xml = load_xml(files.text(), files.file());
    Refusals reasons;
    check_text(*xml, reasons);
    if (!reasons.empty()) return {};
    const ModelPointer model = compile_mjcf(xml->text, files.file());
    const int trunk = find_trunk(*xml, *model, reasons);
    if (trunk < 0) return {};
    return doubts_of(*model, trunk, files.file());
  } catch (const InputError&) {
    return {};  // its reader tells all faults
  }
}

std::vector<std::string> wide_inertias(const RobotModel& robot) {
  const ModelPointer model = compile_mjcf(robot.xml, robot.file);
  std::vector<std::string> out;
  for_each_spread(*model, robot.structure.trunk, robot.file, [&](int body, const Spread& spread) {
    if (spread.is_wide()) out.push_back(name_of(*model, mjOBJ_BODY, body));
  });
  return out;
}

}  // namespace legwright
