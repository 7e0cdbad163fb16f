// SPDX-License-Identifier: Apache-2.0
#include "mjcf/propose/proposals.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>

#include "mjcf/propose/home_stance_check.hpp"
#include "mjcf/propose/offered_proposals.hpp"
#include "mjcf/propose/remarks.hpp"
#include "mjcf/propose/side_words.hpp"
#include "mjcf/propose/unlike_sides.hpp"
#include "mjcf/read/checks.hpp"
#include "mjcf/read/mirror.hpp"
#include "mjcf/read/moving_parts.hpp"
#include "mjcf/read/printed_robot.hpp"
#include "mjcf/read/stretch.hpp"
#include "mjcf/read/tree_checks.hpp"
#include "mjcf/text/compile.hpp"
#include "mjcf/text/input_error.hpp"

namespace legwright {
namespace {

using Eigen::Vector3d;

// Bounds within which six robots of 1.5 to 45 kg followed plans at half and double gains: legs of
// 1.6 times their length under a trunk as high as before crouch, and a long, narrow trunk on two
// feet rocks; on three it does not, and its legs stand close together.
constexpr double kShorterLink = 0.75, kLongerLink = 1.25;
constexpr double kShorterTrunk = 0.95, kLongerTrunk = 1.05;            // up to two rows of legs
constexpr double kShorterTrunkOfMany = 0.8, kLongerTrunkOfMany = 1.5;  // three rows and more
constexpr double kNarrowerGirdle = 0.75, kWiderGirdle = 1.5;
// Of an axis, either way [rad]: a leg whose joints all turn about one direction needs much to leave
// its plane, one that reaches to all sides as it is need not be twisted.
constexpr double kTurn = 1.0, kTurnOfAble = 0.25;
constexpr double kOneDirection = 0.966;  // cosine of 15 degrees
constexpr double kShortestLink = 0.02;   // [m]: shorter ones are offsets, not legs
constexpr double kSameLength = 1e-6;     // [m]: what differs by so much was rounded
constexpr double kAcross = 0.7;       // cosine: turns of an axis about a nearer direction do little
constexpr double kAlongAxis = 0.996;  // cosine of 5 degrees: a link along an axis of its body
constexpr double kLargestBall = 0.5;  // radius of a foot over the length of its link
constexpr double kAttachmentShare = 0.3;  // of its distance from the hinge, either way
constexpr double kShortestMove = 0.01;    // [m]

/// Collects proposals and tries each on the file itself.
class ProposalBuilder {
 public:
  ProposalBuilder(const std::string& xml_text, const std::filesystem::path& file,
                  const Forward& forward)
      : text_(xml_text), xml_(load_xml(xml_text, file)) {
    out_.model = parse_robot(xml_text, file);
    compiled_ = compile_mjcf(xml_->text, file);
    s_ = out_.model.space.initial();
    out_.facing = forward ? Facing{*forward, "", ""} : facing_of(out_.model);
    out_.limbs = find_limbs(out_.model.morphology, s_, out_.facing.ahead);
    rows_ = out_.limbs.empty() ? 0 : out_.limbs.back().row + 1;
    offered_.emplace(text_, file, out_.model.space);
  }

  ProposedParameters run() {
    out_.not_standing = why_not_standing(*xml_, *compiled_, out_.model.structure);
    out_.remarks = remarks_on(out_.model, out_.limbs, out_.facing);
    add_shared();
    for (const Limb& limb : out_.limbs) add_lengths(limb);
    for (const Limb& limb : out_.limbs) add_axes(limb);
    add_trunk();
    for (const LinearActuator& actuator : out_.model.morphology.linear_actuators)
      add_attachments(actuator);
    offered_->keep_what_holds();
    out_.proposals = offered_->proposals();
    out_.left_out = offered_->left_out();
    return std::move(out_);
  }

