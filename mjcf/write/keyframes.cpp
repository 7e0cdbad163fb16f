// SPDX-License-Identifier: Apache-2.0
#include "mjcf/write/keyframes.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

#include "mjcf/read/couplings.hpp"
#include "mjcf/read/feet.hpp"
#include "mjcf/read/world_parts.hpp"
#include "mjcf/text/compile.hpp"
#include "mjcf/text/elements.hpp"
#include "mjcf/text/numbers.hpp"
#include "mjcf/write/leg_pose.hpp"
#include "optimizer/design/actuator_length.hpp"

namespace legwright {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
using Eigen::VectorXd;

constexpr double kFootNearGround = 0.15;  // leg lengths: authors place robots by eye
constexpr double kInGround = 0.01;     // leg lengths: a foot so deep was not placed on the ground
constexpr double kSameDesign = 1e-12;  // as rounded numbers of the file give it
constexpr double kClear = 0.02;        // leg lengths between trunk and ground, else the robot lies
constexpr double kUpright = 0.5;       // least cosine of the trunk's tilt
constexpr double kGrain = 1e-10;       // [m], [rad]: numbers that are solved for are this fine

/// By division, so that the number has few digits.
double rounded_to_grain(double value) { return std::round(value * 1e10) / 1e10; }

bool has_numbers(const XmlElement& element, const char* name, Eigen::Index count) {
  const auto numbers = parse_numbers(attribute(element, name));
  return numbers && static_cast<Eigen::Index>(numbers->size()) == count;
}

/// Where the robot's pose is in qpos.
struct Addresses {
  int root = 0;
  std::vector<int> joints;  // by joint of the morphology
};

Addresses addresses(const RobotModel& robot, const mjModel& model) {
  Addresses out;
  const int trunk = mj_name2id(&model, mjOBJ_BODY, robot.root_body.c_str());
  out.root = model.jnt_qposadr[model.body_jntadr[trunk]];
  for (int a = 0; a < robot.morphology.joint_count(); ++a)
    out.joints.push_back(model.jnt_qposadr[mj_name2id(
        &model, mjOBJ_JOINT, robot.morphology.links[a + 1].joint.name.c_str())]);
  return out;
}

VectorXd pose_of(const VectorXd& qpos, const Addresses& at) {
  const Eigen::AngleAxisd turn(
      Eigen::Quaterniond(qpos[at.root + 3], qpos[at.root + 4], qpos[at.root + 5], qpos[at.root + 6])
          .normalized());
  VectorXd pose(6 + static_cast<Eigen::Index>(at.joints.size()));
  pose.head<3>() = qpos.segment<3>(at.root);
  pose.segment<3>(3) = turn.angle() * turn.axis();
  for (std::size_t a = 0; a < at.joints.size(); ++a)
    pose[6 + static_cast<Eigen::Index>(a)] = qpos[at.joints[a]];
  return pose;
}

/// Height of the lowest point of the boxes about the trunk's geoms.
double lowest_of_trunk(const mjModel& model, const mjData& data, int trunk) {
  double lowest = INFINITY;
  for (int g = 0; g < model.ngeom; ++g) {
    if (model.geom_bodyid[g] != trunk) continue;
    const mjtNum *up = data.geom_xmat + std::ptrdiff_t{9} * g + 6,
                 *box = model.geom_aabb + std::ptrdiff_t{6} * g;
    double height = data.geom_xpos[3 * g + 2];
    for (int k = 0; k < 3; ++k) height += up[k] * box[k] - std::abs(up[k]) * box[3 + k];
    lowest = std::min(lowest, height);
  }
  return lowest;
}

class Solver {
 public:
  /// @param lifts whether the feet leave the ground also in the design of the file, whose numbers
  /// are the author's
  Solver(const RobotModel& robot, const mjModel& model, const VectorXd& s, bool lifts)
      : robot_(robot),
        morphology_(robot.morphology),
        model_(model),
        at_(addresses(robot, model)),
        legs_(legs_of(robot.morphology)),
        before_(robot.morphology, robot.space.initial()),
        after_(robot.morphology, s),
        s_(s),
        lifts_(lifts) {}

