// SPDX-License-Identifier: Apache-2.0
#include "mjcf/propose/standing_pose.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "mjcf/propose/declare.hpp"
#include "mjcf/propose/leg_chains.hpp"
#include "mjcf/read/checks.hpp"
#include "mjcf/read/feet.hpp"
#include "mjcf/read/moving_parts.hpp"
#include "mjcf/read/tree_checks.hpp"
#include "mjcf/text/angle_words.hpp"
#include "mjcf/text/compile.hpp"
#include "mjcf/text/input_error.hpp"
#include "mjcf/write/home_ctrl.hpp"

namespace legwright {
namespace {

using Eigen::Vector3d;

constexpr std::array kBentTo{0.87, 0.93, 0.97};       // of a leg's reach downwards, tried in turn
constexpr double kSprawlsTo = 0.4, kBesideHip = 0.5;  // the same, and outwards, of one that sprawls
constexpr double kStretched = 0.97;                   // a leg that reaches so far is straight
constexpr double kFolded = 0.35;         // a leg whose foot is under its hip and reaches no farther
constexpr double kLiesFlat = 0.12;       // of its reach: a leg whose foot is no lower lies flat
constexpr double kOffTheFeet = 0.2;      // of the reach: so far off their middle it tips
constexpr double kUnderHip = 0.3;        // of its reach: what is under a hip
constexpr double kUnevenEnds = 0.25;     // of the reach: ends of legs at different heights
constexpr double kOffTheGround = 5e-3;   // [m]: drawn by hand, feet are nearer
constexpr double kAsLowAsFeet = 1e-3;    // [m]: as low as the feet
constexpr double kMostShiftToCom = 0.2;  // of the reach, towards the centre of mass
constexpr double kFrameElsewhere = 0.2;  // of the hips' spread: off their middle
constexpr double kSameAngle = 0.05;      // [rad]: legs that are drawn alike left and right
constexpr double kPoseGrain = 1e6;       // numbers are written to a millionth
constexpr double kLevelTrunk = 0.99;     // least cosine of the trunk's tilt
constexpr double kBendAlike = 0.9;       // least cosine between the planes of legs that bend alike
constexpr double kUprightTrunk = 0.5;    // the same, of one that does not lie
constexpr std::size_t kFewestLegs = 2;   // legs
constexpr std::size_t kTooFewToBend = 3;  // two straight legs stand on flat feet

double to_grain(double value) { return std::round(value * kPoseGrain) / kPoseGrain + 0.0; }

/// Of the trunk and what is fixed to it, what collides [m].
double lowest_of_trunk_link(const mjModel& model, const mjData& data, int trunk) {
  double low = std::numeric_limits<double>::infinity();
  for (int g = 0; g < model.ngeom; ++g)
    if (model.body_weldid[model.geom_bodyid[g]] == trunk && collides(model, g))
      low = std::min(low, lowest_point(model, data, g));
  return low;
}

class PoseFinder {
 public:
  PoseFinder(const XmlFile& xml, const mjModel& model, int trunk)
      : model_(model),
        file_(xml.file),
        in_degrees_(angles_in_degrees(xml)),
        trunk_(trunk),
        root_(model.jnt_qposadr[model.body_jntadr[trunk]]),
        data_(kinematics_at(model, home_qpos(model), xml.file)),
        legs_(legs_of_one_build(model, trunk, *data_)) {}

  /// @param none gets a sentence where the home pose is none and no other was found
  std::optional<StandingPose> run(std::string& none) {
    if (legs_.size() < kFewestLegs) return std::nullopt;
    StandingPose out;
    out.why = fault_of_range();
    if (out.why.empty() && data_->xmat[9 * trunk_ + 8] < kUprightTrunk)
      out.why = "the trunk lies there on its side or back";
    level_trunk();
    measure_reaches();
    if (out.why.empty()) out.why = fault_of_home();
    if (out.why.empty()) return as_it_is_drawn();
    const bool sprawls = legs_.size() > kTooFewToBend &&
                         std::all_of(legs_.begin(), legs_.end(), [](const auto& leg) {
                           return leg.sprawls() && !leg.outwards().isZero();
                         });
    if (sprawls && stand_up(true, kSprawlsTo))
      out.words = "level, knees up and feet beside the hips: " + words_of_angles();
    else if (std::any_of(kBentTo.begin(), kBentTo.end(),
                         [&](double bent) { return stand_up(false, bent); }))
      out.words = fmt::format("level, feet {} the hips: {}", stand_beside() ? "beside" : "below",
                              words_of_angles());
    if (out.words.empty()) {
      none = fmt::format(
          "the file's pose is none to stand in ({}), and no other was found: within their ranges "
          "the joints do not bring the feet of its {} legs of one build to the ground below the "
          "trunk; check ranges and axes, or write a keyframe named home",
          out.why, legs_.size());
      return std::nullopt;
    }
    write(out);
    return out;
  }

