// SPDX-License-Identifier: Apache-2.0
#include "mjcf/read/legs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <set>
#include <sstream>

#include "mjcf/read/bindings.hpp"
#include "mjcf/read/checks.hpp"
#include "mjcf/read/couplings.hpp"
#include "mjcf/read/feet.hpp"
#include "mjcf/read/moving_parts.hpp"
#include "mjcf/read/soles.hpp"
#include "mjcf/read/tree_checks.hpp"
#include "mjcf/text/compile.hpp"
#include "mjcf/text/model_arrays.hpp"

namespace legwright {
namespace {

// A leg ends near the ground: not higher above the lowest foot than this share of the height of
// the trunk's centre of mass, or of half the longest reach where the file draws the robot lying.
constexpr double kLegNearGround = 0.25;
// The same for a link that a design parameter names: it was a leg's before, and a keyframe of some
// designs lifts feet.
constexpr double kDeclaredLegNearGround = 0.75;

constexpr double kBuiltAlike =
    0.01;  // chains of lengths closer than that share, and of as many hinges, are built alike
constexpr const char* kLifted =
    "rides along, built as a leg is but up in the air (if it is one, bend it to the ground in the "
    "keyframe 'home')";

/// Names of bodies and joints that design parameters are bound to, in the words of their <text>.
std::set<std::string> declared_names(const mjModel& model) {
  std::set<std::string> names;
  for (int t = 0; t < static_cast<int>(model.ntext); ++t) {
    if (name_of(model, mjOBJ_TEXT, t).rfind(kDeclarationPrefix, 0) != 0) continue;
    std::string words(model.text_data + model.text_adr[t]);
    const std::size_t colon = words.find(':', words.find('|'));
    if (colon == std::string::npos) continue;
    std::istringstream targets(words.substr(colon + 1, words.find('|', colon) - colon - 1));
    for (std::string word; targets >> word;)
      names.insert(word.substr(word.find_last_of("~^*") + 1));  // npos + 1: the whole word
  }
  return names;
}

class StructureReader {
 public:
  StructureReader(const XmlFile& xml, const mjModel& model, Refusals& reasons)
      : xml_(xml), model_(model), reasons_(reasons) {}

  FoundStructure run(const Structure* known) {
    out_.trunk = find_trunk(xml_, model_, reasons_);
    if (out_.trunk < 0) reasons_.throw_if_any();
    check_surroundings(xml_, model_, out_.trunk, reasons_);
    if (known && has_parts_of(model_, *known)) return {*known};
    data_ = kinematics_at(model_, home_qpos(model_), xml_.file);
    out_.moves.assign(static_cast<std::size_t>(model_.njnt), false);
    for (int j = 0; j < model_.njnt; ++j) out_.moves[at(j)] = hangs_on_trunk(j);
    find_legs();
    freeze_coupled();
    std::vector<int> refused;
    for (int j = 0; j < model_.njnt; ++j)
      if (out_.moves[at(j)] && !check_leg_joint(xml_, model_, j, reasons_)) refused.push_back(j);
    check_loops(xml_, model_, out_, reasons_);
    for (const int end : ends()) add_foot(end);
    for (const int joint : refused) freeze(joint, "refused");
    read_tendons();
    return {std::move(out_), is_whole_ && refused.empty()};
  }

 private:
  /// A reason on which what follows hangs.
  void refuse(const InputError& reason) {
    reasons_.add(reason);
    is_whole_ = false;
  }

  static std::size_t at(int index) { return static_cast<std::size_t>(index); }
  bool hangs_on_trunk(int joint) const {
    const int body = model_.jnt_bodyid[joint];
    return body != out_.trunk && model_.body_rootid[body] == out_.trunk;
  }

