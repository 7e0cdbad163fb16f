// SPDX-License-Identifier: Apache-2.0
// What the plugin adds to a viewer's scene, without a screen: mjv_ functions need no OpenGL.
#include <algorithm>
#include <cmath>

#include "plugin/planned_motion.hpp"
#include "tests/plugin/allocation_count.hpp"
#include "tests/plugin/engine.hpp"
#include "tests/plugin/walker.hpp"

namespace legwright {
namespace {

constexpr int kGhostGroup = 5;

class VisualizeTest : public EngineTest {
 protected:
  void SetUp() override {
    EngineTest::SetUp();
    make(WalkerOptions());
  }
  void TearDown() override {
    mjv_freeScene(&scene_);
    EngineTest::TearDown();
  }
  void make(const WalkerOptions& options, int room = 2000) {
    data_.reset();
    Loaded loaded = load(walker(options));
    ASSERT_TRUE(loaded.model) << loaded.error;
    model_ = std::move(loaded.model);
    data_.reset(mj_makeData(model_.get()));
    mj_forward(model_.get(), data_.get());
    mjv_freeScene(&scene_);
    mjv_makeScene(model_.get(), &scene_, room);
    mjv_defaultOption(&option_);
  }
  /// Number of geoms in the scene.
  int draw() {
    mjvCamera camera;
    mjv_defaultFreeCamera(model_.get(), &camera);
    mjv_updateScene(model_.get(), data_.get(), &option_, nullptr, &camera, mjCAT_ALL, &scene_);
    return scene_.ngeom;
  }
  /// Geoms that the plugin added: what is there beyond the same scene without the plugin.
  std::vector<mjvGeom> added() {
    draw();
    const std::vector<mjvGeom> all(scene_.geoms, scene_.geoms + scene_.ngeom);
    const auto first_of_model = std::find_if(
        all.begin(), all.end(), [](const mjvGeom& g) { return g.objtype == mjOBJ_GEOM; });
    return {all.begin(), first_of_model};  // plugins draw first
  }

