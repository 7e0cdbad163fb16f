// SPDX-License-Identifier: Apache-2.0
#include "mjcf/propose/home_touches.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "mjcf/propose/module_overlaps.hpp"
#include "mjcf/read/declared_modules.hpp"
#include "mjcf/read/moving_parts.hpp"
#include "mjcf/text/compile.hpp"
#include "mjcf/text/listed.hpp"
#include "mjcf/text/robot_files.hpp"

namespace legwright {
namespace {

constexpr double kDeep = 1e-6;          // [m]: less is rounding
constexpr double kOverlap = 1e-4;       // [m]: less does not push a robot
constexpr std::size_t kMostListed = 4;  // of them

using Depths = std::map<std::pair<int, int>, double>;  // of two geoms, the smaller id first [m]

Depths home_depths(const mjModel& model, const std::filesystem::path& file) {
  const DataPointer data = kinematics_at(model, home_qpos(model), file);
  call_engine(file, [&] { mj_forward(&model, data.get()); });
  Depths out;
  for (int c = 0; c < data->ncon; ++c) {
    const mjContact& contact = data->contact[c];
    if (contact.geom[0] < 0 || contact.geom[1] < 0 || contact.dist > -kDeep) continue;
    const auto fixed = [&](int geom) { return model.body_weldid[model.geom_bodyid[geom]] == 0; };
    if (fixed(contact.geom[0]) || fixed(contact.geom[1])) continue;
    double& depth = out[std::minmax({contact.geom[0], contact.geom[1]})];
    depth = std::max(depth, -contact.dist);
  }
  return out;
}

std::string describe_shape(const mjModel& model, int geom) {
  static const std::map<int, const char*> kinds{
      {mjGEOM_SPHERE, "a sphere"}, {mjGEOM_CAPSULE, "a capsule"},
      {mjGEOM_BOX, "a box"},       {mjGEOM_CYLINDER, "a cylinder"},
      {mjGEOM_MESH, "a mesh"},     {mjGEOM_ELLIPSOID, "an ellipsoid"}};
  const std::string name = name_of(model, mjOBJ_GEOM, geom);
  if (!name.empty()) return fmt::format("geom '{}'", name);
  const auto kind = kinds.find(model.geom_type[geom]);
  return kind == kinds.end() ? "a geom" : kind->second;
}

std::string describe_body(const mjModel& model, int body) {
  const std::string name = name_of(model, mjOBJ_BODY, body);
  return name.empty() ? "a body without name" : "'" + name + "'";
}

std::string describe_geom(const mjModel& model, int geom) {
  return describe_shape(model, geom) + " of " + describe_body(model, model.geom_bodyid[geom]);
}

/// Whether MuJoCo lets two bodies pass when the robot is played, where held joints are gone.
bool pass_when_played(const mjModel& model, const Structure& structure, int first, int second) {
  const int a = moving_body(model, structure, first), b = moving_body(model, structure, second);
  const auto above = [&](int body) {
    return moving_body(model, structure, model.body_parentid[body]);
  };
  if (a == b) return true;
  return (model.opt.disableflags & mjDSBL_FILTERPARENT) == 0 && (above(a) == b || above(b) == a);
}

std::set<int> geoms_of_modules(const mjModel& model) {
  std::set<int> out;
  for (const DeclaredModule& module : declared_modules(model))
    out.insert(module.geoms.begin(), module.geoms.end());
  return out;
}

ModelPointer compiled(const std::filesystem::path& file) {
  const RobotFiles files = RobotFiles::read(file);
  return files.at_their_lines([&] { return compile_mjcf(files.text(), files.file()); });
}

}  // namespace

std::vector<HomeTouch> new_home_touches(const mjModel& before, const mjModel& after,
                                        const std::filesystem::path& file) {
  const Depths then = home_depths(before, file), now = home_depths(after, file);
  std::vector<HomeTouch> out;
  for (const auto& [geoms, depth] : now)
    if (then.count(geoms) == 0)
      out.push_back({describe_geom(after, geoms.first), describe_geom(after, geoms.second), depth});
  std::stable_sort(out.begin(), out.end(),
                   [](const HomeTouch& a, const HomeTouch& b) { return a.depth > b.depth; });
  return out;
}

std::vector<HomeTouch> new_home_touches(const std::filesystem::path& before,
                                        const std::filesystem::path& after) {
  return new_home_touches(*compiled(before), *compiled(after), after);
}

std::vector<BodyTouch> touching_bodies(const mjModel& model, const std::filesystem::path& file) {
  Depths of_bodies;
  for (const auto& [geoms, depth] : home_depths(model, file)) {
    double& deepest =
        of_bodies[std::minmax(model.geom_bodyid[geoms.first], model.geom_bodyid[geoms.second])];
    deepest = std::max(deepest, depth);
  }
  std::vector<BodyTouch> out;
  for (const auto& [bodies, depth] : of_bodies) {
    BodyTouch touch{name_of(model, mjOBJ_BODY, bodies.first),
                    name_of(model, mjOBJ_BODY, bodies.second), depth};
    if (!touch.first.empty() && !touch.second.empty()) out.push_back(std::move(touch));
  }
  std::stable_sort(out.begin(), out.end(),
                   [](const BodyTouch& a, const BodyTouch& b) { return a.depth > b.depth; });
  return out;
}

std::vector<std::string> overlapping_links(const RobotModel& robot) {
  struct Pair {
    int first_geom, second_geom;
    double depth;
  };
  const ModelPointer model = compile_mjcf(robot.xml, robot.file);
  const std::set<int> of_modules = geoms_of_modules(*model);
  std::map<std::pair<int, int>, Pair> deepest;  // of two bodies
  for (const auto& [geoms, depth] : home_depths(*model, robot.file)) {
    const auto bodies =
        std::minmax({model->geom_bodyid[geoms.first], model->geom_bodyid[geoms.second]});
    const bool of_robot = model->body_rootid[bodies.first] == robot.structure.trunk &&
                          model->body_rootid[bodies.second] == robot.structure.trunk;
    const bool is_told = depth >= kToldOverlap && of_modules.count(geoms.first) > 0 &&
                         of_modules.count(geoms.second) > 0;
    if (!of_robot || is_told || depth < kOverlap ||
        pass_when_played(*model, robot.structure, bodies.first, bodies.second))
      continue;
    const bool ordered = model->geom_bodyid[geoms.first] == bodies.first;
    const Pair found{ordered ? geoms.first : geoms.second, ordered ? geoms.second : geoms.first,
                     depth};
    const auto known = deepest.emplace(bodies, found).first;
    if (known->second.depth < depth) known->second = found;
  }
  if (deepest.empty()) return {};
  std::vector<Pair> pairs;
  for (const auto& [bodies, pair] : deepest) pairs.push_back(pair);
  std::stable_sort(pairs.begin(), pairs.end(),
                   [](const Pair& a, const Pair& b) { return a.depth > b.depth; });
  std::vector<std::string> told;
  for (const Pair& pair : pairs)
    told.push_back(fmt::format(
        "{} is {:.2g} mm inside {}{} ({} in {})",
        describe_body(*model, model->geom_bodyid[pair.second_geom]), 1e3 * pair.depth,
        describe_body(*model, model->geom_bodyid[pair.first_geom]),
        told.empty() ? " in the home pose" : "", describe_shape(*model, pair.second_geom),
        describe_shape(*model, pair.first_geom)));
  const auto name = [&](int geom) { return name_of(*model, mjOBJ_BODY, model->geom_bodyid[geom]); };
  const std::string cure =
      of_modules.empty()
          ? fmt::format(
                "give {} an <exclude body1=\"{}\" body2=\"{}\"/> in <contact>, or make one "
                "smaller",
                told.size() == 1 ? "them" : "each two", name(pairs[0].first_geom),
                name(pairs[0].second_geom))
          : "move them apart in the robot's assembly by hip, step or offset, and build it anew";
  return {fmt::format("{}: what is played pushes them apart, whatever the gait; {}",
                      listed(told, kMostListed, "; "), cure)};
}

std::string describe(const std::vector<HomeTouch>& touches) {
  if (touches.empty()) return "";
  std::vector<std::string> pairs;
  pairs.reserve(touches.size());
  for (const HomeTouch& touch : touches)
    pairs.push_back(
        fmt::format("{} and {}, {:.2g} mm deep", touch.first, touch.second, 1e3 * touch.depth));
  return fmt::format(
      "in its home pose the designed body touches itself where the initial one does not: {}; "
      "narrow the bounds of what brought them together ([design.bounds] of the task)",
      listed(pairs, kMostListed, "; "));
}

}  // namespace legwright