  /// Bodies that end a chain: nothing below them moves in the plan.
  std::vector<int> ends() const {
    std::vector<bool> carries(at(static_cast<int>(model_.nbody)), false);
    std::vector<int> found;
    for (int b = static_cast<int>(model_.nbody) - 1; b > out_.trunk; --b) {
      if (model_.body_rootid[b] != out_.trunk || moving_joints(model_, out_, b).empty()) continue;
      if (!carries[at(b)]) found.insert(found.begin(), b);
      carries[at(moving_body(model_, out_, model_.body_parentid[b]))] = true;
    }
    return found;
  }

  std::vector<int> link_of(int end) const {
    std::vector<int> bodies;
    for (int b = end; b < model_.nbody; ++b)
      if (model_.body_rootid[b] == out_.trunk && moving_body(model_, out_, b) == end)
        bodies.push_back(b);
    return bodies;
  }

  /// Height of the lowest part of a link: what collides, else what is drawn, else its frame.
  double lowest_of(int end) const {
    double colliding = kInfinity, drawn = kInfinity, frame = kInfinity;
    for (const int body : link_of(end)) {
      frame = std::min(frame, data_->xpos[3 * body + 2]);
      for (int k = 0; k < model_.body_geomnum[body]; ++k) {
        const int geom = model_.body_geomadr[body] + k;
        double& low = collides(model_, geom) ? colliding : drawn;
        low = std::min(low, lowest_point(model_, *data_, geom));
      }
    }
    return colliding < kInfinity ? colliding : std::min(drawn, frame);
  }

  bool is_declared(int end, const std::set<std::string>& names) const {
    for (const int joint : moving_joints(model_, out_, end))
      if (names.count(name_of(model_, mjOBJ_JOINT, joint))) return true;
    const std::vector<int> bodies = link_of(end);
    return std::any_of(bodies.begin(), bodies.end(), [&](int body) {
      return names.count(name_of(model_, mjOBJ_BODY, body)) > 0;
    });
  }

  /// A chain as it is built: its hinges from the trunk on, and its length from its first body to
  /// its last [m].
  struct Chain {
    std::vector<int> joints;
    double length = 0.0;
    bool is_like(const Chain& other) const {
      return joints.size() == other.joints.size() &&
             std::abs(length - other.length) <= kBuiltAlike * other.length;
    }
  };
  Chain chain_to(int end) const {
    Chain out;
    for (int b = end; b != out_.trunk; b = model_.body_parentid[b]) {
      const std::vector<int> own = moving_joints(model_, out_, b);
      out.joints.insert(out.joints.begin(), own.begin(), own.end());
      if (model_.body_parentid[b] != out_.trunk)
        out.length += mju_norm3(model_.body_pos + std::ptrdiff_t{3} * b);
    }
    return out;
  }

  /// A chain built as a leg is, but up in the air: perhaps a home pose with a wrong sign.
  void report_lifted(const std::vector<Chain>& chains) {
    const auto stays = [&](const Chain& chain) { return out_.moves[at(chain.joints.back())]; };
    for (const Chain& chain : chains)
      if (!stays(chain) && std::any_of(chains.begin(), chains.end(), [&](const Chain& leg) {
            return stays(leg) && chain.is_like(leg);
          }))
        for (FrozenJoint& frozen : out_.frozen)
          if (std::count(chain.joints.begin(), chain.joints.end(), frozen.joint))
            frozen.why = kLifted;
  }

  /// Takes away, from their ends, the chains that do not reach the ground.
  void find_legs() {
    std::vector<Chain> chains;
    for (const int end : ends()) chains.push_back(chain_to(end));
    double ground = kInfinity, reach = 0.0;
    for (const int end : ends()) {
      ground = std::min(ground, lowest_of(end));
      for (int k = 0; k < 3; ++k)
        reach =
            std::max(reach, std::abs(data_->xpos[3 * end + k] - data_->xipos[3 * out_.trunk + k]));
    }
    const double height = data_->xipos[3 * out_.trunk + 2] - ground;
    const double scale = std::max(height, 0.5 * reach);
    const std::set<std::string> declared = declared_names(model_);
    for (bool changed = true; changed;) {
      changed = false;
      for (const int end : ends()) {
        const double share = is_declared(end, declared) ? kDeclaredLegNearGround : kLegNearGround;
        if (lowest_of(end) - ground <= share * scale) continue;
        for (const int joint : moving_joints(model_, out_, end)) freeze(joint, "rides along");
        changed = true;
      }
    }
    report_lifted(chains);
  }

