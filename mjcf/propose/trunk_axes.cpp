// SPDX-License-Identifier: Apache-2.0
#include "mjcf/propose/trunk_axes.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "mjcf/propose/askew_hips.hpp"
#include "mjcf/propose/declare.hpp"
#include "mjcf/propose/leg_chains.hpp"
#include "mjcf/propose/trunk_element.hpp"
#include "mjcf/propose/two_legs_up.hpp"
#include "mjcf/read/checks.hpp"
#include "mjcf/read/moving_parts.hpp"
#include "mjcf/read/tree_checks.hpp"
#include "mjcf/text/compile.hpp"
#include "mjcf/text/input_error.hpp"
#include "mjcf/text/model_arrays.hpp"
#include "mjcf/text/numbers.hpp"
#include "mjcf/text/text_edits.hpp"
#include "mjcf/text/xml.hpp"

namespace legwright {
namespace {

using Eigen::Matrix3d;
using Eigen::Quaterniond;
using Eigen::Vector3d;

constexpr double kTrunkOnItsSide = 0.5;  // cosine of the tilt beyond which z is not up
constexpr double kZIsUp = 0.99;          // cosine of the tilt up to which z is up
constexpr double kHingeUpright = 0.99, kHingeLevel = 0.1;  // cosines to z
constexpr double kOnePlane = 0.1;      // of the leg's length: feet that end at one height
constexpr double kFarBelow = 0.15;     // of the leg's length: a foot below its hip
constexpr std::size_t kThreeFeet = 3;  // have a plane
constexpr double kToesBelow = 0.5;     // of what legs hang down: below hips of a lying robot
constexpr double kNoTurn = 1e-9;       // a rounding error of a turn
constexpr int kArm = 1;                // chain of the legs' build may point up: an arm, a tail

/// The turns that lead axes to axes, as w x y z in whole numbers.
std::vector<std::array<int, 4>> axis_turns() {
  std::vector<std::array<int, 4>> out;
  for (int n = 0; n < 81; ++n) {
    const std::array<int, 4> q{n % 3 - 1, n / 3 % 3 - 1, n / 9 % 3 - 1, n / 27 - 1};
    const auto is_part = [](int x) { return x != 0; };
    const auto parts = std::count_if(q.begin(), q.end(), is_part);
    if (parts == 0 || parts == 3) continue;  // none, or one that leads axes elsewhere
    if (*std::find_if(q.begin(), q.end(), is_part) > 0) out.push_back(q);
  }
  return out;
}

template <class Number>
Quaterniond turn_of(const std::array<Number, 4>& q) {
  return Quaterniond(q[0], q[1], q[2], q[3]).normalized();
}

/// Of the turns that lead `up` of the trunk's frame to z the one nearest to how the trunk is drawn.
std::array<double, 4> turn_upright(const Vector3d& up, const Quaterniond& drawn) {
  std::array<double, 4> best{1, 0, 0, 0};
  double least = std::numeric_limits<double>::infinity();
  for (const std::array<int, 4>& q : axis_turns()) {
    if ((turn_of(q) * up - Vector3d::UnitZ()).norm() > 1e-6) continue;
    const double off = drawn.angularDistance(turn_of(q));
    if (off > least - 1e-6) continue;
    least = off;
    std::copy(q.begin(), q.end(), best.begin());
  }
  return best;
}

/// How a robot is held with its home pose's angles: its legs, and whether they stand.
struct Held {
  std::size_t legs = 0;  // that stand; 0: it does not
  double below = 0.0;    // of the feet, from the hips on average [m]
};

class AxesFinder {
 public:
  AxesFinder(const mjModel& model, int trunk, const std::filesystem::path& file)
      : model_(model),
        trunk_(trunk),
        root_(model.jnt_qposadr[model.body_jntadr[trunk]]),
        data_(kinematics_at(model, home_qpos(model), file)),
        drawn_(quaternion_of(data_->qpos + root_ + 3)) {}

  std::optional<TrunkAxes> run() {
    const Vector3d up_at_home = drawn_.conjugate() * Vector3d::UnitZ();
    if (up_at_home.z() < kTrunkOnItsSide) {
      const Held home = held_as(drawn_);
      Eigen::Index axis = 0;
      up_at_home.cwiseAbs().maxCoeff(&axis);
      const Vector3d up = std::copysign(1.0, up_at_home[axis]) * Vector3d::Unit(axis);
      if (home.legs > 0 && up != Vector3d::UnitZ()) return told(up, home, true);
    }
    const Held as_drawn = held_as(Quaterniond::Identity());
    const std::vector<SearchedLeg> all = legs_of_one_build(model_, trunk_, *data_);
    for (const Vector3d& up :
         {Vector3d(0, 1, 0), Vector3d(0, -1, 0), Vector3d(1, 0, 0), Vector3d(-1, 0, 0)})
      if (const Held held = held_as(Quaterniond::FromTwoVectors(up, Vector3d::UnitZ()));
          held.legs >= kThreeFeet && held.legs > as_drawn.legs && pointing_up(all) <= kArm)
        return told(up, held, false);
    if (auto lying = as_drawn.legs <= 2 ? lying_on_two(as_drawn.below) : std::nullopt) return lying;
    return up_at_home.z() > kZIsUp ? askew(all) : std::nullopt;
  }