 private:
  /// How far a foot is below the hinge above its knee, in the pose of data_.
  double drop(const SearchedLeg& leg) const {
    return data_->xanchor[3 * leg.hip_joint() + 2] - leg.touch(model_, *data_).z();
  }

  std::string fault_of_range() const {
    for (const SearchedLeg& leg : legs_)
      for (const int joint : leg.joints) {
        const double angle = data_->qpos[model_.jnt_qposadr[joint]];
        const mjtNum* range = model_.jnt_range + std::ptrdiff_t{2} * joint;
        if (model_.jnt_limited[joint] && (angle < range[0] || angle > range[1]))
          return fmt::format("joint '{}' is at {} there, outside of its range {}",
                             name_of(model_, mjOBJ_JOINT, joint), angle_text(angle, in_degrees_),
                             angle_range_text(range[0], range[1], in_degrees_));
      }
    return "";
  }

  void measure_reaches() {
    for (SearchedLeg& leg : legs_) {
      home_drop_.push_back(drop(leg));
      const Vector3d foot = leg.touch(model_, *data_);
      away_.push_back(std::hypot(foot.x() - data_->xanchor[std::ptrdiff_t{3} * leg.hip_joint()],
                                 foot.y() - data_->xanchor[3 * leg.hip_joint() + 1]));
      low_at_home_.push_back(foot.z());
    }
    trunk_at_home_ = lowest_of_trunk_link(model_, *data_, trunk_);
    mj_comPos(&model_, data_.get());
    Vector3d off = Vector3d::Map(data_->subtree_com + std::ptrdiff_t{3} * trunk_);
    for (const SearchedLeg& leg : legs_)
      off -= leg.touch(model_, *data_) / static_cast<double>(legs_.size());
    com_off_feet_ = off.head<2>().norm();
    for (SearchedLeg& leg : legs_) leg.measure(model_, *data_);
  }

  std::string fault_of_home() const {
    double reach = 0.0, stretched = 2.0, hanging = 0.0;  // the last two: shares of their reaches
    bool folded = true;
    for (std::size_t k = 0; k < legs_.size(); ++k) {
      reach = std::max(reach, legs_[k].reach);
      stretched = std::min(stretched, home_drop_[k] / legs_[k].reach);
      hanging = std::max(hanging, home_drop_[k] / legs_[k].reach);
      folded = folded && home_drop_[k] < kFolded * legs_[k].reach &&
               away_[k] < kUnderHip * legs_[k].reach;
    }
    const auto [low, high] = std::minmax_element(low_at_home_.begin(), low_at_home_.end());
    if (*high - *low > kUnevenEnds * reach)
      return fmt::format("legs of one build end there at heights that differ by {:.2g} m",
                         *high - *low);
    if (trunk_at_home_ <= *low + kAsLowAsFeet) return "the trunk is there as low as its feet";
    if (folded) return "its legs are folded there";
    if (hanging < kLiesFlat) return "its legs lie flat there, feet as high as hips";
    if (home_keyframe(model_) >= 0 || legs_.size() < kTooFewToBend) return "";
    if (stretched > kStretched) return "the file has no keyframe and draws its legs stretched out";
    if (com_off_feet_ > kOffTheFeet * reach)
      return fmt::format(
          "the file has no keyframe and draws its centre of mass {:.2g} m off the middle of its "
          "feet",
          com_off_feet_);
    return "";
  }

  /// The pose that the file draws, which stands, at the height where it does, with legs that mirror
  /// each other at mirrored angles; nothing where it is so, or a keyframe's, which scenes and
  /// viewers start from.
  std::optional<StandingPose> as_it_is_drawn() {
    if (home_keyframe(model_) >= 0) return std::nullopt;
    const std::string unlike = mirror_drawn();
    double low = std::numeric_limits<double>::infinity();
    for (const SearchedLeg& leg : legs_) low = std::min(low, leg.touch(model_, *data_).z());
    if (unlike.empty() && std::abs(low) < kOffTheGround) return std::nullopt;
    StandingPose out;
    if (unlike.empty())
      out.why = fmt::format("the file has no keyframe and draws its feet {:.2g} m {} the ground",
                            std::abs(low), low < 0.0 ? "below" : "above");
    else
      out.why =
          "the file has no keyframe and draws legs that are mirror images at other angles "
          "left and right: " +
          unlike;
    out.words = unlike.empty() ? "as it is drawn, on the ground"
                               : "as it is drawn, with mirrored legs: " + words_of_angles();
    data_->qpos[root_ + 2] = to_grain(data_->qpos[root_ + 2] - low);
    write(out);
    return out;
  }

