// SPDX-License-Identifier: Apache-2.0
#include "mjcf/propose/beside_feet.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "mjcf/read/feet.hpp"
#include "mjcf/read/moving_parts.hpp"
#include "mjcf/read/soles.hpp"
#include "mjcf/text/compile.hpp"
#include "mjcf/text/elements.hpp"
#include "mjcf/text/listed.hpp"
#include "mjcf/text/model_arrays.hpp"
#include "mjcf/text/xml.hpp"

namespace legwright {
namespace {

using Eigen::Vector3d;

constexpr double kLean = 0.05;      // tangent of 3°
constexpr double kFarther = 2.0;    // × the foot's radius: what is nearer rolls as the foot does
constexpr double kLeastFar = 0.01;  // [m]

/// What touches beside a foot.
struct Beside {
  int geom = -1;
  double higher = 0.0, away = 0.0;  // than the foot's lowest point, and from it [m]
};

class Feet {
 public:
  explicit Feet(const RobotModel& robot)
      : robot_(robot),
        model_(compile_mjcf(robot.xml, robot.file)),
        data_(kinematics_at(*model_, home_qpos(*model_), robot.file)),
        xml_(load_xml(robot.xml, robot.file)),
        elements_(find_elements(*xml_, *model_)) {}

  std::vector<std::string> remarks() const {
    std::string first;
    std::vector<std::string> others;
    for (const FootContact& foot : robot_.structure.feet) {
      if (foot.normal) continue;
      const Beside beside = lowest_beside(foot);
      if (beside.geom < 0) continue;
      if (first.empty())
        first = sentence(foot, beside);
      else
        others.push_back("'" + foot.name + "'");
    }
    if (first.empty()) return {};
    return {fmt::format(
        "{}{}: the robot may walk on it as well, and the plan knows the foot alone; bend the leg "
        "in the home keyframe, or give that geom contype=\"0\" conaffinity=\"0\" if it shall not "
        "collide",
        first, others.empty() ? "" : ", and so beside foot " + listed(others))};
  }

 private:
  /// Whether a body is of the leg that ends in another one: below the trunk on the way to it, or
  /// rides on one that is.
  bool is_of_leg(int body, int end) const {
    const int trunk = robot_.structure.trunk;
    int link = moving_body(*model_, robot_.structure, body);
    if (link == trunk) return false;
    for (int k = end; k != trunk && k > 0; k = model_->body_parentid[k])
      if (k == link) return true;
    return false;
  }

  Beside lowest_beside(const FootContact& foot) const {
    const int body = foot_body(*model_, foot);
    const Vector3d place =
        vector_at(data_->xpos, body) +
        matrix_at(data_->xmat, body) * foot_point(*xml_, elements_, *model_, foot, {}).constant;
    const double low = place.z() - foot.radius;
    const double near = std::max(kLeastFar, kFarther * foot.radius);
    Beside worst;
    for (int g = 0; g < model_->ngeom; ++g) {
      const bool own = is_of_foot(foot, g);
      if (own || !collides(*model_, g) || !is_of_leg(model_->geom_bodyid[g], body)) continue;
      for (const Vector3d& point : surface_points(*model_, *data_, g)) {
        const double away = (point - place).head<2>().norm(), higher = point.z() - low;
        if (away < near || higher > kLean * away) continue;
        if (worst.geom < 0 || higher - kLean * away < worst.higher - kLean * worst.away)
          worst = {g, higher, away};
      }
    }
    return worst;
  }

  std::string sentence(const FootContact& foot, const Beside& beside) const {
    const std::string name = name_of(*model_, mjOBJ_GEOM, beside.geom),
                      body = name_of(*model_, mjOBJ_BODY, model_->geom_bodyid[beside.geom]);
    return fmt::format(
        "foot '{}': {}, {:.3g} m from it, is {:.3g} mm {} in the home pose", foot.name,
        name.empty() ? "a geom of body '" + body + "'" : "geom '" + name + "'", beside.away,
        1e3 * std::abs(beside.higher), beside.higher < 0.0 ? "lower" : "higher");
  }

  const RobotModel& robot_;
  const ModelPointer model_;
  const DataPointer data_;
  const std::unique_ptr<XmlFile> xml_;
  const TreeElements elements_;
};

}  // namespace

std::vector<std::string> beside_feet(const RobotModel& robot) {
  if (robot.structure.feet.empty()) return {};
  return Feet(robot).remarks();
}

}  // namespace legwright
