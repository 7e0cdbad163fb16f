// SPDX-License-Identifier: Apache-2.0
#include "tools/validate/other_engine.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <memory>
#include <stdexcept>
#include <string>

#include "tests/tools/simulate/tiny_scene.hpp"
#include "tools/validate/measure.hpp"
#include "tools/validate/records.hpp"
#include "tools/validate/verdict.hpp"

namespace legwright {
namespace {

using Vector = Eigen::Map<const Eigen::VectorXd>;
using Frame = Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>;

/// The forces of the world on the geoms of the robot, as MuJoCo has them.
std::map<int, Eigen::Vector3d> ground_forces(const mjModel& model, const mjData& data) {
  std::map<int, Eigen::Vector3d> out;
  for (int c = 0; c < data.ncon; ++c) {
    const mjContact& contact = data.contact[c];
    const bool world_first = model.geom_bodyid[contact.geom[0]] == 0;
    mjtNum force[6];
    mj_contactForce(&model, &data, c, force);
    const Eigen::Vector3d on_second =
        Frame(contact.frame).transpose() * Eigen::Map<const Eigen::Vector3d>(force);
    const int geom = contact.geom[world_first ? 1 : 0];
    out.try_emplace(geom, Eigen::Vector3d::Zero()).first->second +=
        world_first ? on_second : Eigen::Vector3d(-on_second);
  }
  return out;
}

/// MuJoCo with the plugin in the part of another engine.
EngineStepper mujoco_as_engine(const Scene& scene) {
  std::shared_ptr<mjData> data = make_data(*scene.model);
  mj_resetDataKeyframe(scene.model.get(), data.get(), scene.start_key);
  return [data, &scene](double) {
    const mjModel& model = *scene.model;
    mj_step(&model, data.get());
    EngineStep out;
    out.torque.resize(static_cast<Eigen::Index>(scene.joints.dof.size()));
    for (std::size_t k = 0; k < scene.joints.dof.size(); ++k)
      out.torque[static_cast<Eigen::Index>(k)] = data->qfrc_actuator[scene.joints.dof[k]];
    out.ground_force = ground_forces(model, *data);
    out.qpos = Vector(data->qpos, model.nq);
    out.qvel = Vector(data->qvel, model.nv);
    return out;
  };
}

Measurements measured(const Scene& scene, const EngineStepper& stepper) {
  RolloutOptions options;
  options.cycles = 5;
  if (stepper) options.step = played_by(scene, stepper);
  return measure(scene, {{0.0, 0.1}, 0.0}, {0.0, 0.1}, options);
}

/// All numbers of a roll-out.
Json numbers_of_run(const Measurements& run) {
  SceneValidation validation;
  validation.at_gains = {run};
  return json_of(metrics_by_gain(validation).front().second);
}

void expect_near(const Json& a, const Json& b, const std::string& where) {
  ASSERT_EQ(a.type(), b.type()) << where;
  if (a.is_number_float()) {
    EXPECT_NEAR(a.get<double>(), b.get<double>(), 1e-9) << where;
  } else if (a.is_structured()) {
    ASSERT_EQ(a.size(), b.size()) << where;
    for (const auto& [key, value] : a.items())
      expect_near(value, a.is_array() ? b[std::stoul(key)] : b[key], where + "." + key);
  } else {
    EXPECT_EQ(a, b) << where;
  }
}

TEST(OtherEngine, IsMeasuredAsMujocoIs) {
  TinyScene tiny;
  tiny.swinging_foot = true;
  tiny.start_qvel = "0.05 0.1 0 0 0 0.2 0";
  for (const char* cone : {"elliptic", "pyramidal"}) {
    std::string xml = tiny.xml();
    const std::string elliptic = "cone=\"elliptic\"";
    xml.replace(xml.find(elliptic), elliptic.size(), "cone=\"" + std::string(cone) + "\"");
    const Scene scene = parse_scene(xml, "tiny");
    const Json own = numbers_of_run(measured(scene, {}));
    expect_near(numbers_of_run(measured(scene, mujoco_as_engine(scene))), own, cone);
    EXPECT_GT(own["feet"][1]["slip_max_m"], 0.0);  // what is compared is there
    EXPECT_GT(own["torque_rms_Nm"], 0.0);
  }
}

TEST(OtherEngine, FeetStandByItsForcesAndServosPushByItsTorques) {
  const Scene scene = parse_scene(TinyScene{}.xml(), "tiny");
  const EngineStepper mujoco = mujoco_as_engine(scene);
  const Measurements run = measured(scene, [&](double time) {
    EngineStep step = mujoco(time);
    step.ground_force.erase(scene.foot_geom[1]);
    step.torque[0] = 0.25;
    return step;
  });
  EXPECT_TRUE(run.feet[1].contacts.empty());
  EXPECT_FALSE(run.feet[0].contacts.empty());
  EXPECT_NEAR(run.torque_rms, 0.25, 1e-12);
}

TEST(OtherEngine, ThatGivesUpHasDiverged) {
  const Scene scene = parse_scene(TinyScene{}.xml(), "tiny");
  const EngineStepper mujoco = mujoco_as_engine(scene);
  const Measurements run = measured(scene, [&](double time) {
    EngineStep step = mujoco(time);
    if (time > 0.5) step.qpos[2] = std::numeric_limits<double>::quiet_NaN();
    return step;
  });
  EXPECT_TRUE(run.diverged);
  EXPECT_NEAR(run.seconds, 0.5, 2 * TinyScene::kTimeStep);
  EXPECT_FALSE(judge({run}, {}, "wag").pass);
}

TEST(OtherEngine, OfAnotherRobotIsRefused) {
  const Scene scene = parse_scene(TinyScene{}.xml(), "tiny");
  const EngineStepper mujoco = mujoco_as_engine(scene);
  EXPECT_THROW(measured(scene,
                        [&](double time) {
                          EngineStep step = mujoco(time);
                          step.qvel.conservativeResize(3);
                          return step;
                        }),
               std::invalid_argument);
}

}  // namespace
}  // namespace legwright
