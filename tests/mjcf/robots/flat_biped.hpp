// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace legwright::test {

/// How flat_biped() is drawn.
struct FlatBiped {
  /// Geoms of each foot, in the frame of the ankle, which is 0.05 m above the ground; SIDE stands
  /// for its side.
  std::string foot =
      R"(<geom name="SIDE_sole" type="box" size="0.08 0.04 0.01" pos="0.02 0 -0.04"/>)";
  bool ankle_roll = true;  // a sixth hinge in each leg
  double limit = 60.0;     // of the ankles' motors [N m]; the others have 200
  double kp = 400.0, kd = 20.0;
  std::string custom = {};  // content of <custom>
};

/// A biped of hinges yaw, roll, pitch, knee, ankle, ankle roll in each leg, 18.4 kg, bent at home
/// with level soles.
std::string flat_biped(const FlatBiped& how = {});

/// Feet by name of what they are made of: those that touch with a face, and those that do not.
struct NamedFoot {
  const char* name;
  const char* geoms;
};
const std::vector<NamedFoot>& flat_feet();
const std::vector<NamedFoot>& pointed_feet();
const char* foot_geoms(const std::string& name);

}  // namespace legwright::test
