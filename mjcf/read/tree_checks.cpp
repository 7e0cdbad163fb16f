// SPDX-License-Identifier: Apache-2.0
#include "mjcf/read/tree_checks.hpp"

#include <fmt/format.h>

#include <Eigen/Core>
#include <cmath>
#include <tuple>

#include "mjcf/read/checks.hpp"
#include "mjcf/read/world_parts.hpp"
#include "mjcf/text/compile.hpp"
#include "mjcf/text/model_arrays.hpp"
#include "mjcf/text/numbers.hpp"
#include "optimizer/design/morphology.hpp"

namespace legwright {
namespace {

constexpr double kWidestMesh = 20.0;  // [m]

/// The last element of a tag that has an attribute, as it is the one that holds; else the root.
const XmlElement& last_with(const XmlFile& xml, const char* tag, const char* name) {
  const XmlElement* found = &xml.root();
  for_each_element(xml.root(), [&](const XmlElement& element) {
    if (is_tag(element, tag) && has_attribute(element, name)) found = &element;
  });
  return *found;
}

/// MuJoCo puts the centre of a body without mass where the body itself is, once more: not on the
/// body. With boundmass it weighs something there, and what moves the body moves it twice.
void refuse_mass_from_nowhere(const XmlFile& xml, const mjModel& model, int trunk,
                              Refusals& reasons) {
  const XmlElement& compiler = last_with(xml, "compiler", "boundmass");
  const auto bound = parse_numbers(attribute(compiler, "boundmass"));
  if (!bound || bound->size() != 1 || !(bound->front() > 0.0)) return;
  for (int b = 1; b < model.nbody; ++b)
    if (model.body_rootid[b] == trunk && model.body_mass[b] == bound->front() &&
        model.body_inertia[std::ptrdiff_t{3} * b] == 0.0)
      reasons.add(
          xml.error(compiler, fmt::format("attribute boundmass: gives mass to body '{}', which has "
                                          "none; write its <inertial>, or remove boundmass",
                                          name_of(model, mjOBJ_BODY, b))));
}

/// What a gravity that is not the planner's tells of the file, and the cure.
std::string fault_of_gravity(const Eigen::Vector3d& gravity) {
  const double times = gravity.norm() / kGravity;
  for (const auto& [factor, unit, of_a_metre] :
       {std::tuple{100.0, "centimetres", 0.01}, {1000.0, "millimetres", 0.001}})
    if (std::abs(times / factor - 1.0) < 0.01)
      return fmt::format(
          "which is that of a file in {0}, but lengths are read in metres: multiply all lengths by "
          "{1} (positions, sizes, meshes by their scale; inertias by {1} squared; forces in their "
          "units likewise), then write 0 0 -{2}",
          unit, of_a_metre, kGravity);
  return fmt::format("but gaits are planned for 0 0 -{}; write that or remove the attribute",
                     kGravity);
}

/// The planner knows one gravity; with another the played gait would fall for no visible reason.
void check_gravity(const XmlFile& xml, const mjModel& model, Refusals& reasons) {
  if (model.opt.disableflags & mjDSBL_GRAVITY)
    reasons.add(xml.error(last_with(xml, "flag", "gravity"),
                          "attribute gravity: is switched off, but gaits are planned for gravity; "
                          "remove the attribute"));
  const mjtNum* g = model.opt.gravity;
  if (g[0] != 0.0 || g[1] != 0.0 || std::abs(g[2] + kGravity) > 1e-9)
    reasons.add(xml.error(last_with(xml, "option", "gravity"),
                          fmt::format("attribute gravity: {} {} {}, {}", g[0], g[1], g[2],
                                      fault_of_gravity(Eigen::Vector3d(g[0], g[1], g[2])))));
  for (int b = 1; b < model.nbody; ++b)
    if (model.body_gravcomp[b] != 0.0)
      reasons.add(error_at(xml, model, mjOBJ_BODY, b,
                           "attribute gravcomp: gaits are planned for bodies with their full "
                           "weight; remove it"));
}

/// Meshes in millimetres, of which nobody told MuJoCo: one sentence, not one for each.
void refuse_huge_meshes(const XmlFile& xml, const mjModel& model, int trunk, Refusals& reasons) {
  for (int g = 0; g < model.ngeom; ++g) {
    if (model.geom_type[g] != mjGEOM_MESH || model.body_rootid[model.geom_bodyid[g]] != trunk)
      continue;
    const double wide = 2.0 * vector_at(model.geom_aabb, 2 * g + 1).maxCoeff();
    if (wide < kWidestMesh) continue;
    reasons.add(error_at(
        xml, model, mjOBJ_GEOM, g,
        fmt::format("its mesh '{}' is {:.3g} m wide; where meshes are in millimetres, each "
                    "needs scale=\"0.001 0.001 0.001\" (in a URDF in its <mesh>)",
                    name_of(model, mjOBJ_MESH, model.geom_dataid[g]), wide)));
    return;
  }
}

/// MuJoCo fills up keyframes that are too short.
void check_keyframes(const XmlFile& xml, const mjModel& model, Refusals& reasons) {
  for_each_element(xml.root(), [&](const XmlElement& element) {
    if (!is_tag(element, "key")) return;
    for (const auto& [name, count] : {std::pair{"qpos", model.nq}, {"qvel", model.nv}}) {
      if (!has_attribute(element, name)) continue;
      const std::size_t given = parse_numbers(attribute(element, name))->size();
      if (given != static_cast<std::size_t>(count))
        reasons.add(xml.error(element, fmt::format("attribute {}: {} numbers, the robot has {}",
                                                   name, given, count)));
    }
  });
}

void refuse_section(const XmlFile& xml, int count, const char* section, const char* what,
                    Refusals& reasons) {
  if (count == 0) return;
  const XmlElement* element = xml.root().FirstChildElement(section);
  const XmlElement& place =
      element && element->FirstChildElement() ? *element->FirstChildElement() : xml.root();
  reasons.add(
      xml.error(place, fmt::format("{}; the planner knows trees of hinges only: remove it", what)));
}

}  // namespace

std::string fault_of_name(const std::string& name) {
  if (name.empty()) return "has no name; trajectories name it, give it one";
  if (name.find_first_of(kNoNameSigns) != std::string::npos)
    return "the name holds a blank or one of ; , | ~ ^, which trajectories and parameters cannot "
           "name; "
           "rename it";
  return "";
}

int find_trunk(const XmlFile& xml, const mjModel& model, Refusals& reasons) {
  if (model.nbody > 256) {
    reasons.add(xml.error(xml.root(), "more than 256 bodies; this is no robot"));
    return -1;
  }
  const int trunk = trunk_of(model);
  if (trunk < 0) {
    const XmlElement* const world = xml.root().FirstChildElement("worldbody");
    reasons.add(xml.error(world ? *world : xml.root(),
                          "no body has a free joint; add <freejoint/> to the trunk"));
    return -1;
  }
  const std::string name = name_of(model, mjOBJ_BODY, trunk);
  for (int j = 0; j < model.njnt; ++j) {
    const int body = model.jnt_bodyid[j];
    if (model.jnt_type[j] != mjJNT_FREE || body == trunk || moves_beside(model, body)) continue;
    reasons.add(error_at(
        xml, model, mjOBJ_BODY, body,
        fmt::format("a second free root with joints besides body '{}'; a file holds one robot, "
                    "remove the other",
                    name)));
  }
  if (name.empty())
    reasons.add(error_at(
        xml, model, mjOBJ_BODY, trunk,
        "has the free joint but no name; give it one, like name=\"trunk\", as legwright init "
        "--write does"));
  return trunk;
}

void check_surroundings(const XmlFile& xml, const mjModel& model, int trunk, Refusals& reasons) {
  for (int j = 0; j < model.njnt; ++j) {
    const int body = model.jnt_bodyid[j], root = model.body_rootid[body];
    const bool floats = model.body_jntnum[root] > 0 &&
                        model.jnt_type[model.body_jntadr[root]] == mjJNT_FREE;  // told above
    if (root != trunk && !floats && !moves_beside(model, root))
      reasons.add(error_at(xml, model, mjOBJ_JOINT, j,
                           "moves a body that does not hang on the trunk; hang it there or remove "
                           "it"));
    if (body == trunk && model.jnt_type[j] != mjJNT_FREE)
      reasons.add(error_at(xml, model, mjOBJ_JOINT, j,
                           "the trunk has a free joint and no other; remove this one"));
  }
  refuse_section(xml, static_cast<int>(model.nmocap), "worldbody",
                 "mocap bodies are moved from outside", reasons);
  check_gravity(xml, model, reasons);
  refuse_mass_from_nowhere(xml, model, trunk, reasons);
  refuse_huge_meshes(xml, model, trunk, reasons);
  check_keyframes(xml, model, reasons);
}

bool check_leg_joint(const XmlFile& xml, const mjModel& model, int j, Refusals& reasons) {
  const auto fault = [&](const std::string& message) {
    reasons.add(error_at(xml, model, mjOBJ_JOINT, j, message));
    return false;
  };
  if (model.jnt_type[j] == mjJNT_SLIDE)
    return fault("slide joints are not supported in limbs; use a hinge");
  if (model.jnt_type[j] == mjJNT_BALL)
    return fault("ball joints are not supported in limbs; use three hinges in one body");
  const std::string name = name_of(model, mjOBJ_JOINT, j);
  if (name.empty())
    return fault(
        "has no name, by which trajectories and its actuator call it; give it one, and an "
        "actuator");
  if (const std::string why = fault_of_name(name); !why.empty()) fault(why);
  return true;
}

}  // namespace legwright
