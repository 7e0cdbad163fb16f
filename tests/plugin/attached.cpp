// SPDX-License-Identifier: Apache-2.0
#include "tests/plugin/attached.hpp"

namespace legwright {
namespace {

SpecPointer parse_spec(const std::string& xml) {
  char error[1024] = "";
  SpecPointer spec(mj_parseXMLString(xml.c_str(), nullptr, error, sizeof error));
  EXPECT_TRUE(spec) << error;
  return spec;
}

SpecPointer empty_world() {
  return parse_spec(R"(<mujoco><compiler angle="radian" autolimits="true"/><size memory="500K"/>
                       <option integrator="implicitfast" timestep="0.001"/></mujoco>)");
}

void attach_to(mjSpec* world, const mjSpec* child, const Attached& robot) {
  mjsFrame* const frame = mjs_addFrame(mjs_findBody(world, "world"), nullptr);
  EXPECT_TRUE(
      mjs_attach(frame->element, child->element, robot.prefix.c_str(), robot.suffix.c_str()))
      << mjs_getError(world);
}

}  // namespace

Loaded attach(const std::vector<Attached>& robots, const std::string& outer) {
  SpecPointer spec = empty_world();
  for (const Attached& robot : robots) {
    const SpecPointer child = parse_spec(robot.xml);
    attach_to(spec.get(), child.get(), robot);
  }
  if (!outer.empty()) {
    const SpecPointer child = std::move(spec);
    // Keyframes get the outer prefix only in a world that is compiled.
    const ModelPointer compiled(mj_compile(child.get(), nullptr));
    EXPECT_TRUE(compiled) << mjs_getError(child.get());
    spec = empty_world();
    attach_to(spec.get(), child.get(), {"", outer, ""});
  }
  ModelPointer model(mj_compile(spec.get(), nullptr));
  if (model) return {std::move(model), ""};
  return {nullptr, mjs_getError(spec.get())};
}

}  // namespace legwright