 private:
  const Link& link(int index) const {
    return out_.model.morphology.links[static_cast<std::size_t>(index)];
  }
  /// The other side's limb; the limb itself where it stands alone.
  const Limb& partner(const Limb& limb) const {
    return limb.partner < 0 ? limb : out_.limbs[static_cast<std::size_t>(limb.partner)];
  }
  /// Of a pair the left limb is listed first and names the parameters of both.
  bool names_pair(const Limb& limb) const {
    return limb.partner < 0 || limb.partner > static_cast<int>(&limb - out_.limbs.data());
  }
  /// "front", or the foot's name where a limb has no partner.
  std::string place(const Limb& limb) const {
    if (limb.partner >= 0) return row_name(limb.row, rows_);
    return out_.model.morphology.feet[static_cast<std::size_t>(limb.foot)].name;
  }
  std::string title(const Limb& limb, int k) const {
    const std::string own = without_side(link(limb.links[static_cast<std::size_t>(k)]).name);
    const std::string where = place(limb);
    return (where.empty() ? "" : where + "_") + (own.empty() ? fmt::format("link{}", k + 1) : own);
  }
  std::string words(const Limb& limb) const {
    const std::string where = row_name(limb.row, rows_);
    if (limb.partner >= 0) return fmt::format("{}{}legs", where, where.empty() ? "" : " ");
    return "leg of " + place(limb);
  }

  Across side() const { return sides_across(out_.facing.ahead); }
  const char* sideways() const { return side() == Across::y ? "y" : "x"; }
  /// In front of what mirrors another in a binding.
  std::string mark() const { return side() == Across::y ? " ~" : " ^"; }

  /// The length of a body, or why it has none.
  struct Length {
    std::optional<double> metres;
    std::string why_none;
  };

  Length length_of(int body, const char* direction) const {
    try {
      return {
          measure_stretch(*xml_, *compiled_, xml_->root(), body, direction, out_.model.structure)
              .length,
          ""};
    } catch (const InputError& error) {
      return {std::nullopt, error.message()};
    }
  }

  int joint_id(int index) const {
    return mj_name2id(compiled_.get(), mjOBJ_JOINT, link(index).joint.name.c_str());
  }
  int body_id(int index) const { return compiled_->jnt_bodyid[joint_id(index)]; }
  std::string body_name(int index) const { return name_of(*compiled_, mjOBJ_BODY, body_id(index)); }
  /// Of several hinges on one body the last has its length.
  bool is_whole_body(int index) const {
    return moving_joints(*compiled_, out_.model.structure, body_id(index)).back() ==
           joint_id(index);
  }

  /// Joints between the trunk and several legs, as a waist: neither left nor right.
  void add_shared() {
    std::set<int> reported;
    for (const Limb& limb : out_.limbs)
      for (std::size_t k = 0; k < static_cast<std::size_t>(limb.shared); ++k) {
        const Joint& joint = link(limb.links[k]).joint;
        if (!reported.insert(limb.links[k]).second) continue;
        leave_out(joint.name + "_axis",
                  fmt::format("joint '{}' is above several legs, so its axis has no mirror image; "
                              "declare it by hand if it shall turn",
                              joint.name));
      }
  }

  void add_lengths(const Limb& limb) {
    if (!names_pair(limb)) return;
    for (auto k = static_cast<std::size_t>(limb.shared); k < limb.links.size(); ++k)
      if (is_whole_body(limb.links[k])) add_length(limb, k);
  }

