// SPDX-License-Identifier: Apache-2.0
#include "tools/validate/validation.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "optimizer/base/parallel.hpp"
#include "tools/simulate/mujoco_host.hpp"

namespace legwright {
namespace {

std::string name_of(const mjModel& model, int joint) {
  const char* name = mj_id2name(&model, mjOBJ_JOINT, joint);
  return name != nullptr && *name != '\0' ? name : fmt::format("joint{}", joint);
}

std::vector<std::string> qpos_names(const mjModel& model) {
  std::vector<std::string> names;
  for (int j = 0; j < model.njnt; ++j) {
    const std::string name = name_of(model, j);
    switch (model.jnt_type[j]) {
      case mjJNT_FREE:
        for (const char* part : {"x_m", "y_m", "z_m", "qw", "qx", "qy", "qz"})
          names.push_back(name + "_" + part);
        break;
      case mjJNT_BALL:
        for (const char* part : {"qw", "qx", "qy", "qz"}) names.push_back(name + "_" + part);
        break;
      default:
        names.push_back(name + (model.jnt_type[j] == mjJNT_SLIDE ? "_m" : "_rad"));
    }
  }
  return names;
}

struct RolloutJob {
  const Scene* scene;
  const SceneToValidate* what;
  SceneValidation* out;
  std::size_t gain;
};

void run(const RolloutJob& job, const WantedMotion& wanted, const ValidationOptions& options) {
  RolloutOptions play;
  play.cycles = options.cycles;
  play.frame_interval = options.frame_interval;
  const bool record = job.scene->gain_scale == 1.0;
  play.frame_until = record ? options.frames_until : 0.0;
  Rollout played;
  std::optional<ComparisonWatch> watch;
  if (record) watch.emplace(*job.scene, wanted);
  job.out->at_gains[job.gain] =
      measure(*job.scene, wanted, job.what->plan_velocity, play,
              {.contacts_until = options.frames_until}, &played, [&](const RolloutSample& sample) {
                if (watch) watch->observe(sample);
              });
  if (record) job.out->frames = std::move(played.frames);
  if (watch) job.out->comparison = watch->finish(job.out->at_gains[job.gain]);
}

/// Throws MujocoError where the plan beside a scene is of another robot than its gait.
void check_plan(const SceneToValidate& what, const Scene& scene) {
  const std::vector<std::string>& own = scene.trajectory.joint_names;
  if (what.joints.empty() || what.joints == own) return;
  const auto [plan, gait] =
      std::mismatch(what.joints.begin(), what.joints.end(), own.begin(), own.end());
  const auto named = [](const auto& at, const auto& all) {
    return at == all.end() ? std::string("no more") : "'" + *at + "'";
  };
  throw MujocoError(fmt::format(
      "{}: is not the motion of the scene beside it: of the joints that they move, number {} is {} "
      "in one and {} in the other; run `legwright optimize` again",
      (what.scene.parent_path() / "motion.csv").string(), plan - what.joints.begin() + 1,
      named(plan, what.joints), named(gait, own)));
}

}  // namespace

std::vector<SceneValidation> validate_scenes(const std::vector<SceneToValidate>& scenes,
                                             const WantedMotion& wanted, const std::string& gait,
                                             const ValidationOptions& options) {
  const std::size_t gains = options.gain_scales.size();
  std::vector<SceneValidation> out(scenes.size());
  std::vector<Scene> loaded;
  loaded.reserve(scenes.size() * gains);
  std::vector<RolloutJob> jobs;
  for (std::size_t i = 0; i < scenes.size(); ++i) {
    out[i].at_gains.resize(gains);
    for (std::size_t g = 0; g < gains; ++g) {
      loaded.push_back(load_scene(scenes[i].scene, options.gain_scales[g]));
      check_plan(scenes[i], loaded.back());
      jobs.push_back({&loaded.back(), &scenes[i], &out[i], g});
    }
    if (gains == 0) continue;
    const Scene& scene = loaded.back();
    out[i].qpos_names = qpos_names(*scene.model);
    out[i].timestep = scene.model->opt.timestep;
    out[i].never_touch = links_that_never_touch(*scene.model, scene.joints.root_body);
    out[i].links = link_count(*scene.model, scene.joints.root_body);
    out[i].robot_mass = scene.model->body_subtreemass[scene.joints.root_body];
  }
  // Each job has its own place for its result, so that the order of execution leaves no trace.
  StageProgress progress(options.progress, "roll-outs", static_cast<int>(jobs.size()));
  parallel_for(static_cast<int>(jobs.size()), options.threads, [&](int k) {
    run(jobs[static_cast<std::size_t>(k)], wanted, options);
    progress.one_more();
  });
  for (auto& validation : out)
    validation.verdict = judge(validation.at_gains, wanted, gait, options.limits);
  return out;
}

std::optional<Measurements> at_default_gains(const SceneValidation& validation) {
  for (const auto& run : validation.at_gains)
    if (run.gain_scale == 1.0) return run;
  return std::nullopt;
}

std::string playback_csv(const SceneValidation& validation) {
  std::string out = "time_s";
  for (const auto& name : validation.qpos_names) out += "," + name;
  for (const auto& frame : validation.frames) {
    out += fmt::format("\n{}", frame.time);
    for (const double value : frame.qpos) out += fmt::format(",{}", value);
  }
  return out + "\n";
}

}  // namespace legwright
