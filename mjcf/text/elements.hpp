// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <mujoco/mujoco.h>

#include <Eigen/Geometry>
#include <string>
#include <vector>

#include "mjcf/text/xml.hpp"

namespace legwright {

/// The elements of a robot's tree by the ids of the compiled model; also those that have no name.
struct TreeElements {
  std::vector<const XmlElement*> bodies, joints, geoms, sites;  // bodies[0]: null, the world
};

/// Pairs elements and ids: both follow the document, body by body. Throws InputError where they do
/// not, as in files with generated parts.
TreeElements find_elements(const XmlFile& xml, const mjModel& model);

/// The elements in all sections of a tag (<tendon>, <actuator>, <equality>) by their ids in the
/// compiled model: they may have no names, their order counts.
class SectionElements {
 public:
  SectionElements(const XmlFile& xml, const char* section);
  /// The root where there is none.
  const XmlElement& operator[](int id) const;

 private:
  const XmlElement& root_;
  std::vector<const XmlElement*> elements_;
};

/// Pose of an element (body, frame, geom, site) in the element it stands in, from its own
/// attributes, its default class and the settings of <compiler>. `fromto` is not looked at.
Eigen::Isometry3d pose_of(const XmlFile& xml, const XmlElement& element);

/// The same in the body that holds the element, through the frames around it.
Eigen::Isometry3d pose_in_body(const XmlFile& xml, const XmlElement& element);

/// What <compiler> says, or `otherwise`.
std::string compiler_setting(const XmlFile& xml, const char* name, const char* otherwise);

}  // namespace legwright
