// SPDX-License-Identifier: Apache-2.0
#include "mjcf/write/connector_hulls.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "mjcf/read/connectors.hpp"
#include "mjcf/text/numbers.hpp"

namespace legwright {

SolidInertial inertial_of(const SolidMoments& solid, double density) {
  const Eigen::Matrix3d inertia = density * solid.inertia();
  SolidInertial out{density * solid.volume, solid.centre, {}};
  out.full << inertia(0, 0), inertia(1, 1), inertia(2, 2), inertia(0, 1), inertia(0, 2),
      inertia(1, 2);
  return out;
}

Eigen::VectorXd vertices_of(const std::vector<Facet>& facets,
                            const std::vector<Eigen::Vector3d>& points) {
  const std::vector<int> corners = corners_of(facets);
  Eigen::VectorXd out(3 * static_cast<Eigen::Index>(corners.size()));
  Eigen::Index at = 0;
  for (const int corner : corners) {
    out.segment<3>(at) = points[static_cast<std::size_t>(corner)];
    at += 3;
  }
  return out;
}

namespace {

std::string declared_points(const RobotModel& robot, const Connector& connector,
                            const Eigen::VectorXd& s) {
  std::string out = format_number(connector.density) + " kg/m3";
  for (const Connector::End& end : connector.ends) {
    std::vector<double> numbers;
    for (const Eigen::Vector3d& point : turned_end(robot, end, s))
      numbers.insert(numbers.end(), point.begin(), point.end());
    const auto size = static_cast<Eigen::Index>(numbers.size());
    out += fmt::format(" | {}: {}", end.what,
                       format_numbers(rounded(Eigen::VectorXd::Map(numbers.data(), size))));
  }
  return out;
}

}  // namespace

void write_connectors(const RobotModel& robot, const XmlFile& xml, const mjModel& model,
                      const TreeElements& elements, const Eigen::VectorXd& s, TextEdits& edits) {
  if (robot.connectors.empty()) return;
  const Eigen::VectorXd initial = robot.space.initial();
  const MeshElements meshes = find_mesh_elements(xml);
  for (const Connector& connector : robot.connectors) {
    const bool turned = turns(robot, connector, s);
    const bool moves =
        turned ||
        std::any_of(
            connector.points.begin(), connector.points.end(), [&](const AffineVector& point) {
              return std::any_of(point.slopes.begin(), point.slopes.end(), [&](const auto& slope) {
                return s[slope.parameter] != initial[slope.parameter];
              });
            });
    if (!moves) continue;
    const std::vector<Eigen::Vector3d> points = points_at(turned_points(robot, connector, s), s);
    const std::vector<Facet> facets = facets_at(connector, points);
    if (turned)
      edits.set(*find_named(xml.root(), "text", std::string(kConnectorPrefix) + connector.mesh),
                "data", declared_points(robot, connector, s));
    const int body = mj_name2id(&model, mjOBJ_BODY, connector.body.c_str());
    const XmlElement& inertial =
        *elements.bodies[static_cast<std::size_t>(body)]->FirstChildElement("inertial");
    edits.set_numbers(*meshes.at(connector.mesh), "vertex", vertices_of(facets, points));
    const SolidInertial own = inertial_of(moments_of_solid(facets, points), connector.density);
    edits.set_numbers(inertial, "mass", Eigen::VectorXd::Constant(1, own.mass));
    edits.set_numbers(inertial, "pos", own.centre);
    for (const char* const name : {"diaginertia", "quat", "euler", "axisangle", "xyaxes", "zaxis"})
      edits.remove(inertial, name);
    edits.set_numbers(inertial, "fullinertia", own.full);
  }
}

}  // namespace legwright
