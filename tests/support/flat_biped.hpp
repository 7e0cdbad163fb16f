// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "tests/support/puppy.hpp"

namespace legwright::test {

/// A biped on flat feet without a file: hinges yaw, roll, pitch, knee, ankle pitch, ankle roll in
/// each leg, bent at home with level soles. Design parameters: length of the shanks, turns of the
/// hip pitch and ankle pitch axes about z, of the ankle roll axes about y; right legs mirror left
/// ones.
/// @param toes_out at home [rad]
Puppy make_flat_biped(double toes_out = 0.0);

/// Walk of the library: 1 s, ahead at 0.05 m/s.
Task make_flat_walk(int knot_count = 24);

}  // namespace legwright::test
