// SPDX-License-Identifier: Apache-2.0
#include "mjcf/urdf/mend_urdf.hpp"

#include <fmt/format.h>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <optional>

#include "mjcf/propose/doubtful_masses.hpp"
#include "mjcf/propose/doubtful_units.hpp"
#include "mjcf/shape/box_moments.hpp"
#include "mjcf/text/compile.hpp"
#include "mjcf/text/input_error.hpp"
#include "mjcf/text/model_arrays.hpp"
#include "mjcf/urdf/spec_elements.hpp"

namespace legwright {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

class BodyMender {
 public:
  BodyMender(mjSpec& spec, std::vector<std::string>& notes) : spec_(spec), notes_(notes) {}

  mjsBody& run(const std::filesystem::path& file) {
    forget_empty_masses();
    mjsBody& trunk = find_trunk();
    anchor_below(trunk);
    mend(trunk, true);
    if (!anchored_.empty())
      notes_.push_back(fmt::format(
          "joints of type floating hold no link to another, as the robot as a whole floats: {} {} "
          "fixed",
          fmt::join(anchored_, ", "), anchored_.size() == 1 ? "is" : "are"));
    if (!balanced_.empty())
      notes_.push_back(fmt::format(
          "no body has the moments of inertia of {} (one is more than the others together); each "
          "has their mean now, as MuJoCo's balanceinertia gives it",
          fmt::join(balanced_, ", ")));
    const bool several = massless_.size() > 1;
    if (!massless_.empty())
      throw InputError(
          file.string(), 0, several ? "links" : "link",
          fmt::format("{} {} and neither {} nor what is fixed there has an <inertial> with a mass "
                      "above 0; give mass and moments of inertia, without which no motion can be "
                      "planned",
                      fmt::join(massless_, ", "), several ? "move" : "moves",
                      several ? "they" : "it"));
    return trunk;
  }

 private:
  /// A mass of 0 is none, which is what exporters write for a frame.
  void forget_empty_masses() {
    for_each(spec_, mjOBJ_BODY, [](mjsElement* element) {
      mjsBody& body = *mjs_asBody(element);
      if (body.mass == 0.0) body.explicitinertial = 0;
    });
  }

  /// The first body below the world that weighs something, carries several, or floats.
  mjsBody& find_trunk() {
    mjsBody* trunk = mjs_findBody(&spec_, "world");
    while (count_of(*trunk, mjOBJ_BODY) == 1 && count_of(*trunk, mjOBJ_GEOM) == 0) {
      mjsBody& below = *mjs_asBody(mjs_firstChild(trunk, mjOBJ_BODY, 0));
      if (trunk->explicitinertial != 0 || count_of(*trunk, mjOBJ_JOINT) > 0) break;
      const bool is_link = trunk != mjs_findBody(&spec_, "world");
      if (is_link && is_turned(below)) break;  // its frame says what is up and ahead
      if (is_link)
        notes_.push_back(
            fmt::format("link '{}' has no mass and is left out: the robot floats at "
                        "its link '{}'",
                        element_name(trunk->element), element_name(below.element)));
      const bool hinged = is_hinged(below);
      trunk = &below;
      if (hinged) break;
    }
    return *trunk;
  }

  /// Whether a link is fixed to the one above it in another direction than that.
  static bool is_turned(mjsBody& body) {
    constexpr double kRounded = 1e-6;
    return !is_hinged(body) && std::abs(body.quat[0]) < 1.0 - kRounded;
  }

  static bool is_hinged(mjsBody& body) {
    bool hinged = false;
    for_each(body, mjOBJ_JOINT,
             [&](mjsElement* joint) { hinged = hinged || mjs_asJoint(joint)->type != mjJNT_FREE; });
    return hinged;
  }

  void mend(mjsBody& body, bool is_trunk) {
    const bool moves = is_trunk || count_of(body, mjOBJ_JOINT) > 0;
    if (moves && body.explicitinertial == 0) take_mass(body);
    if (body.explicitinertial != 0) balance(body);
    for_each(body, mjOBJ_BODY, [&](mjsElement* below) { mend(*mjs_asBody(below), false); });
  }

  /// MuJoCo lets no body float below another.
  void anchor_below(mjsBody& body) {
    for_each(body, mjOBJ_BODY, [&](mjsElement* below) {
      anchor(*mjs_asBody(below));
      anchor_below(*mjs_asBody(below));
    });
  }

  void anchor(mjsBody& body) {
    mjsElement* floating = nullptr;
    for_each(body, mjOBJ_JOINT, [&](mjsElement* joint) {
      if (mjs_asJoint(joint)->type == mjJNT_FREE) floating = joint;
    });
    if (floating == nullptr) return;
    anchored_.push_back(element_name(floating));
    mjs_delete(&spec_, floating);
  }

