// SPDX-License-Identifier: Apache-2.0
#include "mjcf/write/model_diff.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <map>
#include <string_view>
#include <tuple>

#include "mjcf/read/bindings.hpp"
#include "mjcf/text/compile.hpp"
#include "mjcf/text/model_arrays.hpp"
#include "mjcf/text/numbers.hpp"

namespace legwright {
namespace {

/// Elements of one kind by a name that is found in the other model again.
using IdsByName = std::map<std::string, int>;

using Values = std::vector<double>;

constexpr double kSmallInertia = 1e-6;  // [kg m²]: that of a link of a palm-sized robot

/// Numbers that an element has, as many in both models as a rule.
struct Quantity {
  const char* name;
  const char* unit;
  Values (*at)(const mjModel& model, int id);
};

Values row(const mjtNum* array, int id, int width) {
  return {array + static_cast<std::ptrdiff_t>(id) * width,
          array + static_cast<std::ptrdiff_t>(id + 1) * width};
}

/// Infinite where there are not as many numbers.
double largest_difference(const Values& before, const Values& after) {
  if (before.size() != after.size()) return std::numeric_limits<double>::infinity();
  double largest = 0.0;
  for (std::size_t k = 0; k < before.size(); ++k) {
    const double one = std::abs(after[k] - before[k]);
    if (!(one <= largest)) largest = one;
    if (std::isnan(largest)) break;
  }
  return largest;
}

class Comparison {
 public:
  Comparison(const mjModel& before, const mjModel& after, double tolerance)
      : before_(before), after_(after), tolerance_(tolerance) {}

  void compare(const char* kind, mjtObj type, int count_before, int count_after,
               const std::vector<Quantity>& quantities) {
    const IdsByName ours = names(before_, type, count_before),
                    theirs = names(after_, type, count_after);
    for (const auto& [name, id] : ours) {
      const std::string element = fmt::format("{} '{}'", kind, name);
      const auto other = theirs.find(name);
      if (other == theirs.end()) {
        out_.push_back({element, "only in A", "", {}, {}, 0.0});
        continue;
      }
      if (type == mjOBJ_BODY) add_parent(element, id, other->second);
      for (const Quantity& quantity : quantities) add(element, quantity, id, other->second);
    }
    for (const auto& [name, id] : theirs)
      if (ours.count(name) == 0)
        out_.push_back({fmt::format("{} '{}'", kind, name), "only in B", "", {}, {}, 0.0});
  }

  std::vector<Difference> take() { return std::move(out_); }

 private:
  /// Unnamed geoms and sites are known by their body and their place on it.
  static IdsByName names(const mjModel& model, mjtObj type, int count) {
    IdsByName out;
    std::map<std::string, int> unnamed;
    for (int id = 0; id < count; ++id) {
      std::string name = name_of(model, type, id);
      if (name.empty()) {
        const int body = type == mjOBJ_GEOM    ? model.geom_bodyid[id]
                         : type == mjOBJ_SITE  ? model.site_bodyid[id]
                         : type == mjOBJ_JOINT ? model.jnt_bodyid[id]
                                               : -1;
        const std::string of = body < 0 ? "" : name_of(model, mjOBJ_BODY, body);
        name = fmt::format("{}#{}", of, ++unnamed[of]);
      }
      out.emplace(std::move(name), id);
    }
    return out;
  }

  void add_parent(const std::string& element, int a, int b) {
    const auto parent = [](const mjModel& model, int body) {
      return name_of(model, mjOBJ_BODY, model.body_parentid[body]);
    };
    if (parent(before_, a) != parent(after_, b))
      out_.push_back(
          {element,
           fmt::format("hangs on '{}', then on '{}'", parent(before_, a), parent(after_, b)),
           "",
           {},
           {},
           0.0});
  }

  void add(const std::string& element, const Quantity& quantity, int a, int b) {
    Difference found{
        element, quantity.name, quantity.unit, quantity.at(before_, a), quantity.at(after_, b),
        0.0};
    found.size = distance(found);
    if (!(found.size <= tolerance_)) out_.push_back(std::move(found));  // NaN is a difference
  }

  static double distance(const Difference& d) {
    const bool angle = std::string_view(d.unit) == "rad";
    if (d.before.size() != d.after.size()) return largest_difference(d.before, d.after);
    if (angle && d.before.size() == 4)
      return quaternion_of(d.before.data()).angularDistance(quaternion_of(d.after.data()));
    if (d.quantity == "axis") {
      const Eigen::Vector3d one = Eigen::Vector3d::Map(d.before.data()),
                            two = Eigen::Vector3d::Map(d.after.data());
      return std::atan2(one.cross(two).norm(), one.dot(two));
    }
    return largest_difference(d.before, d.after);
  }