  void add_length(const Limb& limb, std::size_t k) {
    const Limb& other = partner(limb);
    const std::string name = title(limb, static_cast<int>(k)) + "_length";
    const Length own = length_of(body_id(limb.links[k]), "link"),
                 twin = length_of(body_id(other.links[k]), "link");
    if (const std::string why = why_no_length(limb, k, own, twin); !why.empty()) {
      leave_out(name, why);
      return;
    }
    std::vector<Proposal> ways{length_proposal(limb, k, name, "link", *own.metres, *twin.metres)};
    for (const char* axis : {"x", "y", "z"}) {
      const Length a = length_of(body_id(limb.links[k]), axis),
                   b = length_of(body_id(other.links[k]), axis);
      if (a.metres && b.metres && *a.metres > kAlongAxis * *own.metres &&
          *b.metres > kAlongAxis * *twin.metres)
        ways.push_back(length_proposal(limb, k, name, axis, *a.metres, *b.metres));
    }
    offered_->offer(ways);
  }

  /// @param along "link", or the axis of its body along which the link reaches
  Proposal length_proposal(const Limb& limb, std::size_t k, const std::string& name,
                           const std::string& along, double length, double twin) const {
    const std::string from = link(limb.links[k]).joint.name,
                      to = k + 1 == limb.links.size()
                               ? "the foot"
                               : "joint " + link(limb.links[k + 1]).joint.name,
                      axis = along == "link" ? "" : fmt::format(" along {} of its body", along);
    const double factor = twin / length;
    const bool alike = std::abs(factor - 1.0) * length <= kSameLength;
    const std::string tied = fmt::format(" {}{}", alike ? "" : fmt::format("{:.12g}*", factor),
                                         body_name(partner(limb).links[k]));
    return {name,
            length,
            kShorterLink * length,
            kLongerLink * length,
            "m",
            fmt::format("stretch {}: {}{}", along, body_name(limb.links[k]),
                        limb.partner < 0 ? "" : tied),
            fmt::format("Length of the {} from joint {} to {}{}{}.", words(limb), from, to, axis,
                        limb.partner < 0 ? ""
                        : alike          ? "; left and right alike"
                                         : "; of the left one, the right one in proportion")};
  }

  /// Why the k-th link of a limb and its partner has no length to be changed; empty where it has.
  std::string why_no_length(const Limb& limb, std::size_t k, const Length& own,
                            const Length& twin) {
    const bool last = k + 1 == limb.links.size();
    const Limb& other = partner(limb);
    const Foot& foot = out_.model.morphology.feet[static_cast<std::size_t>(limb.foot)];
    if (last && foot.sole)
      return "the foot is flat, and stretched obliquely its sole would tilt; declare x, y or z by "
             "hand";
    if (!own.metres || !twin.metres) return own.metres ? twin.why_none : own.why_none;
    if (*own.metres < kShortestLink)
      return fmt::format("is {:.3g} mm, an offset between two joints and no link",
                         1e3 * *own.metres);
    bool named = true;
    for (const int index : {limb.links[k], other.links[k]})
      if (body_name(index).empty()) {
        out_.unnamed.insert(link(index).joint.name);
        named = false;
      }
    if (!named)
      return "its body has no name in the file, by which it could be declared; give it one";
    for (const int index : {limb.links[k], other.links[k]})
      if (const std::string fault = fault_of_name(body_name(index)); !fault.empty())
        return fmt::format("body '{}': {}", body_name(index), fault);
    if (std::abs(*twin.metres - *own.metres) > kTiedInProportion * *own.metres)
      return fmt::format(
          "bodies '{}' and '{}' differ in length, {:.4g} and {:.4g} m: mend the file, or declare "
          "each by hand where it is meant",
          body_name(limb.links[k]), body_name(other.links[k]), *own.metres, *twin.metres);
    if (last && foot.radius > kLargestBall * *own.metres)
      return "the foot is a round sole, not the end of a leg of that length";
    return "";
  }

  /// Whether all joints of a limb turn about one direction in the home pose.
  static bool planar(const Limb& limb) {
    return std::all_of(limb.axes.begin(), limb.axes.end(), [&](const Vector3d& axis) {
      return std::abs(limb.axes.front().dot(axis)) >= kOneDirection;
    });
  }

