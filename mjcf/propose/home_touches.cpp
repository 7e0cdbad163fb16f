// SPDX-License-Identifier: Apache-2.0
#include "mjcf/propose/home_touches.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <map>
#include <optional>
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

constexpr double kDeep = 1e-6;           // [m]: less is rounding
constexpr double kOverlap = 1e-4;        // [m]: less does not push a robot
constexpr std::size_t kMostListed = 4;   // of them
constexpr std::size_t kMostBetween = 3;  // hinges of a limb between two links
constexpr double kUnlimited = 1.0;       // [rad] each way, of a hinge without a range

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

/// Whether module_overlaps() tells of two geoms.
bool is_told_of_modules(const std::set<int>& of_modules, const std::pair<int, int>& geoms,
                        double depth) {
  return depth >= kToldOverlap && of_modules.count(geoms.first) > 0 &&
         of_modules.count(geoms.second) > 0;
}

/// Of two bodies the two geoms that are deepest in each other; `first` is of the lower body id.
struct GeomPair {
  int first, second;
  double depth;
};

/// Links that overlap in the home pose and collide when the robot is played, by their bodies.
std::map<std::pair<int, int>, GeomPair> overlapping_pairs(const RobotModel& robot,
                                                          const mjModel& model,
                                                          const std::set<int>& of_modules) {
  std::map<std::pair<int, int>, GeomPair> deepest;
  for (const auto& [geoms, depth] : home_depths(model, robot.file)) {
    const auto bodies =
        std::minmax({model.geom_bodyid[geoms.first], model.geom_bodyid[geoms.second]});
    const bool of_robot = model.body_rootid[bodies.first] == robot.structure.trunk &&
                          model.body_rootid[bodies.second] == robot.structure.trunk;
    if (!of_robot || is_told_of_modules(of_modules, geoms, depth) || depth < kOverlap ||
        pass_when_played(model, robot.structure, bodies.first, bodies.second))
      continue;
    const bool ordered = model.geom_bodyid[geoms.first] == bodies.first;
    const GeomPair found{ordered ? geoms.first : geoms.second, ordered ? geoms.second : geoms.first,
                         depth};
    const auto known = deepest.emplace(bodies, found).first;
    if (known->second.depth < depth) known->second = found;
  }
  return deepest;
}

/// The hinges by which `body` hangs on one above it; nothing where it does not, by others, or by
/// more than kMostBetween.
std::optional<std::vector<int>> hinges_between(const mjModel& model, int above, int body) {
  std::vector<int> out;
  for (; body != above; body = model.body_parentid[body]) {
    if (body == 0) return std::nullopt;
    for (int k = 0; k < model.body_jntnum[body]; ++k) {
      const int joint = model.body_jntadr[body] + k;
      if (model.jnt_type[joint] != mjJNT_HINGE || out.size() == kMostBetween) return std::nullopt;
      out.push_back(joint);
    }
  }
  return out;
}

/// Whether two bodies overlap in a pose.
bool overlap_at(const mjModel& model, mjData& data, const std::pair<int, int>& bodies) {
  mj_fwdPosition(&model, &data);
  for (int c = 0; c < data.ncon; ++c) {
    const mjContact& contact = data.contact[c];
    if (contact.geom[0] < 0 || contact.geom[1] < 0 || contact.dist > -kOverlap) continue;
    const int a = model.geom_bodyid[contact.geom[0]], b = model.geom_bodyid[contact.geom[1]];
    if (std::pair<int, int>(std::minmax(a, b)) == bodies) return true;
  }
  return false;
}

/// Whether they do wherever the hinges turn: at the ends and in the middle of each range.
bool overlap_everywhere(const mjModel& model, const std::filesystem::path& file,
                        const std::vector<int>& hinges, const std::pair<int, int>& bodies) {
  const DataPointer data = kinematics_at(model, home_qpos(model), file);
  std::size_t poses = 1;
  for (std::size_t k = 0; k < hinges.size(); ++k) poses *= 3;
  bool all = true;
  call_engine(file, [&] {
    for (std::size_t pose = 0; all && pose < poses; ++pose) {
      std::size_t rest = pose;
      for (const int joint : hinges) {
        const int at = model.jnt_qposadr[joint];
        const double home = home_qpos(model)[at];
        const bool limited = model.jnt_limited[joint] != 0;
        const mjtNum* const range = model.jnt_range + std::ptrdiff_t{2} * joint;
        const double low = limited ? range[0] : home - kUnlimited;
        const double high = limited ? range[1] : home + kUnlimited;
        data->qpos[at] = low + 0.5 * static_cast<double>(rest % 3) * (high - low);
        rest /= 3;
      }
      all = overlap_at(model, *data, bodies);
    }
  });
  return all;
}