  /// Legs that reach out to all sides, as drawn: what their first hinges turn about is up, or down.
  std::optional<TrunkAxes> reaching_out() {
    held_as(Quaterniond::Identity());
    const std::size_t as_drawn = legs_of_one_build(model_, trunk_, *data_).size();
    for (const Vector3d& up : {Vector3d(0, 1, 0), Vector3d(1, 0, 0)}) {
      held_as(Quaterniond::FromTwoVectors(up, Vector3d::UnitZ()));
      const std::vector<SearchedLeg> legs = legs_of_one_build(model_, trunk_, *data_);
      if (legs.size() > kThreeFeet && legs.size() > as_drawn && reach_out(legs))
        return TrunkAxes{
            fmt::format(
                "{} seems to be up in the frame of the trunk '{}': its {} legs reach out to "
                "all sides, and their first hinges turn about that",
                "xyz"[up.x() > 0.0 ? 0 : 1], name_of(model_, mjOBJ_BODY, trunk_), legs.size()),
            turn_upright(up, Quaterniond::Identity()), false, false};
    }
    return std::nullopt;
  }

 private:
  /// Whether the first hinges of all legs are upright as the trunk is held, all others level, and
  /// feet on all sides of their hips.
  bool reach_out(const std::vector<SearchedLeg>& legs) const {
    Vector3d sum = Vector3d::Zero();
    for (const SearchedLeg& leg : legs) {
      for (const int joint : leg.joints) {
        const double upright = std::abs(vector_at(data_->xaxis, joint).z());
        if (joint == leg.joints.front() ? upright < kHingeUpright : upright > kHingeLevel)
          return false;
      }
      sum +=
          (leg.touch(model_, *data_) - vector_at(data_->xanchor, leg.joints.front())).normalized();
    }
    return sum.norm() < 0.5 * static_cast<double>(legs.size());
  }

  /// Two feet have no plane: one direction alone may be up, and all that can be looked at says so.
  /// @param as_drawn how far the feet are below the hips along z [m]: long toes alone may be
  std::optional<TrunkAxes> lying_on_two(double as_drawn) {
    std::optional<TrunkAxes> found;
    for (const Vector3d& up :
         {Vector3d(0, 1, 0), Vector3d(0, -1, 0), Vector3d(1, 0, 0), Vector3d(-1, 0, 0)}) {
      const Held held = held_as(Quaterniond::FromTwoVectors(up, Vector3d::UnitZ()));
      if (held.legs != 2 || as_drawn > kToesBelow * held.below ||
          !plainly_stands_on_two(model_, *data_, trunk_, legs_of_one_build(model_, trunk_, *data_)))
        continue;
      if (found) return std::nullopt;
      found = told(up, held, false);
    }
    return found;
  }

  /// @param legs as they are posed at present
  std::optional<TrunkAxes> askew(const std::vector<SearchedLeg>& legs) const {
    const Eigen::Matrix3d trunk = matrix_at(data_->xmat, trunk_);
    Eigen::Matrix2Xd hips(2, static_cast<Eigen::Index>(legs.size()));
    for (std::size_t k = 0; k < legs.size(); ++k)
      hips.col(static_cast<Eigen::Index>(k)) =
          (trunk.transpose() * vector_at(data_->xanchor, legs[k].joints.front())).head<2>();
    const std::optional<double> turn = askew_hips(hips);
    if (!turn) return std::nullopt;
    return TrunkAxes{
        fmt::format("the frame of the trunk '{}' is turned by {:.3g} degrees about z "
                    "from the plane in which its hips are mirrored",
                    name_of(model_, mjOBJ_BODY, trunk_), -*turn * 180.0 / std::numbers::pi),
        {rounded(std::cos(*turn / 2.0)), 0.0, 0.0, rounded(-std::sin(*turn / 2.0))},
        true,
        true};
  }

  TrunkAxes told(const Vector3d& up, const Held& held, bool stands) const {
    Eigen::Index axis = 0;
    up.cwiseAbs().maxCoeff(&axis);
    const char* const sign = up[axis] < 0.0 ? "-" : "";
    return {fmt::format("{0}{1} is up in the frame of the trunk '{2}': its {3} feet lie in one "
                        "plane, {4:.2g} m below the hips along {0}{1}{5}",
                        sign, "xyz"[axis], name_of(model_, mjOBJ_BODY, trunk_), held.legs,
                        held.below, stands ? ", and so the home pose has it" : ""),
            turn_upright(up, stands ? drawn_ : Quaterniond::Identity()), stands, false};
  }

