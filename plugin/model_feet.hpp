// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <mujoco/mujoco.h>

#include <string>
#include <vector>

namespace legwright {

/// A foot of the trajectory in the model.
struct ModelFoot {
  int body = -1;
  std::vector<int> geoms;  // whose contacts are its contacts, at least one
};

/// The geom of that name; else every colliding geom of the body that carries the site of that name,
/// or of the body of that name. Throws ConfigError, saying what to name, where there is none, or
/// where geom, site and body of that name lie on different bodies.
ModelFoot find_foot(const mjModel* m, const std::string& name);

/// All of them. Throws also where two share a geom: its contacts could not be told apart.
std::vector<ModelFoot> find_feet(const mjModel* m, const std::vector<std::string>& names);

/// The normal force [N] of a contact on a foot from anything but the robot it belongs to, 0 if it
/// is no such contact. Sets `foot` then. @param foot_of_geom foot of each geom, −1 for none.
double foot_contact_force(const mjModel* m, const mjData* d, int contact,
                          const std::vector<int>& foot_of_geom, int& foot) noexcept;

/// For each geom of the model the number of its foot, −1 for none.
std::vector<int> feet_by_geom(const mjModel* m, const std::vector<ModelFoot>& feet);

}  // namespace legwright
