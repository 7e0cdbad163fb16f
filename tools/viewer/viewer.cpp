// SPDX-License-Identifier: Apache-2.0
#include "tools/viewer/viewer.hpp"
#include "tools/files/clean_text.hpp"

#include <fmt/format.h>
#include <simulate.h>

#include <array>
#include <chrono>
#include <cmath>
#include <exception>
#include <numbers>
#include <thread>

#include "tools/simulate/mujoco_host.hpp"
#include "tools/viewer/follow.hpp"
#include "tools/viewer/message_lines.hpp"
#include "tools/viewer/pace.hpp"
#include "tools/viewer/window.hpp"

namespace legwright {
namespace {

namespace fs = std::filesystem;
using Lock = std::unique_lock<std::recursive_mutex>;
using Clock = std::chrono::steady_clock;

constexpr const char* kStartKey = "gait";  // where the emitted scenes have the first pose
constexpr int kGhostGroup = 5;             // of geoms, whose switch shows the plugin's ghost
constexpr const char* kResult = "the run has ended; this is its result";
constexpr const char* kNoResult = "the run has ended without a result; this is its last design";
constexpr auto kPollInterval = std::chrono::milliseconds(100);
constexpr int kRoomForBothPanels = 1000;  // [px] of window; with less, the right one starts hidden

/// Two threads: this one draws (window systems want the first), the other loads and steps.
class Session {
 public:
  explicit Session(const ViewerOptions& options)
      : options_(options),
        follower_(options.path),
        viewer_(make_window(), &camera_, &shown_, &push_, /* is_passive= */ false) {}

  void run();

 private:
  std::unique_ptr<Window> make_window() {
    auto window = std::make_unique<Window>([this] { before_frame(); });
    window_ = window.get();
    return window;
  }
  void before_frame();
  void aim_camera();
  void start_anew();
  void set_up();
  void show_panels(bool shown);

  void work();
  void handle_requests();
  void follow();
  void step();
  bool load(const fs::path& scene, const std::vector<Fact>& facts);
  void show_message(const std::string& message);

