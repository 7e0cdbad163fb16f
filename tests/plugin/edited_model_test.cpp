// SPDX-License-Identifier: Apache-2.0
// Models that are edited after they were compiled, as domain randomisation does: the host lives,
// is told once, and plays on without the plugin; new data and data that is reset do alike.
#include <algorithm>
#include <cmath>
#include <iterator>

#include "tests/plugin/engine.hpp"
#include "tests/plugin/toy_trajectory.hpp"
#include "tests/plugin/walker.hpp"

namespace legwright {
namespace {

class EditedModelTest : public EngineTest {};

struct Edit {
  const char* what;
  void (*edit)(mjModel&);
  const char* reason;  // nullptr: the model may be played so
};

const Edit kEdits[] = {
    {"gear", [](mjModel& m) { m.actuator_gear[0] = 2.0; }, "gear = 2, expected 1"},
    {"biasprm", [](mjModel& m) { m.actuator_biasprm[1] *= 1.1; }, "biasprm \"0 -4.4 -0.1\""},
    {"biastype", [](mjModel& m) { m.actuator_biastype[1] = mjBIAS_NONE; }, "no affine bias"},
    {"trnid", [](mjModel& m) { m.actuator_trnid[0] = 0; }, "is driven by actuator"},
    {"trnid beyond all", [](mjModel& m) { m.actuator_trnid[0] = 1 << 20; }, "trnid = 1048576"},
    {"trnid below all", [](mjModel& m) { m.actuator_trnid[0] = -1; }, "trnid = -1"},
    {"trntype", [](mjModel& m) { m.actuator_trntype[0] = mjTRN_BODY; }, "expected joint="},
    {"joint type", [](mjModel& m) { m.jnt_type[2] = mjJNT_SLIDE; }, "joint \"c\" is a slide"},
    {"delay", [](mjModel& m) { m.actuator_delay[2] = 0.01; }, "has a delay"},
    {"mass", [](mjModel& m) { m.body_mass[1] *= 1.3; }, nullptr},
    {"damping", [](mjModel& m) { m.dof_damping[0] = 0.01; }, nullptr},
    {"friction", [](mjModel& m) { m.geom_friction[0] = 0.3; }, nullptr},
    {"forcerange", [](mjModel& m) { m.actuator_forcerange[1] = 0.2; }, nullptr},
    {"gravity", [](mjModel& m) { m.opt.gravity[2] = -3.7; }, nullptr},
};

/// A model of its own for each edit: what was said of one must not silence another.
ModelPointer fresh_chain(int seed) {
  ChainOptions options = valid_options();
  options.trajectory = write_trajectory(toy_trajectory(3, 1, 12, 0.6, 100 + seed, 0.4));
  return load(plugin_chain(options)).model;
}

/// Whether the engine itself can.
bool can_be_stepped(const mjModel& m) {
  return m.actuator_trnid[0] >= 0 && m.actuator_trnid[0] < m.njnt && m.jnt_type[2] != mjJNT_SLIDE;
}

double largest_force(const mjModel* m, mjData* d) {
  double largest = 0.0;
  for (int step = 0; step < 50; ++step) {
    mj_step(m, d);
    for (int out = 0; out < m->nactuator; ++out)
      largest = std::max(largest, std::abs(d->actuator_force[out]));
  }
  return largest;
}

TEST_F(EditedModelTest, GoesInertWithOneWarningAndNeverEndsTheHost) {
  for (int i = 0; i < static_cast<int>(std::size(kEdits)); ++i) {
    const Edit& edit = kEdits[i];
    SCOPED_TRACE(edit.what);
    const ModelPointer m = fresh_chain(i);
    ASSERT_TRUE(m);
    ASSERT_TRUE(take_warnings().empty());
    edit.edit(*m);
    DataPointer first, second;
    ASSERT_NO_THROW(first.reset(mj_makeData(m.get())));  // an engine's error would end the host
    ASSERT_NO_THROW(second.reset(mj_makeData(m.get())));
    const std::vector<std::string> warnings = take_warnings();
    if (edit.reason == nullptr) {
      EXPECT_TRUE(warnings.empty()) << warnings.front();
      EXPECT_GT(largest_force(m.get(), first.get()), 0.0);
      continue;
    }
    ASSERT_EQ(warnings.size(), 1u);
    EXPECT_NE(warnings[0].find(edit.reason), std::string::npos) << warnings[0];
    EXPECT_NE(warnings[0].find("changed after it was compiled"), std::string::npos) << warnings[0];
    if (!can_be_stepped(*m)) continue;
    EXPECT_EQ(largest_force(m.get(), first.get()), 0.0);
    mj_resetData(m.get(), first.get());
    const DataPointer copy(mj_copyData(nullptr, m.get(), first.get()));
    EXPECT_TRUE(copy);
  }
}

TEST_F(EditedModelTest, ReusedDataMeetsTheEditAtItsResetAsNewDataDoes) {
  for (int i = 0; i < static_cast<int>(std::size(kEdits)); ++i) {
    const Edit& edit = kEdits[i];
    SCOPED_TRACE(edit.what);
    const ModelPointer m = fresh_chain(200 + i);
    ASSERT_TRUE(m);
    const DataPointer d(mj_makeData(m.get()));
    ASSERT_GT(largest_force(m.get(), d.get()), 0.0);
    const ModelPointer unedited(mj_copyModel(nullptr, m.get()));
    edit.edit(*m);
    ASSERT_NO_THROW(mj_resetData(m.get(), d.get()));
    const std::vector<std::string> warnings = take_warnings();
    ASSERT_EQ(warnings.size(), edit.reason == nullptr ? 0u : 1u);
    if (edit.reason != nullptr) {
      EXPECT_NE(warnings[0].find(edit.reason), std::string::npos) << warnings[0];
    }
    DataPointer fresh;
    ASSERT_NO_THROW(fresh.reset(mj_makeData(m.get())));  // and no second warning
    if (can_be_stepped(*m)) {
      const std::vector<double> expected = roll_out(m.get(), fresh.get(), 50);
      EXPECT_EQ(roll_out(m.get(), d.get(), 50), expected);
      EXPECT_EQ(largest_force(m.get(), d.get()) == 0.0, edit.reason != nullptr);
    }
    mj_copyModel(m.get(), unedited.get());
    mj_resetData(m.get(), d.get());
    EXPECT_GT(largest_force(m.get(), d.get()), 0.0) << "the edit was taken back";
  }
}

/// A reset with another model of the same sizes, which may outlive the one that made the data.
TEST_F(EditedModelTest, DataMayBeResetWithACopyOfTheModel) {
  ModelPointer first = fresh_chain(400);
  const ModelPointer second(mj_copyModel(nullptr, first.get()));
  second->body_mass[1] *= 1.3;
  const DataPointer d(mj_makeData(first.get())), expected(mj_makeData(second.get()));
  first.reset();
  mj_resetData(second.get(), d.get());
  EXPECT_EQ(roll_out(second.get(), d.get(), 200), roll_out(second.get(), expected.get(), 200));
}

TEST_F(EditedModelTest, EachReasonIsToldOnceWhateverItsNumbers) {
  const ModelPointer m = fresh_chain(401);
  const DataPointer d(mj_makeData(m.get()));
  const auto told = [&](double gear, double bias) {
    m->actuator_gear[0] = gear;
    m->actuator_biasprm[1] = -bias;
    mj_resetData(m.get(), d.get());
    const DataPointer fresh(mj_makeData(m.get()));
    return take_warnings();
  };
  EXPECT_TRUE(told(1.0, 4.0).empty());
  for (const double gear : {0.7, 1e-7, -3.25, 12.0})
    EXPECT_EQ(told(gear, 4.0).size(), gear == 0.7 ? 1u : 0u) << gear;
  EXPECT_TRUE(told(1.0, 4.0).empty());
  for (const double bias : {2.0, 0.123456, -1e-9})
    EXPECT_EQ(told(1.0, bias).size(), bias == 2.0 ? 1u : 0u) << bias;
  EXPECT_TRUE(told(1.0, 4.0).empty());
  const DataPointer fresh(mj_makeData(m.get()));
  EXPECT_GT(largest_force(m.get(), fresh.get()), 0.0);
  EXPECT_GT(largest_force(m.get(), d.get()), 0.0);
}

TEST_F(EditedModelTest, SensorsMeetAnEditAtAResetToo) {
  WalkerOptions options;
  options.config += R"(<config key="speed" value="0.9"/>)";
  options.foot_a = R"(<body name="A"><geom name="sole" size="0.02" pos="0 0 -0.2"/></body>)";
  options.sensors = gait_sensor("measured_contact") + gait_sensor("phase");
  const ModelPointer m = load(walker(options)).model;
  ASSERT_TRUE(m);
  const DataPointer d(mj_makeData(m.get()));
  const auto contacts_seen = [&] {
    d->qpos[2] = 0.219;  // both feet in the floor
    mj_forward(m.get(), d.get());
    return d->sensordata[0] + d->sensordata[1];
  };
  EXPECT_EQ(contacts_seen(), 2.0);
  const int sole = mj_name2id(m.get(), mjOBJ_GEOM, "sole");
  m->geom_contype[sole] = m->geom_conaffinity[sole] = 0;
  mj_resetData(m.get(), d.get());
  const std::vector<std::string> warnings = take_warnings();
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_NE(warnings[0].find("has no geom that collides"), std::string::npos) << warnings[0];
  EXPECT_EQ(contacts_seen(), 0.0);
  EXPECT_GT(d->sensordata[2] + largest_force(m.get(), d.get()), 0.0);  // the others go on
  m->geom_contype[sole] = m->geom_conaffinity[sole] = 1;
  mj_resetData(m.get(), d.get());
  EXPECT_EQ(contacts_seen(), 2.0);
}

}  // namespace
}  // namespace legwright
