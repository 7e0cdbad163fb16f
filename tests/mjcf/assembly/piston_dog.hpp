// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tests/mjcf/assembly/boxy_dog.hpp"

namespace legwright::test {

/// A body of 0.1 m behind its pivot and a rod that comes 50 mm out of it.
inline Module linear_module() {
  Module out = box_module("A", ModuleKind::linear, 0.06, {0.02, 0.024, 0.1});
  out.outline[0].position = {0.0, 0.002, 0.05};
  OutlineShape rod;
  rod.type = OutlineShape::Type::cylinder;
  rod.size = {0.004, 0.02, 0.0};
  rod.position = {0.0, 0.0, 0.11};
  rod.on_rod = true;
  out.outline.push_back(rod);
  ModuleSlide slide;
  slide.retracted = 0.12;
  slide.stroke = 0.05;
  slide.most_force = 60.0;
  slide.stall_force = 100.0;
  slide.no_load_speed = 0.05;
  out.slide = slide;
  return out;
}

/// The dog with bent legs, whose knees are turned by linear actuators at their default pivots.
inline Assembly piston_dog() {
  Assembly out = boxy_dog();
  AssemblyLimb& leg = out.limbs[0];
  leg.joints[1].servo = linear_module();
  leg.joints[1].offset = {-0.05, 0.0, -0.08};
  leg.foot_offset = {0.05, 0.0, -0.08};
  return out;
}

}  // namespace legwright::test