  const mjModel &before_, &after_;
  const double tolerance_;
  std::vector<Difference> out_;
};

/// One number per degree of freedom of a joint.
Values per_dof(const mjModel& m, int joint, const mjtNum* array) {
  const int width = m.jnt_type[joint] == mjJNT_FREE ? 6 : m.jnt_type[joint] == mjJNT_BALL ? 3 : 1;
  return {array + m.jnt_dofadr[joint], array + m.jnt_dofadr[joint] + width};
}

const std::vector<Quantity> kBody{
    {"mass", "kg", [](const mjModel& m, int i) { return row(m.body_mass, i, 1); }},
    {"place", "m", [](const mjModel& m, int i) { return row(m.body_pos, i, 3); }},
    {"orientation", "rad", [](const mjModel& m, int i) { return row(m.body_quat, i, 4); }},
    {"centre of mass", "m", [](const mjModel& m, int i) { return row(m.body_ipos, i, 3); }},
    {"principal inertia", "kg m²",
     [](const mjModel& m, int i) { return row(m.body_inertia, i, 3); }},
    {"principal axes", "rad", [](const mjModel& m, int i) { return row(m.body_iquat, i, 4); }},
};
const std::vector<Quantity> kJoint{
    {"type", "", [](const mjModel& m, int i) { return Values{1.0 * m.jnt_type[i]}; }},
    {"axis", "rad", [](const mjModel& m, int i) { return row(m.jnt_axis, i, 3); }},
    {"anchor", "m", [](const mjModel& m, int i) { return row(m.jnt_pos, i, 3); }},
    {"range", "rad or m", [](const mjModel& m, int i) { return row(m.jnt_range, i, 2); }},
    {"limited", "", [](const mjModel& m, int i) { return Values{1.0 * m.jnt_limited[i]}; }},
    {"torque range", "N m or N",
     [](const mjModel& m, int i) { return row(m.jnt_actfrcrange, i, 2); }},
    {"stiffness", "N m/rad or N/m",
     [](const mjModel& m, int i) { return row(m.jnt_stiffness, i, 1); }},
    {"damping", "N m s/rad or N s/m",
     [](const mjModel& m, int i) { return per_dof(m, i, m.dof_damping); }},
    {"armature", "kg m² or kg",
     [](const mjModel& m, int i) { return per_dof(m, i, m.dof_armature); }},
    {"friction loss", "N m or N",
     [](const mjModel& m, int i) { return per_dof(m, i, m.dof_frictionloss); }},
};
const std::vector<Quantity> kGeom{
    {"type", "", [](const mjModel& m, int i) { return Values{1.0 * m.geom_type[i]}; }},
    {"place", "m", [](const mjModel& m, int i) { return row(m.geom_pos, i, 3); }},
    {"orientation", "rad", [](const mjModel& m, int i) { return row(m.geom_quat, i, 4); }},
    {"size", "m", [](const mjModel& m, int i) { return row(m.geom_size, i, 3); }},
    {"collides with", "",
     [](const mjModel& m, int i) {
       return Values{1.0 * m.geom_contype[i], 1.0 * m.geom_conaffinity[i], 1.0 * m.geom_condim[i]};
     }},
    {"friction", "", [](const mjModel& m, int i) { return row(m.geom_friction, i, 3); }},
};
const std::vector<Quantity> kSite{
    {"place", "m", [](const mjModel& m, int i) { return row(m.site_pos, i, 3); }},
};
const std::vector<Quantity> kTendon{
    {"range", "m", [](const mjModel& m, int i) { return row(m.tendon_range, i, 2); }},
    {"stiffness", "N/m", [](const mjModel& m, int i) { return row(m.tendon_stiffness, i, 1); }},
};
const std::vector<Quantity> kActuator{
    {"force range", "N m or N",
     [](const mjModel& m, int i) { return row(m.actuator_forcerange, i, 2); }},
    {"gear", "",
     [](const mjModel& m, int i) { return row(m.actuator_gear, m.actuator_outadr[i], 6); }},
    {"gain", "", [](const mjModel& m, int i) { return row(m.actuator_gainprm, i, 3); }},
    {"bias", "", [](const mjModel& m, int i) { return row(m.actuator_biasprm, i, 3); }},
};
const std::vector<Quantity> kKey{
    {"qpos", "m and rad", [](const mjModel& m, int i) { return row(m.key_qpos, i, m.nq); }},
    {"time", "s", [](const mjModel& m, int i) { return row(m.key_time, i, 1); }},
};

/// Declared design parameters, as compiled: id of the number, and of what is said about it.
struct CompiledParameter {
  int numeric = -1;
  std::string unit, binding;
};

std::map<std::string, CompiledParameter> declared_in(const mjModel& model) {
  std::map<std::string, CompiledParameter> out;
  for (int id = 0; id < model.nnumeric; ++id) {
    const std::string name = name_of(model, mjOBJ_NUMERIC, id);
    if (name.compare(0, kDeclarationPrefix.size(), kDeclarationPrefix) != 0) continue;
    CompiledParameter found{id, "", ""};
    if (const int text = mj_name2id(&model, mjOBJ_TEXT, name.c_str()); text >= 0) {
      const std::string_view words = model.text_data + model.text_adr[text];
      const std::size_t first = words.find('|'), second = words.find('|', first + 1);
      found.unit = trimmed(words.substr(0, first));
      if (first != std::string_view::npos)
        found.binding = trimmed(words.substr(first + 1, second - first - 1));
    }
    out.emplace(name.substr(kDeclarationPrefix.size()), found);
  }
  return out;
}

Values numeric_values(const mjModel& model, int numeric, int begin, int end) {
  const mjtNum* const data = model.numeric_data + model.numeric_adr[numeric];
  const int size = model.numeric_size[numeric];
  return {data + std::min(begin, size), data + std::min(end, size)};
}

std::vector<Difference> parameter_differences(const mjModel& a, const mjModel& b,
                                              double tolerance) {
  std::vector<Difference> out;
  const auto ours = declared_in(a), theirs = declared_in(b);
  const auto whole = [&](const std::string& name, const std::string& what) {
    out.push_back({fmt::format("parameter '{}'", name), what, "", {}, {}, 0.0});
  };
  for (const auto& [name, one] : ours) {
    const auto found = theirs.find(name);
    if (found == theirs.end()) {
      whole(name, "only in A");
      continue;
    }
    const CompiledParameter& other = found->second;
    for (const auto& [what, begin, end] : {std::tuple("value", 0, 1), std::tuple("bounds", 1, 3)}) {
      Difference d{fmt::format("parameter '{}'", name),
                   what,
                   one.unit,
                   numeric_values(a, one.numeric, begin, end),
                   numeric_values(b, other.numeric, begin, end),
                   0.0};
      d.size = largest_difference(d.before, d.after);
      if (!(d.size <= tolerance)) out.push_back(std::move(d));
    }
    if (one.unit != other.unit || one.binding != other.binding)
      whole(name, fmt::format("is '{} | {}', then '{} | {}'", one.unit, one.binding, other.unit,
                              other.binding));
  }
  for (const auto& [name, one] : theirs)
    if (ours.count(name) == 0) whole(name, "only in B");
  return out;
}

}  // namespace

bool is_dust(const Difference& difference, double tolerance) {
  if (difference.whole()) return false;
  double scale = difference.unit == "kg m²" ? kSmallInertia : 1.0;
  for (const Values* values : {&difference.before, &difference.after})
    for (const double value : *values) scale = std::max(scale, std::abs(value));
  return difference.size <= tolerance * scale;  // NaN is none
}

std::vector<Difference> model_differences(const mjModel& a, const mjModel& b, double tolerance) {
  Comparison comparison(a, b, tolerance);
  comparison.compare("body", mjOBJ_BODY, a.nbody, b.nbody, kBody);
  comparison.compare("joint", mjOBJ_JOINT, a.njnt, b.njnt, kJoint);
  comparison.compare("geom", mjOBJ_GEOM, a.ngeom, b.ngeom, kGeom);
  comparison.compare("site", mjOBJ_SITE, a.nsite, b.nsite, kSite);
  comparison.compare("tendon", mjOBJ_TENDON, a.ntendon, b.ntendon, kTendon);
  comparison.compare("actuator", mjOBJ_ACTUATOR, a.nactuator, b.nactuator, kActuator);
  comparison.compare("key", mjOBJ_KEY, a.nkey, b.nkey, kKey);
  std::vector<Difference> out = comparison.take(),
                          declared = parameter_differences(a, b, tolerance);
  out.insert(out.end(), std::make_move_iterator(declared.begin()),
             std::make_move_iterator(declared.end()));
  return out;
}

}  // namespace legwright