/// Modules of a robot's assembly that stand inside each other, whether MuJoCo collides them or not,
/// and did not before.
std::vector<HomeTouch> new_module_touches(const mjModel& before, const mjModel& after,
                                          const std::filesystem::path& file) {
  std::set<std::pair<std::string, std::string>> then;
  for (const ModuleOverlap& each : module_overlaps(before, file))
    then.emplace(each.first, each.second);
  std::vector<HomeTouch> out;
  for (const ModuleOverlap& each : module_overlaps(after, file))
    if (then.count({each.first, each.second}) == 0)
      out.push_back({fmt::format("module '{}'", each.first),
                     fmt::format("module '{}'", each.second), each.depth, true});
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
  const std::set<int> of_modules = geoms_of_modules(after);
  std::vector<HomeTouch> out = new_module_touches(before, after, file);
  for (const auto& [geoms, depth] : now)
    if (then.count(geoms) == 0 && !is_told_of_modules(of_modules, geoms, depth))
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

std::vector<BodyTouch> lasting_overlaps(const RobotModel& robot) {
  const ModelPointer model = compile_mjcf(robot.xml, robot.file);
  const std::set<int> of_modules = geoms_of_modules(*model);
  if (!of_modules.empty()) return {};  // those are moved apart in their assembly
  std::vector<BodyTouch> out;
  for (const auto& [bodies, pair] : overlapping_pairs(robot, *model, of_modules)) {
    BodyTouch touch{name_of(*model, mjOBJ_BODY, bodies.first),
                    name_of(*model, mjOBJ_BODY, bodies.second), pair.depth};
    const auto hinges = hinges_between(*model, bodies.first, bodies.second);
    if (!hinges || touch.first.empty() || touch.second.empty()) continue;
    if (overlap_everywhere(*model, robot.file, *hinges, bodies)) out.push_back(std::move(touch));
  }
  return out;
}

std::string excluded_words(const std::vector<BodyTouch>& touches) {
  std::vector<std::string> pairs;
  pairs.reserve(touches.size());
  for (const BodyTouch& touch : touches)
    pairs.push_back(
        fmt::format("'{}' in '{}' ({:.2g} mm)", touch.second, touch.first, 1e3 * touch.depth));
  return fmt::format(
      "shapes of one limb overlap wherever its joints turn: {}; an <exclude> in <contact> lets {} "
      "pass",
      listed(pairs, kMostListed), pairs.size() == 1 ? "them" : "each two");
}

std::vector<std::string> overlapping_links(const RobotModel& robot) {
  const ModelPointer model = compile_mjcf(robot.xml, robot.file);
  const std::set<int> of_modules = geoms_of_modules(*model);
  const auto deepest = overlapping_pairs(robot, *model, of_modules);
  if (deepest.empty()) return {};
  std::vector<GeomPair> pairs;
  pairs.reserve(deepest.size());
  for (const auto& [bodies, pair] : deepest) pairs.push_back(pair);
  std::stable_sort(pairs.begin(), pairs.end(),
                   [](const GeomPair& a, const GeomPair& b) { return a.depth > b.depth; });
  std::vector<std::string> told;
  told.reserve(pairs.size());
  for (const GeomPair& pair : pairs)
    told.push_back(
        fmt::format("{} is {:.2g} mm inside {}{} ({} in {})",
                    describe_body(*model, model->geom_bodyid[pair.second]), 1e3 * pair.depth,
                    describe_body(*model, model->geom_bodyid[pair.first]),
                    told.empty() ? " in the home pose" : "", describe_shape(*model, pair.second),
                    describe_shape(*model, pair.first)));
  const auto name = [&](int geom) { return name_of(*model, mjOBJ_BODY, model->geom_bodyid[geom]); };
  const std::string cure =
      of_modules.empty()
          ? fmt::format(
                "give {} an <exclude body1=\"{}\" body2=\"{}\"/> in <contact>, or make one "
                "smaller",
                told.size() == 1 ? "them" : "each two", name(pairs[0].first), name(pairs[0].second))
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
  const bool of_modules = std::any_of(touches.begin(), touches.end(),
                                      [](const HomeTouch& touch) { return touch.is_of_modules; });
  return fmt::format(
      "in its home pose the designed body touches itself where the initial one does not: {}; "
      "narrow the bounds of what brought them together ([design.bounds] of the task{})",
      listed(pairs, kMostListed, "; "),
      of_modules ? "; [print] in its assembly bounds links so that modules keep clear" : "");
}

}  // namespace legwright