  const ViewerOptions& options_;
  RunFollower follower_;
  mjvCamera camera_{};
  mjvOption shown_{};
  mjvPerturb push_{};
  Window* window_ = nullptr;  // owned by the viewer
  mujoco::Simulate viewer_;
  ModelPointer model_;  // of the second thread
  DataPointer data_;
  fs::path scene_;  // what model_ was made of
  Pace pace_;
  Clock::time_point last_poll_{};
  bool result_shown_ = false;
  std::string state_;  // of the run that is followed, as last reported
  std::exception_ptr failure_;
  std::atomic<bool> working_ = true;
  // Under the viewer's lock:
  std::string message_;
  std::vector<Fact> facts_;
  bool message_changed_ = false;
  bool set_up_ = false, view_done_ = false;
};

int start_key(const mjModel& model) { return mj_name2id(&model, mjOBJ_KEY, kStartKey); }

/// From the scene's tracking camera's side, if it has one, about the robot that it tracks.
void Session::aim_camera() {
  const mjModel& model = *viewer_.m_;
  for (int body = 1; body < model.nbody; ++body) {
    const int joint = model.body_jntadr[body];
    if (joint < 0 || model.jnt_type[joint] != mjJNT_FREE) continue;
    camera_.type = mjCAMERA_TRACKING;
    camera_.trackbodyid = body;
    camera_.fixedcamid = -1;
    camera_.distance = 2.0 * model.stat.extent;
    camera_.azimuth = 160.0;
    camera_.elevation = -17.0;
    if (model.ncam > 0) {  // pictures and viewer show the robot from the same side
      const mjtNum* z = viewer_.d_->cam_xmat;  // its third column points at whoever looks
      const double x_C = z[2], y_C = z[5], z_C = z[8], degrees = 180.0 / std::numbers::pi;
      camera_.azimuth = std::atan2(-y_C, -x_C) * degrees;
      camera_.elevation = -std::asin(std::clamp(z_C, -1.0, 1.0)) * degrees;
    }
    return;
  }
}

/// What Reset means here: MuJoCo's own would drop a robot with straight legs into the gait.
void Session::start_anew() {
  const int key = viewer_.m_ ? start_key(*viewer_.m_) : -1;
  if (key < 0) return;
  viewer_.pending_.reset = false;
  viewer_.key = key;
  viewer_.pending_.load_key = true;
  viewer_.pending_.ui_update_simulation = true;
  viewer_.scrub_index = 0;
  viewer_.load_error[0] = '\0';
}

void Session::set_up() {
  viewer_.run = options_.paused ? 0 : 1;
  if (options_.ghost) shown_.geomgroup[kGhostGroup] = 1;
  viewer_.ui0.sect[0].state = 0;  // File
  viewer_.ui0.sect[1].state = 0;  // Option
  show_panels(false);             // there is nothing to set yet, but perhaps something to tell
}

void Session::show_panels(bool shown) {
  viewer_.ui0_enable = shown ? 1 : 0;
  viewer_.ui1_enable = shown && window_->GetWindowSize().first >= kRoomForBothPanels ? 1 : 0;
  window_->arrange_panels();
}

void Session::before_frame() {
  if (!set_up_) set_up();
  set_up_ = true;
  if (viewer_.pending_.reset) start_anew();
  if (viewer_.m_ && !view_done_) {
    aim_camera();
    show_panels(true);
    view_done_ = true;
  }
  if (!message_changed_) return;
  message_changed_ = false;
  const std::string text = in_lines(message_, sizeof viewer_.load_error - 1);
  viewer_.load_error[text.copy(viewer_.load_error, sizeof viewer_.load_error - 1)] = '\0';
  viewer_.user_texts_.clear();
  std::string left, right;
  for (const Fact& fact : facts_) {
    left += (left.empty() ? "" : "\n") + fact.what;
    right += right.empty() ? "" : "\n";
    right += terminal_text(fact.value);
  }
  if (!left.empty()) viewer_.user_texts_.emplace_back(mjFONT_NORMAL, mjGRID_TOPRIGHT, left, right);
}

void Session::show_message(const std::string& message) {
  if (!message.empty()) options_.say(message);
  const Lock lock(viewer_.mtx);
  message_ = message;
  message_changed_ = true;
}

bool Session::load(const fs::path& scene, const std::vector<Fact>& facts) {
  ModelPointer model;
  DataPointer data;
  try {
    const MujocoMessages messages;
    std::array<char, 1000> error{};
    model.reset(mj_loadXML(scene.c_str(), nullptr, error.data(), static_cast<int>(error.size())));
    std::string reason = error.data();
    for (const std::string& warning : messages.warnings()) reason += "\n" + warning;
    if (!model) throw MujocoError(without_repeats(reason));
    data = make_data(*model);
    if (const int key = start_key(*model); key >= 0)
      mj_resetDataKeyframe(model.get(), data.get(), key);
    mj_forward(model.get(), data.get());
  } catch (const MujocoError& error) {
    show_message(scene.string() + ": " + error.what());
    return false;
  }
  {
    const Lock lock(viewer_.mtx);
    window_->name_next(
        terminal_text(fmt::format("Legwright: {}{}{}", model->names, facts.empty() ? "" : ", ",
                                  facts.empty() ? "" : facts.front().value)));
    facts_ = facts;
    message_changed_ = true;
    viewer_.key = start_key(*model);
  }
  // One name for all designs of a run: by another name MuJoCo would take back the camera.
  viewer_.Load(model.get(), data.get(), (options_.follow ? options_.path : scene).c_str());
  const Lock lock(viewer_.mtx);
  data_ = std::move(data);
  model_ = std::move(model);
  scene_ = scene;
  return true;
}

void Session::follow() {
  if (Clock::now() - last_poll_ < kPollInterval) return;
  const auto design = follower_.next();
  if (design) result_shown_ = design->result;
  const std::string state = !follower_.ended() ? follower_.waiting()
                            : result_shown_    ? kResult
                                               : kNoResult;
  if (design && load(design->scene, facts_of(*design))) {
    options_.say("loaded " + design->name + ", " + design->scene.string());
    show_message(state);
  } else if (state != state_) {
    show_message(state);
  }
  state_ = state;
  last_poll_ = Clock::now();
}

void Session::handle_requests() {
  if (viewer_.droploadrequest.exchange(0)) {
    const std::string dropped = viewer_.dropfilename;
    if (load(dropped, facts_of(design_at(dropped)))) show_message("");
  }
  if (viewer_.uiloadrequest.exchange(0) && !scene_.empty() && load(fs::path(scene_), facts_))
    show_message("");
  if (options_.follow) follow();
}

void Session::step() {
  const Lock lock(viewer_.mtx);
  if (!model_) return;
  const MujocoMessages messages;
  std::string faults;
  try {
    pace_.advance(viewer_, *model_, *data_);
  } catch (const MujocoError& error) {
    faults = error.what();
  }
  for (const std::string& warning : messages.warnings())
    faults += (faults.empty() ? "" : "\n") + warning;
  if (faults.empty()) return;
  viewer_.run = 0;
  show_message("paused: " + faults + "\nReset starts the gait anew");
}

void Session::work() {
  try {
    if (!options_.follow && load(options_.path, facts_of(design_at(options_.path))))
      options_.say("loaded " + options_.path.string());
    while (!viewer_.exitrequest) {
      handle_requests();
      step();
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
  } catch (...) {
    failure_ = std::current_exception();
    viewer_.exitrequest = 1;
  }
  working_ = false;
}

void Session::run() {
  std::thread worker([this] { work(); });
  std::exception_ptr failure;
  try {
    viewer_.RenderLoop();
  } catch (...) {
    failure = std::current_exception();
    viewer_.exitrequest = 2;
  }
  while (working_) {  // it may wait for this thread to take its model
    {
      const Lock lock(viewer_.mtx);
      viewer_.loadrequest = 0;
    }
    viewer_.cond_loadrequest.notify_all();
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
  worker.join();
  if (failure || failure_) std::rethrow_exception(failure ? failure : failure_);
}

}  // namespace

void view(const ViewerOptions& options) {
  load_gait_plugin();
  const MujocoMessages messages;              // errors of this thread become exceptions
  std::make_unique<Session>(options)->run();  // not on the stack: figures and menus take megabytes
}

}  // namespace legwright
