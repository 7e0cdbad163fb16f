// SPDX-License-Identifier: Apache-2.0
#include "plugin/playback_config.hpp"

#include <fmt/format.h>

#include <cmath>
#include <mutex>

#include "plugin/number_text.hpp"

namespace legwright {
namespace {

constexpr double kLargestSpeed =
    100.0;  // beyond, numbers of the played motion would not stay finite
constexpr double kShortestBlend = 1e-6;  // s

/// `count` numbers, or none if the attribute is absent.
std::vector<double> read_numbers(const mjModel* m, int instance, const char* key) {
  std::vector<double> numbers;
  for (const std::string_view token : split_blanks(attribute(m, instance, key))) {
    const auto number = read_number(token);
    if (!number)
      throw ConfigError(
          fmt::format("{}: got {}, expected a finite decimal number", key, quoted(token)));
    numbers.push_back(*number);
  }
  return numbers;
}

std::optional<double> read_one(const mjModel* m, int instance, const char* key) {
  const std::vector<double> numbers = read_numbers(m, instance, key);
  if (numbers.size() > 1)
    throw ConfigError(fmt::format("{}: got {} numbers, expected one", key, numbers.size()));
  return numbers.empty() ? std::nullopt : std::optional(numbers.front());
}

/// One number for each servo, of which one may be given for all. @param what of the number
std::vector<double> read_of_servos(const mjModel* m, int instance, const char* key,
                                   const char* what, int servo_count) {
  const auto count = static_cast<std::size_t>(servo_count);
  std::vector<double> numbers = read_numbers(m, instance, key);
  if (numbers.empty())
    throw ConfigError(fmt::format("{} is missing; expected one number, or one per actuator", key));
  for (const double number : numbers) {
    if (number < 0.0)
      throw ConfigError(fmt::format("{}: got {}, expected a {} of 0 or more", key, number, what));
  }
  if (numbers.size() == 1) numbers.assign(count, numbers.front());
  if (numbers.size() != count) {
    throw ConfigError(
        fmt::format("{}: got {} numbers, expected 1, or {} (one for each actuator of the instance)",
                    key, numbers.size(), count));
  }
  return numbers;
}

/// Torque at rest and speed without load belong together.
void read_motor_lines(const mjModel* m, int instance, int servo_count, PlaybackConfig& config) {
  constexpr const char *kTorque = "stall_torque", *kSpeed = "no_load_speed";
  const auto count = static_cast<std::size_t>(servo_count);
  config.stall_torque.assign(count, 0.0);
  config.no_load_speed.assign(count, 0.0);
  if (attribute(m, instance, kTorque).empty() && attribute(m, instance, kSpeed).empty()) return;
  config.stall_torque = read_of_servos(m, instance, kTorque, "torque", servo_count);
  config.no_load_speed = read_of_servos(m, instance, kSpeed, "speed", servo_count);
  for (std::size_t k = 0; k < count; ++k)
    if ((config.stall_torque[k] > 0.0) != (config.no_load_speed[k] > 0.0))
      throw ConfigError(
          fmt::format("{} {} and {} {} of actuator {} of the instance: expected both "
                      "positive, or both 0 for a motor whose torque does not fall",
                      kTorque, config.stall_torque[k], kSpeed, config.no_load_speed[k], k));
}

CycleSettings read_cycle(const mjModel* m, int instance) {
  CycleSettings cycle;
  cycle.period = read_one(m, instance, "period");
  cycle.turn = read_one(m, instance, "turn").value_or(0.0);
  const std::vector<double> travel = read_numbers(m, instance, "travel");
  if (!travel.empty() && travel.size() != 3) {
    throw ConfigError(fmt::format("travel: got {} numbers, expected 3 (x y z)", travel.size()));
  }
  if (!travel.empty()) cycle.travel = {travel[0], travel[1], travel[2]};
  return cycle;
}

/// Start of the plan: t0 in seconds, or phase in cycles. Both may be given where they mean the same
/// moment of the cycle.
double read_start(const mjModel* m, int instance, double period) {
  const auto t0 = read_one(m, instance, "t0"), phase = read_one(m, instance, "phase");
  if (!phase) return t0.value_or(0.0);
  if (!t0) return *phase * period;
  const double apart = *t0 / period - *phase;
  if (std::abs(apart - std::round(apart)) > 1e-6) {
    throw ConfigError(
        fmt::format("t0 = {} s is a phase of {:.6g}, but phase = {}; remove one of the two", *t0,
                    *t0 / period - std::floor(*t0 / period), *phase));
  }
  return *t0;
}

Clock read_clock(const mjModel* m, int instance, double period) {
  Clock clock;
  clock.t0 = read_start(m, instance, period);
  clock.speed = read_one(m, instance, "speed").value_or(1.0);
  if (std::abs(clock.speed) > kLargestSpeed)
    throw ConfigError(fmt::format("speed: got {}, expected −{} to {}", clock.speed, kLargestSpeed,
                                  kLargestSpeed));
  clock.blend_in = read_one(m, instance, "blend_in").value_or(0.0);
  if (clock.blend_in < 0.0 || (clock.blend_in > 0.0 && clock.blend_in < kShortestBlend)) {
    throw ConfigError(fmt::format("blend_in: got {} s, expected 0, or {} or more", clock.blend_in,
                                  kShortestBlend));
  }
  return clock;
}

int read_ghost_group(const mjModel* m, int instance) {
  const double group = read_one(m, instance, "ghost_group").value_or(mjNGROUP - 1);
  if (!(group >= 0.0 && group < mjNGROUP) || group != std::floor(group))
    throw ConfigError(fmt::format("ghost_group: got {}, expected 0 to {}", group, mjNGROUP - 1));
  return static_cast<int>(group);
}

/// The last trajectories that were parsed: a load asks for the same one at least twice, and so does
/// every reset.
class TrajectoryCache {
 public:
  std::shared_ptr<const Trajectory> find_or_parse(std::string_view text,
                                                  const CycleSettings& cycle) {
    const std::lock_guard lock(mutex_);
    for (const Entry& entry : entries_)
      if (entry.text == text && same(entry.cycle, cycle)) return entry.trajectory;
    Entry entry{std::string(text), cycle,
                std::make_shared<const Trajectory>(parse_trajectory(text, cycle))};
    constexpr std::size_t kMostEntries = 32;
    if (entries_.size() == kMostEntries)
      entries_.erase(entries_.begin());  // users keep their own pointer
    entries_.push_back(std::move(entry));
    return entries_.back().trajectory;
  }

