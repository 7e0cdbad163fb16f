// SPDX-License-Identifier: Apache-2.0
#include "tools/validate/comparison.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "plugin/spline.hpp"
#include "tools/simulate/planned_vectors.hpp"
#include "tools/validate/planned_curves.hpp"
#include "tools/validate/saturation.hpp"

namespace legwright {
namespace {

constexpr int kBins = 60;
constexpr int kSamplesPerBin = 4;  // at least, so that no bin of a cycle stays empty
constexpr int kPathPointsPerCycle = 12;

using R = ComparedRows;

int bins_for(const Scene& scene) {
  const double samples = scene.trajectory.period / scene.model->opt.timestep;
  return std::clamp(static_cast<int>(samples / kSamplesPerBin), 1, kBins);
}

struct Words {
  R::Whole row;
  const char *name, *label, *unit;
};

constexpr Words kWords[] = {
    {R::speed, "speed", "speed of the centre of mass along the wanted direction", "m/s"},
    {R::heading_error, "heading_error", "heading, measured less planned", "rad"},
    {R::com_x, "com_x", "centre of mass ahead of an even motion", "m"},
    {R::com_y, "com_y", "centre of mass to the left of an even motion", "m"},
    {R::com_height, "com_height", "height of the centre of mass", "m"},
    {R::trunk_height, "trunk_height", "height of the trunk's origin", "m"},
    {R::roll, "roll", "roll of the trunk", "rad"},
    {R::pitch, "pitch", "pitch of the trunk", "rad"},
    {R::yaw, "yaw", "yaw of the trunk against a heading that turns evenly", "rad"},
    {R::power, "power", "positive mechanical power of all joints", "W"},
    {R::saturated, "saturated_share", "share of the time with a servo at its limit", "1"},
    {R::tracking, "tracking", "joint angles against the plan, RMS over the joints", "rad"},
};

// Those planned rows that hold numbers.
void add_plan(const Eigen::MatrixXd& planned, int row, Curve& curve) {
  if (planned.row(row).array().isFinite().all()) curve.planned = planned.row(row).transpose();
}

}  // namespace

ComparisonWatch::ComparisonWatch(const Scene& scene, const WantedMotion& wanted, int settle_cycles)
    : scene_(scene),
      model_(*scene.model),
      wanted_(wanted),
      path_(wanted.velocity, wanted.turn_rate, scene.trajectory.period),
      settle_cycles_(settle_cycles),
      weight_(robot_weight(model_, scene.joints)),
      rows_(scene.trajectory),
      planned_(planned_curves(scene, wanted, bins_for(scene))),
      planned_yaw_(planned_yaw(scene)),
      curves_(rows_.count(), bins_for(scene)),
      values_(Eigen::VectorXd::Zero(rows_.count())),
      yaw_(planned_yaw_),
      qpos_(Eigen::Map<const Eigen::VectorXd>(
          model_.key_qpos + static_cast<std::ptrdiff_t>(scene.start_key) * model_.nq, model_.nq)),
      qvel_(Eigen::Map<const Eigen::VectorXd>(
          model_.key_qvel + static_cast<std::ptrdiff_t>(scene.start_key) * model_.nv, model_.nv)) {}

void ComparisonWatch::observe(const RolloutSample& sample) {
  const mjData& data = sample.data;
  const double period = scene_.trajectory.period, step = model_.opt.timestep;
  const double position = (sample.time + scene_.t0 + 1e-6 * step) / period;
  const double whole = std::floor(position);
  const double share = position - whole;
  const mjtNum* rotation = data.xmat + 9 * scene_.joints.root_body;
  yaw_ += std::remainder(trunk_angles(rotation).yaw - yaw_, 2 * std::numbers::pi);
  const Eigen::Map<const Eigen::Vector3d> com(data.subtree_com + 3 * scene_.joints.root_body);
  if (const int cycle = static_cast<int>(whole);
      cycle != cycle_ && (cycle_ >= 0 || share * period < step / 2)) {
    start_cycle(cycle, {com.head<2>(), yaw_, work_});
  }
  if (cycle_ >= 0) {
    watch_trunk(data, share);
    watch_feet(data, share);
    watch_joints(data);
    const auto bin = static_cast<int>(share * curves_.bins());
    curves_.add(std::min(bin, curves_.bins() - 1), values_);
    watch_path(sample.time + scene_.t0, com.head<2>());
  }
  com_ = com;
  qpos_ = Eigen::Map<const Eigen::VectorXd>(data.qpos, model_.nq);
  qvel_ = Eigen::Map<const Eigen::VectorXd>(data.qvel, model_.nv);
}

void ComparisonWatch::start_cycle(int cycle, const Mark& now) {
  if (cycle_ >= 0) {
    cycles_.push_back(row(now));
    // Cycles that still settle serve only where no others follow; the first never does.
    if (static_cast<int>(cycles_.size()) == settle_cycles_ + 1) curves_.restart();
    curves_.end_cycle(cycles_.size() > 1, [this](Eigen::MatrixXd& means) { derive(means); });
  }
  cycle_ = cycle;
  mark_ = now;
  sums_ = {};
}

CycleComparison ComparisonWatch::row(const Mark& end) const {
  const double period = scene_.trajectory.period;
  CycleComparison out;
  out.cycle = cycle_;
  const Eigen::Vector2d step =
      Eigen::Rotation2Dd(-mark_.yaw) * Eigen::Vector2d(end.position - mark_.position);
  const Eigen::Vector2d velocity =
      WantedPath::velocity_along_arc(step, end.yaw - mark_.yaw, period);
  if (wanted_.travels())
    out.speed_ratio = velocity.dot(speed_direction(wanted_)) / wanted_.velocity.norm();
  if (wanted_.turns()) out.turn_ratio = (end.yaw - mark_.yaw) / (period * wanted_.turn_rate);
  out.heading = end.yaw - planned_yaw_ - scene_.trajectory.turn * (cycle_ + 1);
  out.tilt_max = sums_.tilt_max;
  out.power = (end.work - mark_.work) / period;
  if (const double speed = velocity.norm(); wanted_.travels() && speed > 1e-6)
    out.cost_of_transport = out.power / (weight_ * speed);
  out.saturated_share =
      static_cast<double>(sums_.saturated) / static_cast<double>(std::max(1LL, sums_.samples));
  return out;
}

// What follows from the means within each bin instead of from single steps.
void ComparisonWatch::derive(Eigen::MatrixXd& means) const {
  const double heading = mark_.yaw - planned_yaw_ - scene_.trajectory.turn * cycle_;
  means.row(R::heading_error) = (means.row(R::yaw) - planned_.row(R::yaw)).array() + heading;
  for (int j = 0; j < rows_.feet; ++j) {
    const auto row = [&](R::Foot part) { return means.row(rows_.foot(j, part)).array(); };
    row(R::tangential) = (row(R::ahead).square() + row(R::left).square()).sqrt();
    row(R::friction) = (row(R::normal) > kStandingShare * weight_)
                           .select(row(R::tangential) / row(R::normal), 0.0);
  }
  means.row(R::tracking).setZero();
  for (int a = 0; a < rows_.joints; ++a) {
    const int angle = rows_.joint(a, R::angle);
    means.row(R::tracking) += (means.row(angle) - planned_.row(angle)).cwiseAbs2() / rows_.joints;
  }
  means.row(R::tracking) = means.row(R::tracking).cwiseSqrt();
}

void ComparisonWatch::watch_trunk(const mjData& data, double share) {
  const int body = scene_.joints.root_body;
  const Eigen::Map<const Eigen::Vector3d> com(data.subtree_com + 3 * body);
  const mjtNum* rotation = data.xmat + 9 * body;
  const double turned = scene_.trajectory.turn * share;
  const Eigen::Rotation2Dd start(-mark_.yaw), heading(-mark_.yaw - turned);
  const Eigen::Vector2d moved = start * Eigen::Vector2d(com.head<2>() - mark_.position) -
                                path_.position(share * scene_.trajectory.period).head<2>();
  const Eigen::Vector2d velocity =
      com_ ? Eigen::Vector2d((com - *com_).head<2>() / model_.opt.timestep)
           : Eigen::Vector2d::Zero();
  const TrunkAngles angles = trunk_angles(rotation);
  values_[R::speed] = speed_direction(wanted_).dot(heading * velocity);
  values_[R::com_x] = moved.x();
  values_[R::com_y] = moved.y();
  values_[R::com_height] = com.z();
  values_[R::trunk_height] = data.xpos[3 * body + 2];
  values_[R::roll] = angles.roll;
  values_[R::pitch] = angles.pitch;
  values_[R::yaw] = yaw_ - mark_.yaw - turned;
  sums_.tilt_max = std::max(sums_.tilt_max, std::acos(std::clamp(rotation[8], -1.0, 1.0)));
}

void ComparisonWatch::watch_feet(const mjData& data, double share) {
  read_foot_touches(scene_, data, touches_);
  const Eigen::Rotation2Dd heading(-mark_.yaw - scene_.trajectory.turn * share);
  for (int j = 0; j < rows_.feet; ++j) {
    const FootTouch& touch = touches_[static_cast<std::size_t>(j)];
    const int geom = scene_.foot_geom[static_cast<std::size_t>(j)];
    const Eigen::Vector2d along = heading * touch.force.head<2>();
    const auto at = [&](R::Foot part) -> double& { return values_[rows_.foot(j, part)]; };
    at(R::ahead) = along.x();
    at(R::left) = along.y();
    at(R::normal) = touch.force.z();
    at(R::height) = foot_position(model_, data, geom).z() - foot_radius(model_, geom);
    const bool stands = touch.normal > kStandingShare * weight_;
    at(R::slip_speed) = stands ? touch.slip_speed : 0.0;
    at(R::contact) = stands ? 1.0 : 0.0;
  }
}

void ComparisonWatch::watch_joints(const mjData& data) {
  double power = 0.0;
  bool saturated = false;
  for (int a = 0; a < rows_.joints; ++a) {
    const auto joint = static_cast<std::size_t>(a);
    const double torque = data.qfrc_actuator[scene_.joints.dof[joint]];
    const double own = torque * qvel_[scene_.joints.dof[joint]];
    values_[rows_.joint(a, R::angle)] = qpos_[scene_.joints.qpos[joint]];
    values_[rows_.joint(a, R::torque)] = torque;
    values_[rows_.joint(a, R::joint_power)] = own;
    power += std::max(0.0, own);
    saturated = saturated || is_saturated(scene_, data, joint);
  }
  values_[R::power] = power;
  values_[R::saturated] = saturated ? 1.0 : 0.0;
  work_ += power * model_.opt.timestep;
  ++sums_.samples;
  sums_.saturated += saturated;
}

void ComparisonWatch::watch_path(double time, const Eigen::Vector2d& com) {
  const double interval = scene_.trajectory.period / kPathPointsPerCycle;
  if (time < static_cast<double>(paths_.measured.size()) * interval - model_.opt.timestep / 2)
    return;
  const Trajectory& plan = scene_.trajectory;
  paths_.planned.emplace_back(
      planned_point(plan, phase_at(plan, time), plan.com_column(0)).value.head<2>());
  paths_.measured.push_back(com);
}

std::optional<Comparison> ComparisonWatch::finish(const Measurements& measured) const {
  if (curves_.cycles() == 0) return std::nullopt;
  Comparison out;
  out.gain_scale = scene_.gain_scale;
  const int last = cycles_.back().cycle;
  out.cycles = {last - curves_.cycles() + 1, last};
  out.period = scene_.trajectory.period;
  out.phases = (Eigen::VectorXd::LinSpaced(curves_.bins(), 0, curves_.bins() - 1).array() + 0.5) /
               curves_.bins();
  const auto curve = [&](int row) {
    Curve result = curves_.curve(row);
    add_plan(planned_, row, result);
    return result;
  };
  for (const Words& words : kWords)
    out.curves.push_back({words.name, words.label, words.unit, curve(words.row)});
  const PlanAgainstDynamics plan = inverse_dynamics(scene_, curves_.bins());
  out.inverse_dynamics = plan;
  for (int j = 0; j < rows_.feet; ++j) {
    const auto foot = static_cast<std::size_t>(j);
    const FootMeasures& stances = measured.feet[foot];
    const auto of = [&](R::Foot part) { return curve(rows_.foot(j, part)); };
    out.feet.push_back({stances.name,
                        of(R::normal),
                        of(R::tangential),
                        of(R::height),
                        of(R::slip_speed),
                        of(R::friction),
                        of(R::contact),
                        {stances.touchdown_mean, stances.touchdown_max},
                        {stances.liftoff_mean, stances.liftoff_max},
                        {stances.landing_mean, stances.landing_max},
                        {stances.slip_mean, stances.slip_max, plan.foot_slip[foot]},
                        {stances.roll_mean, stances.roll_max, plan.foot_roll[foot]}});
  }
  for (int a = 0; a < rows_.joints; ++a) {
    const auto of = [&](R::Joint part) { return curve(rows_.joint(a, part)); };
    const auto joint = static_cast<std::size_t>(a);
    out.joints.push_back({scene_.trajectory.joint_names[joint], of(R::angle), of(R::torque),
                          of(R::joint_power), scene_.torque_limit[joint]});
  }
  out.cycle_table = cycles_;
  out.paths = paths_;
  out.warnings = measured.warnings;
  return out;
}

std::string describe(const Comparison& comparison) {
  double share = 0.0, touchdown = 0.0, liftoff = 0.0, tracking = 0.0;
  std::string where;
  double weight = 0.0;
  for (const auto& foot : comparison.feet) weight += foot.normal.planned->mean();
  for (const auto& foot : comparison.feet) {
    Eigen::Index bin = 0;
    const double most = (foot.normal.mean - *foot.normal.planned).cwiseAbs().maxCoeff(&bin);
    touchdown = std::max(touchdown, foot.touchdown.worst);
    liftoff = std::max(liftoff, foot.liftoff.worst);
    if (most <= share * weight) continue;
    share = most / weight;
    where = fmt::format("{} at phase {:.2f}", foot.name, comparison.phases[bin]);
  }
  for (const auto& named : comparison.curves)
    if (named.name == "tracking") tracking = named.curve.mean.maxCoeff();
  return fmt::format(
      "plan against physics: normal forces within {:.0f} % of the weight ({}), touchdown within "
      "{:.0f} ms, lift-off within {:.0f} ms, joints within {:.1f} mrad",
      100 * share, where, 1000 * touchdown, 1000 * liftoff, 1000 * tracking);
}

}  // namespace legwright