  ModelPointer model_;
  DataPointer data_;
  mjvOption option_{};
  mjvScene scene_ = [] {
    mjvScene scene;
    mjv_defaultScene(&scene);
    return scene;
  }();
};

TEST_F(VisualizeTest, DefaultViewShowsTheRobotOnly) {
  EXPECT_EQ(draw(), model_->ngeom);
  EXPECT_TRUE(added().empty());
}

TEST_F(VisualizeTest, ResetShowsWhatTheModelIsThen) {
  option_.geomgroup[kGhostGroup] = option_.flags[mjVIS_COM] = 1;
  const std::size_t shown = added().size();
  ASSERT_GT(shown, 0u);
  const mjtNum half_width = model_->geom_size[3 * 1];
  model_->geom_size[3 * 1] *= 2.0;  // of the trunk, and so of its ghost
  mj_resetData(model_.get(), data_.get());
  mj_forward(model_.get(), data_.get());
  const std::vector<mjvGeom> wide = added();
  EXPECT_EQ(wide.size(), shown);
  EXPECT_TRUE(std::any_of(wide.begin(), wide.end(), [&](const mjvGeom& g) {
    return g.type == mjGEOM_BOX && g.size[0] == static_cast<float>(2.0 * half_width);
  }));
  model_->actuator_gear[0] = 0.7;
  mj_resetData(model_.get(), data_.get());
  mj_forward(model_.get(), data_.get());
  EXPECT_TRUE(added().empty());
  EXPECT_EQ(take_warnings().size(), 1u);
}

TEST_F(VisualizeTest, EachSwitchAddsDecorationOfItsOwn) {
  const auto add = [&](mjtByte& flag) {
    flag = 1;
    const std::vector<mjvGeom> geoms = added();
    flag = 0;
    for (const mjvGeom& g : geoms) {
      EXPECT_EQ(g.category, mjCAT_DECOR);
      EXPECT_EQ(g.objtype, mjOBJ_UNKNOWN);
      EXPECT_EQ(g.objid, -1);
      EXPECT_EQ(g.segid, -1);
      EXPECT_LT(g.rgba[3], 1.0F);
      EXPECT_EQ(g.transparent, 1);
      EXPECT_EQ(g.matid, -1);
    }
    return geoms.size();
  };
  EXPECT_EQ(add(option_.geomgroup[kGhostGroup]), 5u);  // all geoms of the robot, not the floor
  EXPECT_EQ(add(option_.flags[mjVIS_COM]), 65u);       // a ball and a path of two cycles
  EXPECT_GT(add(option_.flags[mjVIS_CONTACTPOINT]), 64u);
  EXPECT_EQ(add(option_.flags[mjVIS_CONTACTFORCE]), 2u);
  EXPECT_EQ(add(option_.flags[mjVIS_TRANSPARENT]), 0u);  // negative control
  EXPECT_TRUE(added().empty());
}

TEST_F(VisualizeTest, GhostStandsWhereThePlanIs) {
  option_.geomgroup[kGhostGroup] = 1;
  const Trajectory t = walker_trajectory();
  const DataPointer plan(mj_makeData(model_.get()));
  for (const double time : {0.0, 0.47, 9.1}) {
    data_->time = time;
    mj_forward(model_.get(), data_.get());
    const Pose root = PlannedMotion(t).root(phase_at(t, time));
    std::copy(root.position.begin(), root.position.end(), plan->qpos);
    std::copy(root.quaternion.begin(), root.quaternion.end(), plan->qpos + 3);
    TrajectorySample sampled;
    sample(t, time, sampled);
    std::copy(sampled.target.begin(), sampled.target.end(), plan->qpos + 7);
    mj_kinematics(model_.get(), plan.get());
    const std::vector<mjvGeom> ghost = added();
    ASSERT_EQ(ghost.size(), 5u);
    for (std::size_t g = 0; g < ghost.size(); ++g) {
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const std::size_t at = 3 * (g + 1) + axis;  // geom 0 is the floor
        EXPECT_NEAR(ghost[g].pos[axis], plan->geom_xpos[at], 1e-5);
      }
    }
    if (time > 9.0) {  // the robot stayed at home
      EXPECT_GT(std::abs(ghost[0].pos[0] - data_->geom_xpos[3]), 0.1);
    }
  }
}

TEST_F(VisualizeTest, GhostFollowsTheGroupsOfTheViewerAndItsOwn) {
  WalkerOptions options;
  options.config = R"(<config key="ghost_group" value="2"/>)";
  make(options);
  EXPECT_EQ(added().size(), 5u);  // group 2 is on from the start
  option_.geomgroup[2] = 0;
  EXPECT_TRUE(added().empty());
  option_.geomgroup[2] = 1;
  option_.geomgroup[0] = 0;  // robots' geoms are of this one
  draw();
  EXPECT_EQ(scene_.ngeom, 0);
}

TEST_F(VisualizeTest, ForcesStandAtTheFeetToTheScaleOfMujocos) {
  option_.flags[mjVIS_CONTACTFORCE] = 1;
  data_->qpos[2] = 0.219;
  data_->time = 0.31;
  mj_forward(model_.get(), data_.get());
  const std::vector<mjvGeom> arrows = added();
  ASSERT_EQ(arrows.size(), 2u);
  const Trajectory t = walker_trajectory();
  for (int foot = 0; foot < 2; ++foot) {
    const mjvGeom& arrow = arrows[static_cast<std::size_t>(foot)];
    const mjtNum* const at =
        data_->geom_xpos + 3 * mj_name2id(model_.get(), mjOBJ_GEOM, foot == 0 ? "A" : "B");
    EXPECT_NEAR(arrow.pos[0], at[0], 1e-4);
    EXPECT_NEAR(arrow.pos[2], 0.0, 2e-3);  // where it touches
    const Point force = PlannedMotion(t).force(phase_at(t, 0.31), foot);
    const double newtons = std::hypot(force[0], force[1], force[2]);
    EXPECT_NEAR(arrow.mat[2] * newtons, force[0], 1e-4);
    EXPECT_NEAR(arrow.mat[8] * newtons, force[2], 1e-4);
    const double metres = newtons * model_->vis.map.force / model_->stat.meanmass;
    EXPECT_NEAR(arrow.size[2], metres, 1e-4 * metres);
  }
}

TEST_F(VisualizeTest, PathsPassThroughThePlan) {
  option_.flags[mjVIS_COM] = 1;
  const Trajectory t = walker_trajectory();
  data_->time = 3.0;
  const std::vector<mjvGeom> path = added();
  const Point now = PlannedMotion(t).com(phase_at(t, 3.0));
  EXPECT_NEAR(path[0].pos[0], now[0], 1e-6);  // the ball
  EXPECT_NEAR(path[0].pos[1], now[1], 1e-6);
  const auto nearest = [&](double time) {
    const Point p = PlannedMotion(t).com(phase_at(t, time));
    double best = 1e9;
    for (std::size_t g = 1; g < path.size(); ++g)
      best = std::min(
          best, std::hypot(path[g].pos[0] - p[0], path[g].pos[1] - p[1], path[g].pos[2] - p[2]));
    return best;
  };
  for (double time = 2.3; time < 3.75; time += 0.05) EXPECT_LT(nearest(time), 0.05) << time;
  EXPECT_GT(nearest(6.0), 0.1);  // negative control: not drawn there
}

TEST_F(VisualizeTest, FeetThatTheModelLacksAreDrawnInThePlan) {
  WalkerOptions options;
  options.foot_a = "";
  make(options);
  option_.flags[mjVIS_CONTACTFORCE] = option_.flags[mjVIS_CONTACTPOINT] = 1;
  EXPECT_GT(added().size(), 64u);
}

TEST_F(VisualizeTest, FixedRobotHasAGhostToo) {
  WalkerOptions options;
  options.trunk_joint = "";
  make(options);
  option_.geomgroup[kGhostGroup] = 1;
  const std::vector<mjvGeom> ghost = added();
  ASSERT_EQ(ghost.size(), 4u);  // its trunk is part of the world
  EXPECT_GT(std::abs(ghost[0].pos[0] - data_->geom_xpos[6]), 1e-3);
}

TEST_F(VisualizeTest, FullScenesAreRespected) {
  for (const int room : {1, 3, 7, 40}) {
    make(WalkerOptions(), room);
    std::fill_n(option_.flags, mjNVISFLAG, mjtByte{1});
    std::fill_n(option_.geomgroup, mjNGROUP, mjtByte{1});
    draw();
    EXPECT_LE(scene_.ngeom, room);
    take_warnings();  // MuJoCo's own, of its own geoms
  }
}

TEST_F(VisualizeTest, FramesAfterTheFirstAllocateNothingInThePlugin) {
  option_.geomgroup[kGhostGroup] = 1;
  for (const int flag : {mjVIS_COM, mjVIS_CONTACTPOINT, mjVIS_CONTACTFORCE})
    option_.flags[flag] = 1;
  const long at_first = allocation_count();
  const int geoms = draw();
  EXPECT_GT(allocation_count(), at_first);  // the counter sees the ghost being made
  const long before = allocation_count();
  for (int i = 0; i < 50; ++i) EXPECT_EQ(draw(), geoms);
  EXPECT_EQ(allocation_count(), before);
}

TEST_F(VisualizeTest, DrawingLeavesTheSimulationAlone) {
  const DataPointer twin(mj_makeData(model_.get()));
  mj_forward(model_.get(), twin.get());
  option_.geomgroup[kGhostGroup] = 1;
  option_.flags[mjVIS_COM] = option_.flags[mjVIS_CONTACTFORCE] = 1;
  for (int i = 0; i < 200; ++i) {
    mj_step(model_.get(), data_.get());
    mj_step(model_.get(), twin.get());
    if (i % 10 == 0) draw();
  }
  for (int q = 0; q < model_->nq; ++q) EXPECT_EQ(data_->qpos[q], twin->qpos[q]);
  // A copy draws by itself, and deleting the one whose ghost was shown leaves it whole.
  data_.reset(mj_copyData(nullptr, model_.get(), data_.get()));
  EXPECT_GT(added().size(), 60u);
}

}  // namespace
}  // namespace legwright