  void freeze(int joint, const std::string& why) {
    out_.moves[at(joint)] = false;
    const int body = model_.jnt_bodyid[joint];
    const FrozenJoint frozen{joint, name_of(model_, mjOBJ_JOINT, joint),
                             name_of(model_, mjOBJ_BODY, body), why};
    const auto behind = std::find_if(out_.frozen.begin(), out_.frozen.end(),
                                     [&](const FrozenJoint& other) { return other.joint > joint; });
    out_.frozen.insert(behind, frozen);
  }

  /// Coupled joints of legs are held; a leg that nothing else moves is no leg.
  void freeze_coupled() {
    const std::vector<int> leg_ends = ends();
    std::map<int, std::string> why;
    for (const auto& [joint, by] : coupled_joints(xml_, model_)) {
      if (!out_.moves[at(joint)]) continue;
      why.emplace(joint, by);
      freeze(joint, "coupled by " + by);
    }
    const std::map<int, std::string> driven = joints_of_driven_tendons(model_);
    std::map<int, int> legs_on;  // by body: a spine is above several
    for (const int end : leg_ends)
      for (int b = end; b != out_.trunk; b = model_.body_parentid[b]) ++legs_on[b];
    for (const int end : leg_ends) {
      std::string all, drivers;
      int moving = 0, pulled = 0;
      for (int b = end; b != out_.trunk; b = model_.body_parentid[b])
        for (int j = model_.body_jntadr[b]; j < model_.body_jntadr[b] + model_.body_jntnum[b];
             ++j) {
          moving += out_.moves[at(j)] ? 1 : 0;
          if (!why.count(j)) continue;
          if (const auto by = driven.find(j); by != driven.end() && legs_on.at(b) == 1) {
            ++pulled;
            drivers = by->second;
          }
          all += fmt::format("{}'{}' by {}", all.empty() ? "" : ", ",
                             name_of(model_, mjOBJ_JOINT, j), why.at(j));
        }
      if (moving > 0 && pulled > moving)
        refuse(error_at(
            xml_, model_, mjOBJ_BODY, end,
            fmt::format(
                "ends a leg of which {} hinges would be held in the home pose, as actuators "
                "drive several of them by one tendon (like '{}'), and {} would move: the "
                "planner drives each hinge by a servo of its own ({}); give each hinge an "
                "actuator, and remove what couples them",
                pulled, drivers, moving, all)));
      if (moving == 0)
        refuse(error_at(
            xml_, model_, mjOBJ_BODY, end,
            fmt::format("ends a leg of which no joint moves by itself, and coupled joints are held "
                        "in the home pose ({}); remove what couples them, or give each hinge an "
                        "actuator of its own",
                        all)));
    }
    if (leg_ends.empty())
      refuse(error_at(xml_, model_, mjOBJ_BODY, out_.trunk,
                      "has no limb: no hinge hangs on the trunk; add legs"));
  }

  void add_foot(int end) {
    FootContact foot;
    if (!choose_foot(xml_, model_, *data_, link_of(end), foot)) {
      refuse(error_at(xml_, model_, mjOBJ_BODY, end,
                      "ends a leg without a foot; add <geom type=\"sphere\"> that collides "
                      "(contype=\"1\") at its end, or a <site> where a ball shall be"));
      return;
    }
    foot.name = name_of_foot(foot, end);
    if (const std::string why = fault_of_name(foot.name); !why.empty())
      reasons_.add(foot.geom >= 0 ? error_at(xml_, model_, mjOBJ_GEOM, foot.geom, why)
                                  : error_at(xml_, model_, mjOBJ_BODY, end, why));
    find_sole(end, foot);
    out_.feet.push_back(foot);
  }