  /// How many legs end above their hips as the trunk is held: those of the other side, where all
  /// are drawn stretched out sideways.
  std::ptrdiff_t pointing_up(const std::vector<SearchedLeg>& legs) const {
    return std::count_if(legs.begin(), legs.end(), [this](const SearchedLeg& leg) {
      const Vector3d hip = vector_at(data_->xanchor, leg.joints.front());
      const Vector3d along = leg.touch(model_, *data_) - hip;
      return along.z() > kFarBelow * along.norm();
    });
  }

  Held held_as(const Quaterniond& trunk) {
    for (int k = 0; k < 4; ++k) data_->qpos[root_ + 3 + k] = trunk.coeffs()[(k + 3) % 4];
    mj_kinematics(&model_, data_.get());
    mj_comPos(&model_, data_.get());
    const std::vector<SearchedLeg> legs = legs_of_one_build(model_, trunk_, *data_);
    Held out;
    double low = std::numeric_limits<double>::infinity(), high = -low, length = 0.0;
    for (const SearchedLeg& leg : legs) {
      const Vector3d foot = leg.touch(model_, *data_);
      double own = 0.0;
      Vector3d from = vector_at(data_->xanchor, leg.joints.front());
      for (const int joint : leg.joints) {
        own += (vector_at(data_->xanchor, joint) - from).norm();
        from = vector_at(data_->xanchor, joint);
      }
      own += (foot - from).norm();
      const double below = vector_at(data_->xanchor, leg.joints.front()).z() - foot.z();
      if (below < kFarBelow * own) return {};
      out.below += below / static_cast<double>(legs.size());
      low = std::min(low, foot.z());
      high = std::max(high, foot.z());
      length = std::max(length, own);
    }
    if (legs.size() < 2 || high - low > kOnePlane * length ||
        data_->subtree_com[3 * trunk_ + 2] <= high)
      return {};
    out.legs = legs.size();
    return out;
  }