 private:
  struct Entry {
    std::string text;
    CycleSettings cycle;
    std::shared_ptr<const Trajectory> trajectory;
  };
  static bool same(const CycleSettings& a, const CycleSettings& b) {
    return a.period == b.period && a.travel == b.travel && a.turn == b.turn;
  }

  std::mutex mutex_;
  std::vector<Entry> entries_;
};

}  // namespace

std::string_view attribute(const mjModel* m, int instance, const char* key) {
  const char* const value = mj_getPluginConfig(m, instance, key);
  return value == nullptr ? std::string_view() : std::string_view(value);
}

const mjtNum* read_rest(const mjModel* m, int instance, const RobotNames& names) {
  const std::string_view rest = attribute(m, instance, "rest");
  const std::string name = names.in_scene(rest.empty() ? "home" : rest);
  const int key = mj_name2id(m, mjOBJ_KEY, name.c_str());
  if (key >= 0) return m->key_qpos + key * m->nq;
  if (!rest.empty()) throw ConfigError("rest: the model has no keyframe named " + quoted(name));
  return m->qpos0;
}

std::shared_ptr<const Trajectory> read_trajectory(const mjModel* m, int instance) {
  static TrajectoryCache cache;
  const std::string_view text = attribute(m, instance, "trajectory");
  if (text.empty())
    throw ConfigError(
        "trajectory is missing; expected rows of numbers under a row of column names");
  return cache.find_or_parse(text, read_cycle(m, instance));
}

PlaybackConfig read_config(const mjModel* m, int instance, int servo_count) {
  PlaybackConfig config;
  config.kp = read_of_servos(m, instance, "kp", "gain", servo_count);
  config.kd = read_of_servos(m, instance, "kd", "gain", servo_count);
  read_motor_lines(m, instance, servo_count, config);
  config.ff = read_one(m, instance, "ff").value_or(1.0);
  config.trajectory = read_trajectory(m, instance);
  config.clock = read_clock(m, instance, config.trajectory->period);
  config.names = robot_names(m, instance, config.trajectory->joint_names);
  config.ghost_group = read_ghost_group(m, instance);
  return config;
}

}  // namespace legwright
