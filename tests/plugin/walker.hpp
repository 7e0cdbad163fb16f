// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "plugin/trajectory.hpp"

namespace legwright {

/// What a model of the toy walker is made of. Strings go into the XML as they are.
struct WalkerOptions {
  std::string config =
      R"(<config key="travel" value="0.1 0.02 0"/><config key="turn" value="0.3"/>)";
  std::string sensors;  // in <sensor>
  std::string trunk_joint = "<freejoint/>";
  std::string foot_a = R"(<geom name="A" size="0.02" pos="0 0 -0.2"/>)";
  std::string actuator_a;  // further attributes of the actuator of joint a
  std::string world;       // further bodies
};

/// A box on two legs, one hinge each (a and b, about y), with feet A and B, over a floor; played by
/// the instance "gait". Its trunk is 0.2 m above its feet.
std::string walker(const WalkerOptions& options = {});
/// What it plays: 8 knots, 0.8 s, joints a and b, feet A and B, seeded random numbers below 0.3, of
/// forces below 12; travel and turn as in the options above.
Trajectory walker_trajectory();
/// A sensor of legwright.sensor, named as its kind.
std::string gait_sensor(const std::string& kind, const std::string& more_config = "");

}  // namespace legwright