  /// Why the axes of two joints cannot be tied as mirror images; empty where they can.
  std::string unmirrored(const Joint& joint, const Joint& twin) const {
    const int trunk = out_.model.structure.trunk,
              from = mj_name2id(compiled_.get(), mjOBJ_JOINT, joint.name.c_str()),
              to = mj_name2id(compiled_.get(), mjOBJ_JOINT, twin.name.c_str());
    if (std::string why = unmirrored_axes(out_.model, *compiled_, joint, twin, side());
        !why.empty())
      return why;
    if (!at_mirrored_angles(*compiled_, trunk, from, to, side()))
      return fmt::format(
          "joints '{}' and '{}' stand at angles that are no mirror images in the "
          "home pose, so what they carry would be none with turned axes",
          joint.name, twin.name);
    return "";
  }

  void add_axes(const Limb& limb) {
    if (!names_pair(limb)) return;
    const double most = planar(limb) ? kTurn : kTurnOfAble;
    const Limb& other = partner(limb);
    const char* const directions[] = {"x", "y", "z"};
    const char* const turns[] = {"roll", "pitch", "yaw"};
    for (auto k = static_cast<std::size_t>(limb.shared); k < limb.links.size(); ++k) {
      const Joint &joint = link(limb.links[k]).joint, &twin = link(other.links[k]).joint;
      const Vector3d axis = joint.axis.at(s_);
      const bool stays = is_to_be_printed(*xml_) &&
                         !turn_with_axes(out_.model.turning_parts, {joint.name, twin.name});
      const std::string hindrance = stays              ? std::string(kAxesStay)
                                    : limb.partner < 0 ? std::string()
                                                       : unmirrored(joint, twin);
      std::string own = without_side(joint.name);
      if (own.empty()) own = fmt::format("joint{}", k + 1);
      const std::string where = place(limb);
      for (int n = 2; n >= 0; --n) {
        if (std::abs(axis[n]) > kAcross) continue;
        const std::string name =
            fmt::format("{}{}{}_axis_{}", where, where.empty() ? "" : "_", own, turns[n]);
        if (!hindrance.empty()) {
          leave_out(name, hindrance);
          continue;
        }
        offer({name, 0.0, -most, most, "rad",
               fmt::format("axis {}: {}{}", directions[n], joint.name,
                           limb.partner < 0 ? "" : mark() + twin.name),
               fmt::format("Turn of the axis of joint {} of the {} about {} of its body{}.",
                           joint.name, words(limb), directions[n],
                           limb.partner < 0 ? "" : "; left and right mirror each other")});
      }
    }
  }

  void add_trunk() {
    const std::string& body = out_.model.root_body;
    const double shorter = rows_ > 2 ? kShorterTrunkOfMany : kShorterTrunk;
    const double longer = rows_ > 2 ? kLongerTrunkOfMany : kLongerTrunk;
    const auto add = [&](const char* direction, const char* name, const char* what) {
      const auto length = length_of(out_.model.structure.trunk, direction).metres;
      if (!length || *length < kShortestLink) return;
      offer({name, *length, shorter * *length, longer * *length, "m",
             fmt::format("stretch {}: {}", direction, body), what});
    };
    add(side() == Across::y ? "x" : "y", "body_length",
        "Distance from the foremost to the hindmost hips.");
    add(sideways(), "body_width", "Distance from the left to the right hips.");
    for (int id = 1; id < static_cast<int>(compiled_->nbody); ++id) add_girdle(id);
  }