  const mjModel& model_;
  const int trunk_, root_;
  DataPointer data_;
  const Quaterniond drawn_;
};

/// The trunk, where it is in the main file and stands in the world itself.
const XmlElement* trunk_in_world(const XmlFile& xml) {
  const XmlElement* const trunk = trunk_element(xml);
  return trunk && is_tag(*trunk->Parent()->ToElement(), "worldbody") ? trunk : nullptr;
}

void remove_orientation(TextEdits& edits, const XmlElement& element) {
  for (const char* name : {"axisangle", "xyaxes", "zaxis", "euler", "quat"})
    edits.remove(element, name);
}

/// w x y z of a turn; w is not negative.
Eigen::Vector4d numbers_of(const Quaterniond& q) {
  const double sign = q.w() < 0.0 ? -1.0 : 1.0;
  return rounded(sign * Eigen::Vector4d(q.w(), q.x(), q.y(), q.z()));
}

/// Turns what `body` weighs from its own frame into the upright one.
void turn_inertial(TextEdits& edits, const XmlElement& inertial, const mjModel& model, int body,
                   const Matrix3d& turn) {
  const Matrix3d axes = turn * rotation_at(model.body_iquat, body);
  const Matrix3d moments =
      axes * vector_at(model.body_inertia, body).asDiagonal() * axes.transpose();
  Eigen::VectorXd full(6);
  full << moments.diagonal(), moments(0, 1), moments(0, 2), moments(1, 2);
  full = rounded(full);
  const bool diagonal = full.tail<3>().isZero(0.0);
  edits.set_numbers(inertial, "pos", turn * vector_at(model.body_ipos, body));
  remove_orientation(edits, inertial);
  edits.remove(inertial, diagonal ? "fullinertia" : "diaginertia");
  if (diagonal)
    edits.set_numbers(inertial, "diaginertia", full.head<3>());
  else
    edits.set_numbers(inertial, "fullinertia", full);
}

/// Turns the trunk of a keyframe back by what its frame is turned by.
void turn_keyframe(TextEdits& edits, const XmlElement& key, int root, const Quaterniond& turn) {
  const auto words = parse_numbers(attribute(key, "qpos"));
  if (!words || words->size() < static_cast<std::size_t>(root) + 7) return;
  Eigen::VectorXd qpos =
      Eigen::VectorXd::Map(words->data(), static_cast<Eigen::Index>(words->size()));
  qpos.segment<4>(root + 3) = numbers_of(quaternion_of(qpos.data() + root + 3) * turn.conjugate());
  edits.set_numbers(key, "qpos", qpos);
}

/// Puts runs of a body's parts that can stand in a <frame> into one.
std::string with_frames(const std::string& edited, const std::filesystem::path& file,
                        const std::array<double, 4>& turn) {
  const auto xml = load_xml(edited, file);
  const std::string& text = xml->text;
  const std::string new_line = line_end(text);
  const XmlElement& trunk = *trunk_in_world(*xml);
  std::vector<std::pair<std::size_t, std::string>> added;
  bool open = false;
  std::size_t end = 0;
  for (const XmlElement* part = trunk.FirstChildElement(); part != nullptr;
       part = part->NextSiblingElement()) {
    const bool turns = !is_free_joint(*part) && !is_tag(*part, "inertial");
    const TagSpan& tag = xml->tag(*part);
    const std::size_t line = text.rfind('\n', tag.begin) + 1;  // 0 where there is none
    std::string blanks = text.substr(line, tag.begin - line);
    if (blanks.find_first_not_of(" \t") != std::string::npos) blanks.clear();
    if (turns && !open)
      added.emplace_back(tag.begin, fmt::format("<frame quat=\"{}\">{}{}", fmt::join(turn, " "),
                                                new_line, blanks));
    if (!turns && open) added.emplace_back(end, new_line + blanks + "</frame>");
    open = turns;
    end = tag.close_end;
    if (open && part->NextSiblingElement() == nullptr)
      added.emplace_back(end, new_line + blanks + "</frame>");
  }
  std::string out = text;
  for (auto at = added.rbegin(); at != added.rend(); ++at) out.insert(at->first, at->second);
  return out;
}

}  // namespace

namespace {

using Search = std::optional<TrunkAxes> (AxesFinder::*)();

std::optional<TrunkAxes> search(const std::string& text, const std::filesystem::path& file,
                                Search way) {
  try {
    const auto xml = load_xml(text, file);
    Refusals reasons;
    check_text(*xml, reasons);
    const ModelPointer model = compile_mjcf(xml->text, file);
    const int trunk = find_trunk(*xml, *model, reasons);
    if (trunk < 0 || !reasons.empty()) return std::nullopt;
    AxesFinder finder(*model, trunk, file);
    return (finder.*way)();
  } catch (const InputError&) {
    return std::nullopt;  // its reader tells all faults
  }
}

}  // namespace

std::optional<TrunkAxes> find_trunk_axes(const std::string& text,
                                         const std::filesystem::path& file) {
  return search(text, file, &AxesFinder::run);
}

std::optional<TrunkAxes> find_lying_trunk_axes(const std::string& text,
                                               const std::filesystem::path& file) {
  return search(text, file, &AxesFinder::reaching_out);
}

RobotFiles with_upright_axes(const RobotFiles& files, const TrunkAxes& axes) {
  const auto xml = load_xml(files.main_text(), files.file());
  const ModelPointer model = compile_mjcf(files.text(), files.file());
  Refusals none;
  const int trunk = find_trunk(*load_xml(files.text(), files.file()), *model, none);
  const int root = model->jnt_qposadr[model->body_jntadr[trunk]];
  const XmlElement* const body = trunk_in_world(*xml);
  std::vector<const XmlElement*> keys;
  for_each_element(xml->root(), [&](const XmlElement& element) {
    if (is_tag(element, "key")) keys.push_back(&element);
  });
  if (body == nullptr || (axes.stands && keys.size() != static_cast<std::size_t>(model->nkey)))
    throw InputError(
        files.file().string(), 0, fmt::format("body '{}'", name_of(*model, mjOBJ_BODY, trunk)),
        fmt::format(
            "{}; {} not in the main file, where init could turn it: put what stands in "
            "this body, but for its free joint and <inertial>, into <frame quat=\"{}\">…"
            "</frame>, turn <inertial> alike, and turn its own orientation back by as much, "
            "in keyframes too",
            axes.why + (axes.upright ? "" : "; expected z"),
            body == nullptr ? "the trunk is" : "its keyframes are", fmt::join(axes.frame, " ")));
  const Quaterniond turn = turn_of(axes.frame);
  TextEdits edits(*xml);
  Quaterniond upright = quaternion_of(model->qpos0 + root + 3) * turn.conjugate();
  if (!axes.stands) upright.setIdentity();
  remove_orientation(edits, *body);
  if (upright.vec().norm() > kNoTurn) edits.set_numbers(*body, "quat", numbers_of(upright));
  if (const XmlElement* const inertial = body->FirstChildElement("inertial"))
    turn_inertial(edits, *inertial, *model, trunk, turn.toRotationMatrix());
  if (axes.stands)
    for (const XmlElement* const key : keys) turn_keyframe(edits, *key, root, turn);
  return files.with_main(with_frames(edits.apply(), files.file(), axes.frame));
}

}  // namespace legwright
