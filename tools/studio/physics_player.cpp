// SPDX-License-Identifier: Apache-2.0
#include "tools/studio/physics_player.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <exception>
#include <utility>
#include <vector>

#include "mjcf/scene/surroundings.hpp"
#include "mjcf/text/compile.hpp"
#include "plugin/planned_motion.hpp"
#include "tools/drawables/drawn_design.hpp"
#include "tools/files/base64.hpp"
#include "tools/files/json_file.hpp"
#include "tools/run/design_folder.hpp"
#include "tools/simulate/rollout.hpp"
#include "tools/simulate/scene.hpp"
#include "tools/validate/floor_friction.hpp"
#include "tools/validate/foot_touch.hpp"

namespace legwright {
namespace {

using Clock = std::chrono::steady_clock;
using Seconds = std::chrono::duration<double>;

constexpr Seconds kFrame{1.0 / 30.0};
constexpr double kMostBehind = 0.1;  // [s] after which the physics are slower than they should be

Json force_json(const Eigen::Vector3d& v) { return {v.x(), v.y(), v.z()}; }

/// The bodies of a scene in the order of the drawn model's: a payload is the scene's alone.
std::vector<int> bodies_of(const mjModel& drawn, const mjModel& scene) {
  std::vector<int> out;
  for (int body = 0; body < drawn.nbody; ++body) {
    const std::string name = name_of(drawn, mjOBJ_BODY, body);
    const int found = name.empty() ? -1 : mj_name2id(&scene, mjOBJ_BODY, name.c_str());
    out.push_back(found >= 0 ? found : std::min(body, static_cast<int>(scene.nbody) - 1));
  }
  return out;
}

}  // namespace

/// A scene that is being played.
class PhysicsPlayer::Play {
 public:
  Play(const RobotModel& robot, StatePointer state, const PhysicsSettings& settings)
      : state_(std::move(state)), settings_(settings) {
    const auto k = static_cast<std::size_t>(settings.task);
    const Objective& objective = *state_->problem->objectives.at(k);
    const DesignTexts texts =
        design_texts(robot, objective, state_->s(), state_->now->tasks.at(k).m);
    scene_ =
        parse_scene(scale_gains(texts.scene_xml, settings.stiffness, settings.damping, "the scene"),
                    "the scene", 1.0, robot.file.parent_path());
    data_ = make_data(*scene_.model);
    bodies_ = bodies_of(*drawn_model(robot, state_->s()), *scene_.model);
    for (const Footing& footing : footings(scene_)) floor_.push_back(footing.ground);
    friction_ = floor_.empty() ? 0.0 : scene_.model->geom_friction[3L * floor_.front()];
    gravity_ = Eigen::Map<const Eigen::Vector3d>(scene_.model->opt.gravity);
    way_ = objective.task().velocity;
    reset();
    apply(settings);
  }

  /// Whether this scene serves those settings, too.
  bool serves(const StatePointer& state, const PhysicsSettings& settings) const {
    return state->now == state_->now && state->problem == state_->problem &&
           settings.task == settings_.task && settings.stiffness == settings_.stiffness &&
           settings.damping == settings_.damping;
  }

  void reset() {
    const MujocoMessages messages;
    mj_resetDataKeyframe(scene_.model.get(), data_.get(), scene_.start_key);
    mj_forward(scene_.model.get(), data_.get());
    start_height_ = trunk_com_height(*scene_.model, *data_, scene_.joints.root_body);
    fall_.reset();
  }

  /// Goes on from where another body of the same robot is, in its place and pose.
  void go_on_from(const Play& before) {
    if (before.scene_.model->nq != scene_.model->nq ||
        before.scene_.trajectory.period != scene_.trajectory.period || before.fall_)
      return;
    const MujocoMessages messages;
    data_->time = before.data_->time;
    std::copy_n(before.data_->qpos, scene_.model->nq, data_->qpos);
    std::copy_n(before.data_->qvel, scene_.model->nv, data_->qvel);
    mj_forward(scene_.model.get(), data_.get());
  }