  /// Nothing for a keyframe in which the robot does not stand.
  std::optional<StandingKey> solve(int key, KeyframeEffort effort) const {
    StandingKey out;
    out.key = key;
    out.qpos =
        VectorXd::Map(model_.key_qpos + static_cast<std::ptrdiff_t>(key) * model_.nq, model_.nq);
    out.ctrl =
        VectorXd::Map(model_.key_ctrl + static_cast<std::ptrdiff_t>(key) * model_.nu, model_.nu);
    const VectorXd old = pose_of(out.qpos, at_);
    for (int f = 0; f < morphology_.foot_count(); ++f)
      out.foot_height.push_back(before_.foot(old, f).z() - morphology_.feet[f].radius);
    if (!stands(out)) return std::nullopt;
    const double sunk = depth_in_ground(out);
    for (double& height : out.foot_height) height += sunk;
    const std::optional<VectorXd> pose =
        effort == KeyframeEffort::angles ? with_angles(old, sunk, out) : std::nullopt;
    out.every_foot = pose.has_value();
    write(pose ? *pose : with_height(old, out), old, out);
    return out;
  }

 private:
  double near_ground() const { return kFootNearGround * morphology_.leg_length; }

  bool stands(const StandingKey& key) const {
    const double lowest = *std::min_element(key.foot_height.begin(), key.foot_height.end());
    const bool sunk = lifts_ && lowest < 0.0;  // however deep
    if (!sunk && !(std::abs(lowest) <= near_ground())) return false;
    const DataPointer data = kinematics_at(model_, key.qpos.data(), robot_.file);
    const int trunk = mj_name2id(&model_, mjOBJ_BODY, robot_.root_body.c_str());
    return data->xmat[9 * trunk + 8] >= kUpright &&
           lowest_of_trunk(model_, *data, trunk) > lowest + kClear * morphology_.leg_length;
  }

  /// How deep the lowest foot is in the ground, where authors did not mean to touch it [m].
  double depth_in_ground(const StandingKey& key) const {
    const double depth = -*std::min_element(key.foot_height.begin(), key.foot_height.end());
    const bool same = s_.isApprox(robot_.space.initial(), kSameDesign);
    return (lifts_ || !same) && depth > kInGround * morphology_.leg_length ? depth : 0.0;
  }

  /// How much further each foot is below the trunk than before, at the same angles; of feet on the
  /// ground.
  std::vector<double> growth(const VectorXd& old, const StandingKey& key) const {
    std::vector<double> out;
    for (int f = 0; f < morphology_.foot_count(); ++f)
      if (std::abs(key.foot_height[f]) <= near_ground())
        out.push_back(before_.foot(old, f).z() - after_.foot(old, f).z());
    return out;
  }

  /// Every foot at its height: the trunk rises by the mean of what the legs grew, or, where a leg
  /// is then too short, by less. @param sunk by which it rises besides [m]
  std::optional<VectorXd> with_angles(const VectorXd& old, double sunk,
                                      const StandingKey& key) const {
    const std::vector<double> grown = growth(old, key);
    const double mean = std::accumulate(grown.begin(), grown.end(), 0.0) /
                        static_cast<double>(grown.size()),
                 least = *std::min_element(grown.begin(), grown.end());
    for (const double rise : {mean, 0.5 * (mean + least), least}) {
      VectorXd pose = old;
      if (rise + sunk != 0.0) pose[2] = rounded_to_grain(old[2] + rise + sunk);
      const bool good = std::all_of(legs_.begin(), legs_.end(), [&](const LegJoints& leg) {
        const Vector2d place = before_.reach(old, leg).head<2>();
        return after_.solve(pose, leg,
                            {key.foot_height[leg.foot] + morphology_.feet[leg.foot].radius, place,
                             before_.sole(old, leg.foot)});
      });
      if (good) return pose;
    }
    return std::nullopt;
  }

  /// The lowest foot at its height, all angles as they were.
  VectorXd with_height(const VectorXd& old, const StandingKey& key) const {
    double lowest = INFINITY;
    for (int f = 0; f < morphology_.foot_count(); ++f)
      lowest = std::min(lowest, after_.foot(old, f).z() - morphology_.feet[f].radius);
    const double wanted = *std::min_element(key.foot_height.begin(), key.foot_height.end());
    VectorXd pose = old;
    if (lowest != wanted) pose[2] = rounded_to_grain(old[2] + wanted - lowest);
    return pose;
  }

  void write(const VectorXd& pose, const VectorXd& old, StandingKey& key) const {
    key.qpos[at_.root + 2] = pose[2];
    for (std::size_t a = 0; a < at_.joints.size(); ++a) {
      const auto k = static_cast<Eigen::Index>(6 + a);
      if (pose[k] != old[k]) key.qpos[at_.joints[a]] = within(a, rounded_to_grain(pose[k]));
    }
    for (int i = 0; i < model_.nactuator; ++i) follow(i, pose, old, key);
  }