  /// Gives a foot that its leg can lay flat on the ground its normal, and a middle where it is made
  /// up of several geoms.
  void find_sole(int end, FootContact& foot) const {
    if (foot.geom < 0) return;
    const std::vector<Eigen::Vector3d> points = ground_points(model_, *data_, link_of(end));
    const std::optional<Eigen::Vector3d> normal = normal_of_sole(points);
    if (!normal) return;
    std::vector<int> joints;
    for (int b = end; b != out_.trunk; b = model_.body_parentid[b])
      for (const int joint : moving_joints(model_, out_, b)) joints.push_back(joint);
    const double height = data_->xipos[3 * out_.trunk + 2] - points.front().z();
    if (!can_lay_down(*data_, joints, points.front(), height)) return;
    const int body = foot_body(model_, foot);
    const auto world = matrix_at(data_->xmat, body);
    foot.normal = world.transpose() * *normal;
    const std::vector<int> geoms = ground_geoms(model_, *data_, link_of(end));
    const bool known = std::all_of(geoms.begin(), geoms.end(), [&](int geom) {
      return foot.geom_type == mjGEOM_SPHERE ? is_of_foot(foot, geom) : geom == foot.geom;
    });
    if (known) return;
    const Eigen::Vector3d ahead = matrix_at(data_->xmat, out_.trunk).col(0);
    foot.middle =
        world.transpose() * (middle_of_sole(points, *normal, ahead) -
                             Eigen::Vector3d::Map(data_->xpos + std::ptrdiff_t{3} * body));
    foot.radius = 0.0;
    foot.others.clear();
  }

  /// A geom's own name; else that of its body, of the link or of the joint, not yet a geom's.
  std::string name_of_foot(const FootContact& foot, int end) const {
    if (foot.geom >= 0)
      if (std::string own = name_of(model_, mjOBJ_GEOM, foot.geom); !own.empty()) return own;
    std::vector<std::string> names;
    if (foot.site >= 0) names.push_back(name_of(model_, mjOBJ_SITE, foot.site));
    names.push_back(name_of(model_, mjOBJ_BODY, foot_body(model_, foot)));
    names.push_back(name_of(model_, mjOBJ_BODY, end));
    names.push_back(name_of(model_, mjOBJ_JOINT, moving_joints(model_, out_, end).back()));
    const auto base = std::find_if(names.begin(), names.end(), [](const std::string& name) {
      return fault_of_name(name).empty();
    });
    std::string name = base == names.end() ? "foot" : *base;
    const std::string stem = name;
    for (int n = 1; is_taken(name); ++n)
      name = n == 1 ? stem + "_foot" : fmt::format("{}_foot{}", stem, n);
    return name;
  }
  bool is_taken(const std::string& name) const {
    return mj_name2id(&model_, mjOBJ_GEOM, name.c_str()) >= 0 ||
           std::any_of(out_.feet.begin(), out_.feet.end(),
                       [&](const FootContact& foot) { return foot.name == name; });
  }

  /// A straight tendon over joints of a leg is to be a linear actuator; others are held or measure.
  void read_tendons() {
    for (int t = 0; t < static_cast<int>(model_.ntendon); ++t) {
      const std::vector<int> joints = joints_under(model_, t);
      out_.reads_tendon.push_back(
          joins_two_sites(model_, t) &&
          (joints.empty() || std::any_of(joints.begin(), joints.end(),
                                         [&](int joint) { return out_.moves[at(joint)]; })));
    }
  }

  static constexpr double kInfinity = std::numeric_limits<double>::infinity();
  const XmlFile& xml_;
  const mjModel& model_;
  DataPointer data_;
  Refusals& reasons_;
  bool is_whole_ = true;
  Structure out_;
};

}  // namespace

FoundStructure read_structure(const XmlFile& xml, const mjModel& model, const Structure* known,
                              Refusals& reasons) {
  return StructureReader(xml, model, reasons).run(known);
}

}  // namespace legwright