  /// A beam across the trunk, without a hinge of its own, that carries the legs of a row.
  void add_girdle(int id) {
    const Structure& structure = out_.model.structure;
    if (compiled_->body_parentid[id] != structure.trunk || compiled_->body_jntnum[id] > 0) return;
    int limbs = 0;
    for (int child = id + 1; child < static_cast<int>(compiled_->nbody); ++child)
      limbs += compiled_->body_parentid[child] == id && compiled_->body_jntnum[child] > 0 &&
               structure.moves[static_cast<std::size_t>(compiled_->body_jntadr[child])];
    const std::string body = name_of(*compiled_, mjOBJ_BODY, id);
    const auto length = body.empty() ? std::nullopt : length_of(id, sideways()).metres;
    if (limbs < 2 || !length || *length < kShortestLink) return;
    offer({body + "_width", *length, kNarrowerGirdle * *length, kWiderGirdle * *length, "m",
           fmt::format("stretch {}: {}", sideways(), body),
           "Distance from the left to the right hips on body " + body + "."});
  }

  /// The linear actuator of the mirrored joint; null where there is none.
  const LinearActuator* twin_of(const LinearActuator& actuator) const {
    for (const Limb& limb : out_.limbs) {
      const auto at = std::find(limb.links.begin(), limb.links.end(), actuator.joint + 1);
      if (at == limb.links.end() || limb.partner < 0) continue;
      const int joint = partner(limb).links[static_cast<std::size_t>(at - limb.links.begin())] - 1;
      for (const LinearActuator& other : out_.model.morphology.linear_actuators)
        if (other.joint == joint) return &other;
    }
    return nullptr;
  }

  int site_of(const LinearActuator& actuator, int end) const {
    const int tendon = mj_name2id(compiled_.get(), mjOBJ_TENDON, actuator.name.c_str());
    return compiled_->wrap_objid[compiled_->tendon_adr[tendon] + end];
  }

  std::string row_of(const LinearActuator& actuator) const {
    for (const Limb& limb : out_.limbs)
      if (std::count(limb.links.begin(), limb.links.end(), actuator.joint + 1) > 0)
        return row_name(limb.row, rows_);
    return "";
  }

  /// Both ends of a linear actuator may move along x and z of their bodies, mirrored as drawn.
  void add_attachments(const LinearActuator& actuator) {
    const LinearActuator* twin = twin_of(actuator);
    if (twin && twin->joint < actuator.joint) return;  // told with the other side
    for (int end = 0; end < 2; ++end) {
      const int site = site_of(actuator, end), other = twin ? site_of(*twin, end) : -1;
      const std::string name = name_of(*compiled_, mjOBJ_SITE, site),
                        row = twin ? row_of(actuator) : "";
      const std::string own = twin ? without_side(name) : name;
      for (const int n : {0, 2}) {
        const char* const axis = n == 0 ? "x" : "z";
        const double at = compiled_->site_pos[3 * site + n];
        const double most = std::max(kShortestMove, kAttachmentShare * std::abs(at));
        const double both = twin ? at * compiled_->site_pos[3 * other + n] : 0.0;
        const bool turns = both < 0.0 || (both == 0.0 && side() == Across::x);
        offer({fmt::format("{}{}{}_{}", row, row.empty() ? "" : "_", own, axis), at, at - most,
               at + most, "m",
               fmt::format(
                   "place {}: {}{}", axis, name,
                   twin ? (turns ? " ^" : " ~") + name_of(*compiled_, mjOBJ_SITE, other) : ""),
               fmt::format("Where the linear actuator {} is attached, along {} of its body{}.",
                           actuator.name, axis, twin ? "; left and right mirror each other" : "")});
      }
    }
  }

  void leave_out(const std::string& name, const std::string& why) {
    offered_->leave_out(name, why);
  }
  void offer(const Proposal& proposal) { offered_->offer({proposal}); }

  const std::string& text_;
  std::unique_ptr<XmlFile> xml_;
  ModelPointer compiled_;
  int rows_ = 0;
  Eigen::VectorXd s_;
  std::optional<OfferedProposals> offered_;
  ProposedParameters out_;
};

}  // namespace

ProposedParameters propose_parameters(const std::string& xml, const std::filesystem::path& file,
                                      const Forward& forward) {
  return ProposalBuilder(xml, file, forward).run();
}

}  // namespace legwright