  /// Rounding must not leave the range.
  double within(std::size_t joint, double angle) const {
    const Joint& of = morphology_.links[joint + 1].joint;
    return angle - of.upper <= kGrain && of.lower - angle <= kGrain
               ? std::clamp(angle, of.lower, of.upper)
               : angle;
  }

  /// The control of a position servo is the angle, or the length of its tendon.
  void follow(int actuator, const VectorXd& pose, const VectorXd& old, StandingKey& key) const {
    const mjtNum* bias = model_.actuator_biasprm + std::ptrdiff_t{mjNBIAS} * actuator;
    if (model_.actuator_biastype[actuator] != mjBIAS_AFFINE || !(bias[1] < 0.0)) return;
    const double moved = travel(actuator, pose, old);
    if (moved == 0.0) return;
    const int control = model_.actuator_ctrladr[actuator];
    const double before = key.ctrl[control];
    const double gear = model_.actuator_gear[std::ptrdiff_t{6} * model_.actuator_outadr[actuator]];
    const mjtNum* range = model_.actuator_ctrlrange + std::ptrdiff_t{2} * control;
    double& value = key.ctrl[control];
    value = rounded_to_grain(before + gear * moved);
    if (model_.actuator_ctrllimited[control] && before >= range[0] && before <= range[1])
      value = std::clamp(value, range[0], range[1]);
  }

  /// How much further the joint has turned [rad], or the tendon is longer [m].
  double travel(int actuator, const VectorXd& pose, const VectorXd& old) const {
    const int target = model_.actuator_trnid[std::ptrdiff_t{2} * actuator];
    const bool is_tendon = model_.actuator_trntype[actuator] == mjTRN_TENDON;
    const int alone = is_tendon ? lone_joint(model_, target) : -1;
    if (alone >= 0) return model_.wrap_prm[model_.tendon_adr[target]] * turn(alone, pose, old);
    if (is_tendon) {
      const std::string name = name_of(model_, mjOBJ_TENDON, target);
      for (const LinearActuator& linear : morphology_.linear_actuators) {
        if (linear.name != name) continue;
        const auto length = [&](const VectorXd& s, const VectorXd& at) {
          return morphology_.leg_length *
                 actuator_length(actuator_shape(morphology_, linear, s).value,
                                 at[6 + linear.joint]);
        };
        return length(s_, pose) - length(robot_.space.initial(), old);
      }
      return 0.0;
    }
    if (model_.actuator_trntype[actuator] != mjTRN_JOINT &&
        model_.actuator_trntype[actuator] != mjTRN_JOINTINPARENT)  // the same for a hinge
      return 0.0;
    return turn(target, pose, old);
  }

  /// How much further a joint has turned [rad].
  double turn(int joint, const VectorXd& pose, const VectorXd& old) const {
    for (std::size_t a = 0; a < at_.joints.size(); ++a)
      if (model_.jnt_qposadr[joint] == at_.joints[a])
        return pose[static_cast<Eigen::Index>(6 + a)] - old[static_cast<Eigen::Index>(6 + a)];
    return 0.0;
  }

  const RobotModel& robot_;
  const Morphology& morphology_;
  const mjModel& model_;
  const Addresses at_;
  const std::vector<LegJoints> legs_;
  const PosedRobot before_, after_;
  const VectorXd& s_;
  const bool lifts_;
};

/// The keyframes with numbers of their own in which the robot stands.
std::vector<StandingKey> solved_keyframes(const Solver& solver, const XmlFile& xml,
                                          const mjModel& model, KeyframeEffort effort) {
  std::vector<StandingKey> keys;
  int key = 0;  // MuJoCo counts them in the order of the file
  for_each_element(xml.root(), [&](const XmlElement& element) {
    if (!is_tag(element, "key")) return;
    const int id = key++;
    if (id >= model.nkey || !has_numbers(element, "qpos", model.nq)) return;
    std::optional<StandingKey> solved = solver.solve(id, effort);
    if (!solved) return;
    solved->element = &element;
    keys.push_back(std::move(*solved));
  });
  return keys;
}

/// Whether the level ground at height zero is where the robot stands in its file too.
bool stands_at_zero(const mjModel& model, const std::filesystem::path& file) {
  constexpr double kLevel = 1e-9;
  const DataPointer data = kinematics_at(model, nullptr, file);
  for (int g = 0; g < static_cast<int>(model.ngeom); ++g) {
    if (!is_of_surroundings(model, g) || !collides(model, g)) continue;
    const double height = data->geom_xpos[3 * g + 2], upright = data->geom_xmat[9 * g + 8];
    if (model.geom_type[g] != mjGEOM_PLANE || std::abs(height) > kLevel || upright < 1.0 - kLevel)
      return false;
  }
  return true;
}

}  // namespace