  /// A link and where it stands in the one that it is fixed to.
  struct FixedLink {
    mjsBody* body = nullptr;
    Eigen::Isometry3d place = Eigen::Isometry3d::Identity();
  };

  /// The heaviest link that is fixed to one, also over links between.
  static FixedLink heaviest_fixed_to(mjsBody& body) {
    FixedLink heaviest;
    for_each(body, mjOBJ_BODY, [&](mjsElement* element) {
      mjsBody& below = *mjs_asBody(element);
      if (count_of(below, mjOBJ_JOINT) > 0) return;
      const Eigen::Isometry3d place =
          Eigen::Translation3d(Vector3d(Vector3d::Map(below.pos))) * quaternion_of(below.quat);
      FixedLink found = heaviest_fixed_to(below);
      found.place = place * found.place;
      if (below.explicitinertial != 0 && (found.body == nullptr || below.mass > found.body->mass))
        found = {&below, place};
      if (found.body == nullptr) return;
      if (heaviest.body == nullptr || found.body->mass > heaviest.body->mass) heaviest = found;
    });
    return heaviest;
  }

  /// A link that moves and has no mass, as other readers want a base to be, gets that of the
  /// heaviest link which is fixed to it.
  void take_mass(mjsBody& body) {
    const auto [heaviest, place] = heaviest_fixed_to(body);
    if (heaviest == nullptr) {
      massless_.push_back(element_name(body.element));
      return;
    }
    const Eigen::Quaterniond axes(place.linear() * rotation_of(heaviest->iquat));
    const Vector3d centre = place * Vector3d(Vector3d::Map(heaviest->ipos));
    body.mass = heaviest->mass;
    std::copy_n(centre.data(), 3, body.ipos);
    const std::array<double, 4> q{axes.w(), axes.x(), axes.y(), axes.z()};
    std::copy_n(q.data(), 4, body.iquat);
    std::copy_n(heaviest->inertia, 3, body.inertia);
    std::copy_n(heaviest->fullinertia, 6, body.fullinertia);
    body.explicitinertial = 1;
    heaviest->explicitinertial = 0;
    notes_.push_back(
        fmt::format("link '{}' moves and has no mass: it gets that of '{}', which is "
                    "fixed to it",
                    element_name(body.element), element_name(heaviest->element)));
  }

  /// No body has moments of which one is more than the others together, and MuJoCo refuses them.
  /// Its own cure gives all three their mean.
  void balance(mjsBody& body) {
    const Matrix3d inertia = inertia_of_link(body);
    const Vector3d moments = Eigen::SelfAdjointEigenSolver<Matrix3d>(inertia).eigenvalues();
    if (moments[0] + moments[1] >= moments[2]) return;
    constexpr std::array<double, 4> kUnturned{1, 0, 0, 0};
    std::copy_n(kUnturned.data(), 4, body.iquat);
    std::fill_n(body.inertia, 3, inertia.trace() / 3.0);
    body.fullinertia[0] = std::nan("");
    balanced_.push_back(element_name(body.element));
  }

  mjSpec& spec_;
  std::vector<std::string>& notes_;
  std::vector<std::string> balanced_, massless_, anchored_;
};

}  // namespace

UrdfMending mending_of(const RobotModel& robot, const std::vector<std::string>& without_moments) {
  const ModelPointer model = compile_mjcf(robot.xml, robot.file);
  std::vector<std::string> boxed = without_moments;
  for (std::string& wide : wide_inertias(robot)) boxed.push_back(std::move(wide));
  UrdfMending out{2.0 * carrying_torque(robot.morphology), touching_bodies(*model, robot.file), {}};
  const DataPointer data = kinematics_at(*model, nullptr, robot.file);
  for (const std::string& name : boxed) {
    const int body = mj_name2id(model.get(), mjOBJ_BODY, name.c_str());
    if (const auto moments = body < 0 ? std::nullopt : box_moments(*model, *data, body))
      out.moments[name] = *moments;
  }
  return out;
}

mjsBody& mend_bodies(mjSpec& spec, const std::filesystem::path& file,
                     std::vector<std::string>& notes) {
  return BodyMender(spec, notes).run(file);
}

Matrix3d inertia_of_link(const mjsBody& body) {
  Matrix3d inertia = Matrix3d::Zero();
  if (std::isnan(body.fullinertia[0])) {
    inertia.diagonal() = Vector3d::Map(body.inertia);
  } else {
    const double* const f = body.fullinertia;
    inertia << f[0], f[3], f[4], f[3], f[1], f[5], f[4], f[5], f[2];
  }
  const double* const q = body.iquat;
  if (!differs(q, {1, 0, 0, 0})) return inertia;
  const Matrix3d axes = rotation_of(q);
  return axes * inertia * axes.transpose();
}

}  // namespace legwright
