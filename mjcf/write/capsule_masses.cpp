// SPDX-License-Identifier: Apache-2.0
#include "mjcf/write/capsule_masses.hpp"

#include "mjcf/shape/growing_axes.hpp"
#include "mjcf/text/model_arrays.hpp"
#include "mjcf/text/numbers.hpp"

namespace legwright {
namespace {

/// Of a capsule with this half length between its ends [m], over π r² [m].
double length_of_volume(double radius, double half) { return 2.0 * half + 4.0 / 3.0 * radius; }

}  // namespace

void write_capsule_masses(const XmlFile& xml, const mjModel& model, const TreeElements& elements,
                          const StretchMap& stretches, const Eigen::VectorXd& s, TextEdits& edits) {
  for (const auto& [body, own] : stretches) {
    if (find_named(xml.root(), "body", body)->FirstChildElement("inertial")) continue;
    const int id = mj_name2id(&model, mjOBJ_BODY, body.c_str());
    const int first = model.body_geomadr[id];
    for (int geom = first; geom < first + model.body_geomnum[id]; ++geom) {
      const XmlElement& element = *elements.geoms[static_cast<std::size_t>(geom)];
      const char* const mass = inherited_attribute(xml, element, "mass");
      if (model.geom_type[geom] != mjGEOM_CAPSULE || !mass) continue;
      const Eigen::Vector3d half = half_sizes(mjGEOM_CAPSULE, model.geom_size + 3 * geom);
      const bool from_to = inherited_attribute(xml, element, "fromto") != nullptr;
      const Stretch* const growth =
          growing_axes(mjGEOM_CAPSULE, half, rotation_at(model.geom_quat, geom), from_to, own)[2];
      if (!growth || s[growth->parameter] == growth->initial) continue;
      const double radius = half[0], grown = half[2] * s[growth->parameter] / growth->initial;
      const double ratio = length_of_volume(radius, grown) / length_of_volume(radius, half[2]);
      edits.set_numbers(element, "mass",
                        Eigen::VectorXd::Constant(1, ratio * parse_numbers(mass)->front()));
    }
  }
}

}  // namespace legwright
