// SPDX-License-Identifier: Apache-2.0
#include "mjcf/read/turning_parts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <utility>

#include "mjcf/read/feet.hpp"
#include "mjcf/read/moving_parts.hpp"
#include "mjcf/text/model_arrays.hpp"
#include "mjcf/text/numbers.hpp"
#include "mjcf/text/refusals.hpp"

namespace legwright {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using Eigen::VectorXd;

constexpr double kAtHinge = 1e-6;  // [m]; files have six digits

/// One declaration, read against the compiled model.
class TurningPartReader {
 public:
  TurningPartReader(const XmlFile& xml, const mjModel& model, const Structure& structure,
                    const StretchMap& stretches, const XmlElement& text)
      : xml_(xml), model_(model), structure_(structure), stretches_(stretches), text_(text) {}

  /// Nothing where the joint is held: no design turns its axis.
  std::optional<TurningPart> run() {
    out_.body = attribute(text_, "name").substr(kTurnsPrefix.size());
    const int body = mj_name2id(&model_, mjOBJ_BODY, out_.body.c_str());
    check_body(body);
    const int joint = find_joint(), moved = model_.jnt_bodyid[joint];
    check_place(body, joint, moved);
    if (!structure_.moves[static_cast<std::size_t>(joint)]) return std::nullopt;
    out_.frame = rotation_at(model_.body_quat, moved);
    return out_;
  }

 private:
  void check_body(int body) const {
    if (body <= 0 || model_.body_rootid[body] != structure_.trunk || body == structure_.trunk)
      throw xml_.error(text_,
                       fmt::format("declares the body '{}', which is none of the robot below "
                                   "its trunk; correct the name, or remove the declaration",
                                   out_.body));
    const char* fault = nullptr;
    for (int below = body + 1; below < model_.nbody; ++below)
      if (model_.body_parentid[below] == body) fault = "holds other bodies";
    for (const FootContact& foot : structure_.feet)
      if (foot_body(model_, foot) == body) fault = "has a foot";
    for (int site = 0; site < model_.nsite; ++site)
      if (model_.site_bodyid[site] == body) fault = "has a site";
    const XmlElement* const element = find_named(xml_.root(), "body", out_.body);
    if (element && !is_tag(*element->Parent()->ToElement(), "body")) fault = "is in a frame";
    if (model_.body_jntnum[body] > 0) fault = "has a joint";
    if (stretches_.count(out_.body)) fault = "is stretched";
    if (fault)
      throw xml_.error(text_, fmt::format("declares the body '{}', which {}; what turns with an "
                                          "axis is rigid and carries nothing: put it into a body "
                                          "of its own, or remove the declaration",
                                          out_.body, fault));
  }

  int find_joint() {
    const std::string_view data = trimmed(attribute(text_, "data"));
    constexpr std::string_view kHead = "joint ";
    if (data.substr(0, kHead.size()) == kHead) out_.joint = trimmed(data.substr(kHead.size()));
    const int joint =
        out_.joint.empty() ? -1 : mj_name2id(&model_, mjOBJ_JOINT, out_.joint.c_str());
    if (joint < 0 || model_.jnt_type[joint] != mjJNT_HINGE)
      throw xml_.error(text_, fmt::format("attribute data: '{}' is no hinge; expected \"joint "
                                          "NAME\" of the one about whose axis it turns",
                                          data));
    return joint;
  }

  void check_place(int body, int joint, int moved) const {
    const Vector3d hinge = vector_at(model_.body_pos, moved) +
                           rotation_at(model_.body_quat, moved) * vector_at(model_.jnt_pos, joint);
    const bool beside =
        model_.body_parentid[body] == model_.body_parentid[moved] && model_.body_jntnum[moved] == 1;
    if (!beside || (hinge - vector_at(model_.body_pos, body)).norm() > kAtHinge)
      throw xml_.error(text_, fmt::format("declares the body '{}', whose origin is not at joint "
                                          "'{}'; put it there, with its shapes moved back, in the "
                                          "body that holds the one which '{}' alone moves",
                                          out_.body, out_.joint, out_.joint));
  }

  const XmlFile& xml_;
  const mjModel& model_;
  const Structure& structure_;
  const StretchMap& stretches_;
  const XmlElement& text_;
  TurningPart out_;
};

}  // namespace

std::vector<TurningPart> read_turning_parts(const XmlFile& xml, const mjModel& model,
                                            const Structure& structure, const StretchMap& stretches,
                                            Refusals& reasons) {
  std::vector<TurningPart> out;
  for (const XmlElement* const text : custom_elements(xml, "text", kTurnsPrefix))
    reasons.collect([&] {
      if (auto part = TurningPartReader(xml, model, structure, stretches, *text).run())
        out.push_back(std::move(*part));
    });
  return out;
}

const TurningPart* find_turning_part(const std::vector<TurningPart>& parts, std::string_view body) {
  const auto found = std::find_if(parts.begin(), parts.end(),
                                  [&](const TurningPart& part) { return part.body == body; });
  return found == parts.end() ? nullptr : &*found;
}

bool turn_with_axes(const std::vector<TurningPart>& parts,
                    const std::vector<std::string_view>& joints) {
  return std::all_of(joints.begin(), joints.end(), [&](std::string_view joint) {
    return std::any_of(parts.begin(), parts.end(),
                       [&](const TurningPart& part) { return part.joint == joint; });
  });
}

Matrix3d axis_turn(const Morphology& morphology, std::string_view joint, const VectorXd& from,
                   const VectorXd& to) {
  Matrix3d out = Matrix3d::Identity();
  for (const Link& link : morphology.links) {
    const auto& turns = link.joint.axis.turns;
    const bool differs = std::any_of(turns.begin(), turns.end(), [&](const auto& turn) {
      return from[turn.parameter] != to[turn.parameter];
    });
    if (link.joint.name != joint || !differs) continue;
    for (Eigen::Index k = 0; k < 3; ++k)
      out.col(k) = turned(turns, to, turned_back(turns, from, Vector3d::Unit(k)));
  }
  return out;
}

}  // namespace legwright
