// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace legwright::test {

/// A servo of which every figure is given.
inline const std::string kWholeServo = R"(name = "HS-1"
kind = "servo"
maker = "somebody"
about = "a servo"
mass = 0.055
voltage = 6.0

[[outline]]
shape = "box"
size = [0.02, 0.04, 0.036]
position = [0.0, 0.0, 0.0]

[joint]
position = [0.0, 0.01, 0.018]
axis = [0.0, 0.0, 2.0]
stall_torque = 1.1
continuous_torque = 0.2
no_load_speed = 6.0
gear_ratio = 250.0
reflected_inertia = 0.002
friction = 0.02
damping = 0.01
range = [-1.5, 1.5]
kp = 30.0
kd = 0.4

[[attachment]]
name = "horn"
on = "horn"
position = [0.0, 0.01, 0.018]
normal = [0, 0, 1]
screws = "M2"
circle = 0.016
count = 4
turn = 0.1

[[source]]
title = "data sheet"
address = "https://maker.example/hs1.pdf"
note = "of 2020"
figures = ["mass", "voltage", "outline", "joint.stall_torque", "joint.continuous_torque",
           "joint.no_load_speed", "joint.gear_ratio", "joint.reflected_inertia", "joint.friction",
           "joint.damping", "joint.range", "joint.kp", "joint.kd", "attachment.screws"]

[[assumption]]
figures = ["joint.position"]
why = "half the width from the end"
)";

}  // namespace legwright::test
