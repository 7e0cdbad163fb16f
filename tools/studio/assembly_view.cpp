// SPDX-License-Identifier: Apache-2.0
#include "tools/studio/assembly_view.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "mjcf/assembly/assembly_names.hpp"
#include "mjcf/assembly/assembly_xml.hpp"
#include "mjcf/assembly/linear_joint.hpp"
#include "mjcf/read/feet.hpp"
#include "mjcf/text/compile.hpp"
#include "tools/assemble/assembly_item.hpp"
#include "tools/assemble/assembly_spots.hpp"
#include "tools/modules/assembly_text.hpp"

namespace legwright {
namespace {

using Eigen::Vector3d;
using Kind = AssemblyItem::Kind;

Json list(const Vector3d& v) { return Json::array({v.x(), v.y(), v.z()}); }

/// Bodies, geoms and where they are in the reference pose, as high as makes the lowest point touch
/// the ground.
Json drawn(const std::string& xml, const std::string& file, MeshStore& meshes, ModelPointer* kept) {
  ModelPointer model = compile_mjcf(xml, file, MeshDetail::triangles);
  const DataPointer data = kinematics_at(*model, nullptr, file);
  double low = std::numeric_limits<double>::infinity();
  for (int g = 0; g < static_cast<int>(model->ngeom); ++g)
    if (model->geom_type[g] != mjGEOM_PLANE) low = std::min(low, lowest_point(*model, *data, g));
  for (int body = 1; body < static_cast<int>(model->nbody); ++body) data->xpos[3 * body + 2] -= low;
  Json out = posed_drawables_json(*model, *data, meshes);
  if (kept) *kept = std::move(model);
  return out;
}

/// Which item each body is of; what has no name here is of the body that carries it.
Json items_of_bodies(const Assembly& assembly, const mjModel& model) {
  std::map<std::string, std::string> known{{"trunk", "trunk"}};
  for (std::size_t k = 0; k < assembly.parts.size(); ++k)
    known[part_name(assembly.parts[k], k)] = to_string({Kind::part, k, 0});
  for (const PlacedLimb& limb : placed_limbs(assembly)) {
    const auto index = static_cast<std::size_t>(limb.of - assembly.limbs.data());
    for (std::size_t k = 0; k < limb.of->joints.size(); ++k) {
      const std::string item = to_string({Kind::joint, index, k});
      known[servo_name(limb, limb.of->joints[k])] = item;
      known[link_name(limb, limb.of->joints[k])] = item;
    }
  }
  std::vector<std::string> out(static_cast<std::size_t>(model.nbody));
  for (int body = 1; body < static_cast<int>(model.nbody); ++body) {
    const auto found = known.find(name_of(model, mjOBJ_BODY, body));
    out[static_cast<std::size_t>(body)] =
        found == known.end() ? out[static_cast<std::size_t>(model.body_parentid[body])]
                             : found->second;
  }
  return out;
}

Json range_json(const std::optional<std::array<double, 2>>& range) {
  return range ? Json::array({(*range)[0], (*range)[1]}) : Json(nullptr);
}

Json joint_json(const Assembly& assembly, std::size_t index, std::size_t k, const Vector3d& at) {
  const AssemblyJoint& joint = assembly.limbs[index].joints[k];
  return {{"item", to_string({Kind::joint, index, k})},
          {"name", joint.name},
          {"link", joint.link},
          {"servo", joint.servo.name},
          {"at", list(at)},
          {"offset", list(joint.offset)},
          {"axis", list(joint.axis)},
          {"roll", joint.roll},
          {"range", range_json(joint.range)},
          {"servo_range",
           range_json(joint.is_linear() ? linear_range(joint) : joint.servo.joint->range)},
          {"linear", joint.is_linear()},
          {"torque", torque_limit(assembly, joint.servo) *
                         (joint.is_linear() ? std::abs(moment_arm_at(joint, 0.0)) : 1.0)}};
}

Json limb_json(const Assembly& assembly, std::size_t index) {
  const AssemblyLimb& limb = assembly.limbs[index];
  Json joints = Json::array();
  Vector3d at = limb.hip;
  for (std::size_t k = 0; k < limb.joints.size(); ++k) {
    at += limb.joints[k].offset;
    joints.push_back(joint_json(assembly, index, k, at));
  }
  return {{"item", to_string({Kind::limb, index, 0})},
          {"names", limb.names},
          {"hip", list(limb.hip)},
          {"step", list(limb.step)},
          {"copies", limb.names.size()},
          {"mirror", limb.mirrored},
          {"joints", joints},
          {"foot",
           {{"item", to_string({Kind::foot, index, 0})},
            {"module", limb.foot.name},
            {"at", list(at + limb.foot_offset)},
            {"offset", list(limb.foot_offset)}}}};
}

Json trunk_json(const Module& trunk) {
  const bool own = is_own_box(trunk);
  return {{"item", "trunk"},
          {"module", own ? Json(nullptr) : Json(trunk.name)},
          {"size", own ? list(trunk.outline.front().size) : Json(nullptr)},
          {"mass", trunk.mass}};
}

Json spots_json(const Assembly& assembly) {
  Json out = Json::array();
  for (const AssemblySpot& spot : assembly_spots(assembly)) {
    Json kinds = Json::array();
    for (std::size_t k = 0; k < kModuleKinds.size(); ++k)
      if (takes(spot, static_cast<ModuleKind>(k))) kinds.push_back(kModuleKinds[k]);
    out.push_back({{"id", spot.id},
                   {"words", spot.words},
                   {"takes", kinds},
                   {"begins_limb", spot.as == AssemblySpot::As::new_limb},
                   {"replaces", spot.as == AssemblySpot::As::replace},
                   {"at", list(spot.at)}});
  }
  return out;
}

}  // namespace

Json assembly_json(const Assembly& assembly, MeshStore& meshes) {
  ModelPointer model;
  Json design = drawn(assembly_xml(assembly, 0.0), assembly.name, meshes, &model);
  double mass = 0.0;
  for (int body = 0; body < static_cast<int>(model->nbody); ++body) mass += model->body_mass[body];
  Json parts = Json::array(), limbs = Json::array();
  for (std::size_t k = 0; k < assembly.parts.size(); ++k)
    parts.push_back({{"item", to_string({Kind::part, k, 0})},
                     {"module", assembly.parts[k].module.name},
                     {"at", list(assembly.parts[k].position)}});
  for (std::size_t k = 0; k < assembly.limbs.size(); ++k) limbs.push_back(limb_json(assembly, k));
  return {{"name", assembly.name},
          {"mass", mass},
          {"servos", static_cast<int>(model->nu)},
          {"trunk", trunk_json(assembly.trunk)},
          {"parts", parts},
          {"limbs", limbs},
          {"spots", spots_json(assembly)},
          {"design", std::move(design)},
          {"items", items_of_bodies(assembly, *model)}};
}

Json palette_json(const ModuleLibrary& library) {
  Json out = Json::array();
  for (const ModuleFile& file : library.modules()) {
    const Module& module = file.module;
    const auto& joint = module.joint;
    const auto& slide = module.slide;
    out.push_back({{"name", module.name},
                   {"kind", module.kind_name()},
                   {"maker", module.maker},
                   {"about", module.about},
                   {"mass", module.mass},
                   {"stall_torque", joint ? Json(joint->stall_torque) : Json(nullptr)},
                   {"no_load_speed", joint ? or_null(joint->no_load_speed) : Json(nullptr)},
                   {"max_force", slide ? Json(slide->most_force) : Json(nullptr)},
                   {"stroke", slide ? Json(slide->stroke) : Json(nullptr)},
                   {"rod_speed", slide ? or_null(slide->no_load_speed) : Json(nullptr)}});
  }
  return {{"modules", out}};
}

Json module_picture(const Module& module, MeshStore& meshes) {
  return drawn(module_scene(module), module.name, meshes, nullptr);
}

}  // namespace legwright