  /// Gives legs that are drawn at other angles than those they mirror the mirrored ones.
  /// @return a joint that is and what it mirrors, in words; empty: there is none
  std::string mirror_drawn() {
    std::string unlike;
    const Vector3d along = common_ahead();
    for (std::size_t k = 0; k < legs_.size(); ++k) {
      const auto angles = mirrored(k, along);
      if (!angles) continue;
      const Eigen::VectorXd off = *angles - legs_[k].angles_in(model_, *data_);
      Eigen::Index most = 0;
      if (off.cwiseAbs().maxCoeff(&most) <= kSameAngle) continue;
      legs_[k].set_angles(model_, *data_, angles->unaryExpr(&to_grain));
      if (unlike.empty())
        unlike = fmt::format(
            "joint '{}' by {}",
            name_of(model_, mjOBJ_JOINT, legs_[k].joints[static_cast<std::size_t>(most)]),
            angle_text(off[most], in_degrees_));
    }
    return unlike;
  }

  void level_trunk() {
    if (data_->xmat[9 * trunk_ + 8] < kLevelTrunk) {
      const mjtNum upright[] = {1, 0, 0, 0};
      mju_copy(data_->qpos + root_ + 3, upright, 4);
    }
    mj_kinematics(&model_, data_.get());
  }

  /// The level direction in which all legs bend; zero where they bend in several, or outwards.
  Vector3d common_ahead() const {
    Vector3d out = legs_.front().ahead();
    for (const SearchedLeg& leg : legs_)
      if (leg.turns_level() || leg.ahead().dot(out) < kBendAlike) return Vector3d::Zero();
    return out;
  }

  bool stand_beside() const {
    return std::all_of(legs_.begin(), legs_.end(),
                       [](const SearchedLeg& leg) { return leg.stands_beside(); });
  }

  /// The trunk's frame, or the middle of the hips where that is elsewhere.
  Vector3d middle_of_hips() const {
    const Vector3d trunk = Vector3d::Map(data_->xpos + std::ptrdiff_t{3} * trunk_);
    Eigen::AlignedBox3d hips;
    for (const SearchedLeg& leg : legs_) hips.extend(leg.anchors.front());
    const Vector3d off = hips.center() - trunk;
    return off.head<2>().norm() > kFrameElsewhere * hips.sizes().head<2>().norm() ? hips.center()
                                                                                  : trunk;
  }

  /// Angles of the mirror image left or right of the first of the earlier legs that has one in this
  /// leg. @param along where all legs bend, or zero: then to the trunk's x
  std::optional<Eigen::VectorXd> mirrored(std::size_t leg, const Vector3d& along) {
    const Vector3d trunk = middle_of_hips(), plane = std::abs(along.y()) > std::abs(along.x())
                                                         ? Vector3d(-1.0, 1.0, 1.0)
                                                         : Vector3d(1.0, -1.0, 1.0);
    for (std::size_t k = 0; k < leg; ++k)
      if (auto angles = legs_[leg].mirror_of(legs_[k], trunk, plane, model_, *data_)) return angles;
    return std::nullopt;
  }

  /// Whether an earlier leg has this one as its mirror image, which then stands as that does, but
  /// for the last millimetres.
  bool stands_mirrored(std::size_t leg, const Vector3d& along, double ground) {
    const auto angles = mirrored(leg, along);
    if (!angles) return false;
    legs_[leg].set_angles(model_, *data_, *angles);
    return std::abs(legs_[leg].touch(model_, *data_).z() - ground) <= kAsLowAsFeet ||
           legs_[leg].rise_to(ground, model_, *data_);
  }