  void apply(const PhysicsSettings& settings) {
    if (settings.reset != settings_.reset) reset();
    settings_ = settings;
    mjModel& model = *scene_.model;
    for (const int geom : floor_)
      model.geom_friction[3L * geom] = settings.friction.value_or(friction_);
    Eigen::Vector3d gravity = gravity_;
    if (settings.slope)
      gravity = -gravity_.norm() * up_on_slope(way_, (*settings.slope)[0], (*settings.slope)[1]);
    Eigen::Map<Eigen::Vector3d>(model.opt.gravity) = gravity;
  }

  void step() {
    mjModel& model = *scene_.model;
    const MujocoMessages messages;
    std::fill_n(data_->qfrc_applied, model.nv, 0.0);
    if (settings_.push.body > 0) push(settings_.push);  // the world stays where it is
    mj_step(&model, data_.get());
    if (!fall_) fall_ = find_fall(scene_, *data_, data_->time, start_height_, FallLimits());
  }

  double time() const { return data_->time; }
  bool diverged() const { return Health::diverged(*data_); }

  Json json(double reached_speed) const {
    std::vector<float> poses;
    for (const int body : bodies_) {
      for (int k = 0; k < 3; ++k) poses.push_back(static_cast<float>(data_->xpos[3 * body + k]));
      for (int k = 0; k < 4; ++k) poses.push_back(static_cast<float>(data_->xquat[4 * body + k]));
    }
    std::vector<FootTouch> touches;
    read_foot_touches(scene_, *data_, touches);
    const PlannedMotion planned(scene_.trajectory);
    const SplinePhase phase = phase_at(scene_.trajectory, data_->time + scene_.t0);
    Json feet = Json::array();
    for (std::size_t foot = 0; foot < touches.size(); ++foot) {
      const Point wanted = planned.force(phase, static_cast<int>(foot));
      const int geom = scene_.foot_geom[foot];
      feet.push_back({{"name", scene_.trajectory.foot_names[foot]},
                      {"at", force_json(foot_position(*scene_.model, *data_, geom))},
                      {"force", force_json(touches[foot].force)},
                      {"planned", {wanted[0], wanted[1], wanted[2]}},
                      {"slip", touches[foot].slip_speed}});
    }
    const Eigen::Vector3d up = up_of(*scene_.model);
    return {{"running", settings_.run},
            {"up", force_json(up)},
            {"task", settings_.task},
            {"time", data_->time},
            {"phase", std::fmod((data_->time + scene_.t0) / scene_.trajectory.period, 1.0)},
            {"poses", base64_of(poses)},
            {"feet", feet},
            {"speed", reached_speed},
            {"fell", fall_ ? Json{{"time", fall_->time}, {"words", fall_->cause}} : Json(nullptr)}};
  }

 private:
  void push(const PhysicsPush& push) {
    const int body = bodies_[static_cast<std::size_t>(
        std::min(push.body, static_cast<int>(bodies_.size()) - 1))];
    const Eigen::Matrix<double, 3, 3, Eigen::RowMajor> turned =
        Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(data_->xmat + 9L * body);
    const Eigen::Vector3d at =
        Eigen::Map<const Eigen::Vector3d>(data_->xpos + 3L * body) + turned * push.point;
    const Eigen::Vector3d none = Eigen::Vector3d::Zero();
    mj_applyFT(scene_.model.get(), data_.get(), push.force.data(), none.data(), at.data(), body,
               data_->qfrc_applied);
  }

