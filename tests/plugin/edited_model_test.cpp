// SPDX-License-Identifier: Apache-2.0
// Models that are edited after they were compiled, as domain randomisation does: the host lives,
// is told once, and plays on without the plugin.
#include <algorithm>
#include <cmath>
#include <iterator>

#include "tests/plugin/engine.hpp"
#include "tests/plugin/toy_trajectory.hpp"

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
    if (m->actuator_trnid[0] < 0 || m->actuator_trnid[0] >= m->njnt ||
        m->jnt_type[2] == mjJNT_SLIDE)
      continue;  // the engine itself cannot step these
    EXPECT_EQ(largest_force(m.get(), first.get()), 0.0);
    mj_resetData(m.get(), first.get());
    const DataPointer copy(mj_copyData(nullptr, m.get(), first.get()));
    EXPECT_TRUE(copy);
  }
}

TEST_F(EditedModelTest, PlaysAgainOnceTheEditIsTakenBack) {
  const ModelPointer m = fresh_chain(99);
  ASSERT_TRUE(m);
  m->actuator_gear[0] = 2.0;
  DataPointer d(mj_makeData(m.get()));
  EXPECT_EQ(largest_force(m.get(), d.get()), 0.0);
  EXPECT_EQ(take_warnings().size(), 1u);
  m->actuator_gear[0] = 1.0;
  d.reset(mj_makeData(m.get()));
  EXPECT_GT(largest_force(m.get(), d.get()), 0.0);
}

}  // namespace
}  // namespace legwright