std::vector<StandingKey> solve_keyframes(const RobotModel& robot, const XmlFile& xml,
                                         const mjModel& model, const VectorXd& s,
                                         KeyframeEffort effort) {
  if (effort == KeyframeEffort::none || robot.morphology.feet.empty()) return {};
  return solved_keyframes(Solver(robot, model, s, false), xml, model, effort);
}

LiftedKeyframes with_lifted_keyframes(const RobotModel& robot) {
  LiftedKeyframes out{robot.files, 0.0};
  const std::string& text = robot.files.text();
  const auto xml = load_xml(text, robot.file);
  const ModelPointer model = compile_mjcf(text, robot.file);
  if (robot.morphology.feet.empty() || !stands_at_zero(*model, robot.file)) return out;
  const VectorXd s = robot.space.initial();
  const std::vector<StandingKey> keys =
      solved_keyframes(Solver(robot, *model, s, true), *xml, *model, KeyframeEffort::height);
  for (const StandingKey& key : keys)
    out.lifted = std::max(
        out.lifted,
        (key.qpos - VectorXd::Map(model->key_qpos + std::ptrdiff_t{key.key} * model->nq, model->nq))
            .maxCoeff());
  if (out.lifted <= 0.0) return out;
  TextEdits edits(*xml);
  edit_keyframes(*model, keys, edits);
  out.files = robot.files.with_text(edits.apply());
  return out;
}

void edit_keyframes(const mjModel& model, const std::vector<StandingKey>& keys, TextEdits& edits) {
  for (const StandingKey& key : keys) {
    const XmlElement& element = *key.element;
    const auto write = [&](const char* name, const VectorXd& now, const mjtNum* old) {
      if (!has_numbers(element, name, now.size())) return;
      auto numbers = parse_numbers(attribute(element, name));
      bool changed = false;
      for (Eigen::Index k = 0; k < now.size(); ++k) {
        if (now[k] == old[k]) continue;  // as the file has it: MuJoCo normalises some numbers
        (*numbers)[static_cast<std::size_t>(k)] = now[k];
        changed = true;
      }
      if (changed) edits.set_numbers(element, name, VectorXd::Map(numbers->data(), now.size()));
    };
    write("qpos", key.qpos, model.key_qpos + static_cast<std::ptrdiff_t>(key.key) * model.nq);
    write("ctrl", key.ctrl, model.key_ctrl + static_cast<std::ptrdiff_t>(key.key) * model.nu);
  }
}

std::string find_lifted_foot(const Structure& structure, const std::vector<StandingKey>& keys,
                             const XmlFile& xml, const mjModel& model, double tolerance) {
  const TreeElements elements = find_elements(xml, model);
  for (const StandingKey& key : keys) {
    const DataPointer data = kinematics_at(
        model, model.key_qpos + static_cast<std::ptrdiff_t>(key.key) * model.nq, xml.file);
    double lowest = INFINITY;
    for (std::size_t f = 0; f < structure.feet.size(); ++f) {
      const FootContact& foot = structure.feet[f];
      const int body = foot_body(model, foot);
      const Vector3d point = foot_point(xml, elements, model, foot, {}).constant,
                     up = Vector3d::Map(data->xmat + std::ptrdiff_t{9} * body + 6);
      const double height = data->xpos[3 * body + 2] + up.dot(point) - foot.radius;
      lowest = std::min(lowest, height);
      const double miss = height - key.foot_height[f];
      if (key.every_foot && !(std::abs(miss) <= tolerance))
        return fmt::format("foot {} is {} m too high in keyframe {}", foot.name, miss, key.key);
    }
    const double miss = lowest - *std::min_element(key.foot_height.begin(), key.foot_height.end());
    if (!(std::abs(miss) <= tolerance))
      return fmt::format("the feet are {} m too high in keyframe {}", miss, key.key);
  }
  return "";
}

}  // namespace legwright