  /// Puts the feet below their hips, or beside them under raised knees, twice: then their middle is
  /// below the centre of mass. @param bent share of their reach to which legs go down
  bool stand_up(bool sprawling, double bent) {
    double ground = -std::numeric_limits<double>::infinity(), reach = ground;
    for (const SearchedLeg& leg : legs_) {
      ground = std::max(ground, leg.hip.z() - bent * leg.reach);
      reach = std::max(reach, leg.reach);
    }
    const Vector3d along = common_ahead();
    Vector3d shift = Vector3d::Zero();
    for (int round = 0; round < 2; ++round) {
      Vector3d middle = Vector3d::Zero();
      for (std::size_t k = 0; k < legs_.size(); ++k) {
        const SearchedLeg& leg = legs_[k];
        Vector3d place = leg.below_hip() + shift;
        if (sprawling) place += kBesideHip * leg.reach * leg.outwards();
        place.z() = ground;
        Vector3d knee = Vector3d::UnitZ();
        if (!sprawling) knee = leg.turns_level() ? Vector3d::Zero() : Vector3d(-leg.ahead());
        if (!stands_mirrored(k, along, ground) && !leg.put(model_, *data_, place, knee))
          return false;
        middle += leg.touch(model_, *data_) / static_cast<double>(legs_.size());
      }
      mj_comPos(&model_, data_.get());
      const Vector3d centre = Vector3d::Map(data_->subtree_com + std::ptrdiff_t{3} * trunk_);
      shift = std::clamp(along.dot(centre - (middle - shift)), -kMostShiftToCom * reach,
                         kMostShiftToCom * reach) *
              along;
    }
    for (const SearchedLeg& leg : legs_)
      for (const int joint : leg.joints) {
        mjtNum& angle = data_->qpos[model_.jnt_qposadr[joint]];
        angle = to_grain(angle);
      }
    mj_kinematics(&model_, data_.get());
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (const SearchedLeg& leg : legs_) {
      low = std::min(low, leg.touch(model_, *data_).z());
      high = std::max(high, leg.touch(model_, *data_).z());
    }
    if (high - low > kAsLowAsFeet ||
        lowest_of_trunk_link(model_, *data_, trunk_) <= high + kAsLowAsFeet)
      return false;
    data_->qpos[root_ + 2] = to_grain(data_->qpos[root_ + 2] - low);
    return true;
  }

  std::string words_of_angles() const {
    const double unit = in_degrees_ ? std::numbers::pi / 180.0 : 1.0;
    std::string out;
    for (const SearchedLeg& leg : legs_)
      for (const int joint : leg.joints)
        out +=
            fmt::format("{}{} {:.3g}", out.empty() ? "" : ", ", name_of(model_, mjOBJ_JOINT, joint),
                        data_->qpos[model_.jnt_qposadr[joint]] / unit);
    return out + (in_degrees_ ? " degrees" : " rad");
  }

  void write(StandingPose& out) const {
    for (int k = 0; k < static_cast<int>(model_.nq); ++k)
      out.qpos += fmt::format("{}{:.10g}", k ? " " : "", data_->qpos[k] + 0.0);
    if (const auto ctrl = holding_ctrl(model_, data_->qpos, file_)) out.ctrl = ctrl_text(*ctrl);
  }

  const mjModel& model_;
  const std::filesystem::path& file_;
  const bool in_degrees_;
  const int trunk_, root_;
  DataPointer data_;
  std::vector<SearchedLeg> legs_;
  std::vector<double> home_drop_, away_, low_at_home_;  // of each leg [m]
  double trunk_at_home_ = 0.0, com_off_feet_ = 0.0;     // [m]
};

}  // namespace

std::optional<StandingPose> find_standing_pose(const std::string& text,
                                               const std::filesystem::path& file,
                                               std::string* none) {
  try {
    const auto xml = load_xml(text, file);
    Refusals reasons;
    check_text(*xml, reasons);  // sizes among it, for which MuJoCo would take minutes
    const ModelPointer model = compile_mjcf(xml->text, file);
    const int trunk = find_trunk(*xml, *model, reasons);
    if (trunk < 0 || !reasons.empty() || mj_name2id(model.get(), mjOBJ_KEY, kStandingKey) >= 0)
      return std::nullopt;
    std::string why_none;
    auto pose = PoseFinder(*xml, *model, trunk).run(why_none);
    if (none != nullptr) *none = why_none;
    return pose;
  } catch (const InputError&) {
    return std::nullopt;  // its reader tells all faults
  }
}

std::string with_keyframe(const std::string& xml, const std::filesystem::path& file,
                          const StandingPose& pose) {
  std::string key = fmt::format("<key name=\"{}\" qpos=\"{}\"", kStandingKey, pose.qpos);
  if (!pose.ctrl.empty()) key += fmt::format(" ctrl=\"{}\"", pose.ctrl);
  return with_lines_in_section(xml, file, "keyframe", {key + "/>"});
}

}  // namespace legwright
