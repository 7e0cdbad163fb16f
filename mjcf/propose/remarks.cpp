// SPDX-License-Identifier: Apache-2.0
#include "mjcf/propose/remarks.hpp"

#include <utility>

#include "mjcf/propose/beside_feet.hpp"
#include "mjcf/propose/doubtful_masses.hpp"
#include "mjcf/propose/doubtful_units.hpp"
#include "mjcf/propose/foot_pictures.hpp"
#include "mjcf/propose/home_touches.hpp"
#include "mjcf/propose/module_overlaps.hpp"
#include "mjcf/propose/odd_joints.hpp"
#include "mjcf/propose/unlike_sides.hpp"
#include "mjcf/propose/unread_ranges.hpp"

namespace legwright {

std::vector<std::string> remarks_on(const RobotModel& robot, const std::vector<Limb>& limbs,
                                    const Facing& facing) {
  const Across across = sides_across(facing.ahead);
  std::vector<std::string> out = unlike_sides(robot, limbs, across);
  if (!facing.remark.empty()) out.insert(out.begin(), facing.remark);
  if (std::string remark = tied_though_unlike(robot, limbs, across); !remark.empty())
    out.push_back(std::move(remark));
  for (std::string& remark : doubtful_units(robot, limbs)) out.push_back(std::move(remark));
  for (std::string& remark : unread_ranges(robot)) out.push_back(std::move(remark));
  for (std::string& remark : odd_joints(robot)) out.push_back(std::move(remark));
  if (std::string remark = unlimited_torques(robot); !remark.empty())
    out.push_back(std::move(remark));
  if (std::string remark = overdamped_joints(robot); !remark.empty())
    out.push_back(std::move(remark));
  for (std::string& remark : doubtful_masses(robot)) out.push_back(std::move(remark));
  for (std::string& remark : overlapping_modules(robot)) out.push_back(std::move(remark));
  for (std::string& remark : overlapping_links(robot)) out.push_back(std::move(remark));
  for (std::string& remark : feet_beside_pictures(robot)) out.push_back(std::move(remark));
  for (std::string& remark : beside_feet(robot)) out.push_back(std::move(remark));
  return out;
}

}  // namespace legwright