  StatePointer state_;
  PhysicsSettings settings_;
  Scene scene_;
  DataPointer data_;
  std::vector<int> bodies_, floor_;
  double friction_ = 0.0, start_height_ = 0.0;
  Eigen::Vector3d gravity_;
  Eigen::Vector2d way_;
  std::optional<Fall> fall_;
};

PhysicsPlayer::PhysicsPlayer(RobotModel robot, EventHub& hub)
    : robot_(std::move(robot)), hub_(hub), thread_([this] { run(); }) {}

PhysicsPlayer::~PhysicsPlayer() { close(); }

void PhysicsPlayer::close() {
  {
    const std::lock_guard lock(mutex_);
    closing_ = true;
  }
  changed_.notify_all();
  if (thread_.joinable()) thread_.join();
}

void PhysicsPlayer::set(const PhysicsSettings& settings) {
  {
    const std::lock_guard lock(mutex_);
    settings_ = settings;
  }
  changed_.notify_all();
}

PhysicsSettings PhysicsPlayer::settings() const {
  const std::lock_guard lock(mutex_);
  return settings_;
}

void PhysicsPlayer::show(const StatePointer& state) {
  if (!state->settled()) return;
  {
    const std::lock_guard lock(mutex_);
    state_ = state;
  }
  changed_.notify_all();
}

/// What is due and what was done, in simulated and in real time.
class PhysicsPlayer::Pacing {
 public:
  void restart() { *this = Pacing(); }

  /// Plays until simulated time has caught up, but no longer than a frame.
  void advance(Play& play, double speed) {
    const auto now = Clock::now();
    due_ = std::min(due_ + speed * Seconds(now - last_).count(), kMostBehind);
    last_ = now;
    const double from = play.time();
    while (play.time() - from < due_ && !play.diverged() && Clock::now() - now < kFrame)
      play.step();
    const double done = play.time() - from;
    due_ = std::max(0.0, due_ - done);
    done_ += done;
  }

  bool told() const { return frames_ > 0; }
  /// Simulated over real time since the last frame, once another one is due.
  std::optional<double> frame() {
    const auto now = Clock::now();
    if (now - told_ < kFrame) return std::nullopt;
    const double speed = done_ / Seconds(now - told_).count();
    told_ = now;
    done_ = 0.0;
    ++frames_;
    return speed;
  }

 private:
  Clock::time_point last_ = Clock::now(), told_ = last_;
  double due_ = 0.0, done_ = 0.0;  // [s]
  int frames_ = 0;                 // since it began
};

/// What is to be played now; nothing once it is over. Waits until there is something.
std::optional<PhysicsPlayer::Asked> PhysicsPlayer::asked(const StatePointer& refused,
                                                         Pacing& pacing) {
  std::unique_lock lock(mutex_);
  const auto ready = [&] { return settings_.run && state_ && state_ != refused; };
  if (!ready()) {
    if (pacing.told()) hub_.publish("physics", to_line(Json{{"running", false}}));
    changed_.wait(lock, [&] { return closing_ || ready(); });
    pacing.restart();
  } else {
    changed_.wait_for(lock, std::chrono::milliseconds(4), [this] { return closing_; });
  }
  if (closing_) return std::nullopt;
  Asked out{settings_, state_};
  out.settings.task = std::clamp(out.settings.task, 0, state_->problem->task_count() - 1);
  return out;
}

void PhysicsPlayer::run() {
  std::unique_ptr<Play> play;
  StatePointer refused;  // a body whose scene cannot be played
  Pacing pacing;
  while (const auto now = asked(refused, pacing)) {
    try {
      if (!play || !play->serves(now->state, now->settings)) {
        auto next = std::make_unique<Play>(robot_, now->state, now->settings);
        if (play) next->go_on_from(*play);
        play = std::move(next);
        pacing.restart();
      }
      play->apply(now->settings);
      pacing.advance(*play, now->settings.speed);
      if (const auto speed = pacing.frame()) hub_.publish("physics", to_line(play->json(*speed)));
      if (play->diverged()) {
        hub_.notice("error", "The simulation flew apart: it starts anew.");
        play->reset();
      }
    } catch (const std::exception& error) {
      hub_.notice("error", std::string("The physics cannot be played: ") + error.what());
      play.reset();
      refused = now->state;
    }
  }
}

}  // namespace legwright
