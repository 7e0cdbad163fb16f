// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace legwright::test {

/// A linear actuator of which every figure is given; its rod is told first.
inline const std::string kWholeLinear = R"(name = "LA-1"
kind = "linear"
maker = "somebody"
mass = 0.056
voltage = 6.0

[[outline]]
shape = "cylinder"
size = [0.004, 0.02]
position = [0.0, 0.0, 0.11]
on = "rod"

[[outline]]
shape = "box"
size = [0.018, 0.02, 0.1]
position = [0.0, 0.0, 0.05]

[slide]
position = [0.0, 0.0, 0.0]
axis = [0.0, 0.0, 2.0]
retracted_length = 0.12
stroke = 0.05
max_force = 50.0
stall_force = 100.0
continuous_force = 20.0
no_load_speed = 0.032
backdrive_force = 31.0
gear_ratio = 35.0
reflected_mass = 90.0
kp = 80000.0
kd = 1000.0

[[attachment]]
name = "end"
on = "rod"
position = [0.0, 0.0, 0.12]
normal = [0, 0, 1]
screws = "M3"
holes = [0.0, 0.0, 0.12]

[[source]]
title = "data sheet"
address = "https://maker.example/la1.pdf"
figures = ["mass", "voltage", "outline", "slide.retracted_length", "slide.stroke",
           "slide.max_force", "slide.stall_force", "slide.continuous_force", "slide.no_load_speed",
           "slide.backdrive_force", "slide.gear_ratio", "slide.reflected_mass", "slide.kp",
           "slide.kd", "attachment.screws"]

[[assumption]]
figures = ["slide.position"]
why = "the middle of the hole"
)";

}  // namespace legwright::test
