// SPDX-License-Identifier: Apache-2.0
// A part that is bought or printed once, of which robots are assembled.
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace legwright {

enum class ModuleKind { servo, linear, foot, trunk, battery, computer, payload };

/// In the order of the enumerators.
inline constexpr std::array<std::string_view, 7> kModuleKinds{
    "servo", "linear", "foot", "trunk", "battery", "computer", "payload"};

/// A box, a cylinder or a ball of a module's outline, in the module's frame.
struct OutlineShape {
  enum class Type { box, cylinder, sphere };
  Type type = Type::box;
  /// [m] box: widths along x, y and z; cylinder: radius and length; sphere: radius.
  Eigen::Vector3d size = Eigen::Vector3d::Zero();
  Eigen::Vector3d position = Eigen::Vector3d::Zero();  // of its middle [m]
  Eigen::Vector3d axis = Eigen::Vector3d::UnitZ();     // of a cylinder, a unit vector
  bool on_rod = false;  // of a linear actuator: goes with its rod, drawn retracted

  /// [m3]
  double volume() const;
  /// Inertia of a body of this shape and unit mass about its middle, in the module's axes [m2].
  Eigen::Matrix3d unit_inertia() const;
  /// Module ← shape: z is a cylinder's axis; of others the module's own axes.
  Eigen::Isometry3d pose() const;
  /// Half its extents along the axes of pose() [m].
  Eigen::Vector3d half() const;
};

/// What turns: the output of a servo, at which all figures hold, behind its gears.
struct ModuleJoint {
  Eigen::Vector3d position = Eigen::Vector3d::Zero();  // where horn and axis meet [m]
  Eigen::Vector3d axis = Eigen::Vector3d::UnitZ();     // out of the module, a unit vector
  double stall_torque = 0.0;                           // or peak torque [N m]
  std::optional<double> continuous_torque;             // [N m]
  std::optional<double> no_load_speed;                 // [rad/s]
  std::optional<double> gear_ratio;
  std::optional<double> reflected_inertia;  // rotor inertia times the square of the ratio [kg m2]
  std::optional<double> friction;           // dry friction [N m]
  std::optional<double> damping;            // [N m s/rad]
  std::optional<std::array<double, 2>> range;  // of the angle [rad]
  std::optional<double> kp, kd;                // advice [N m/rad], [N m s/rad]
};

/// What slides: the rod of a linear actuator, between a pivot on its body and one at the rod's end.
struct ModuleSlide {
  Eigen::Vector3d position = Eigen::Vector3d::Zero();  // of the pivot on the body [m]
  Eigen::Vector3d axis = Eigen::Vector3d::UnitZ();     // from there to the rod's, a unit vector
  double retracted = 0.0;                              // between the pivots [m]
  double stroke = 0.0;                                 // [m]
  double most_force = 0.0;                             // that it moves, pushing or pulling [N]
  std::optional<double> stall_force;       // where its line of force and speed begins [N]
  std::optional<double> continuous_force;  // [N]
  std::optional<double> no_load_speed;     // [m/s]
  std::optional<double> backdrive_force;   // that moves it without power [N]
  std::optional<double> gear_ratio;
  std::optional<double> reflected_mass;  // of the rotor, as the rod feels it [kg]
  std::optional<double> kp, kd;          // advice [N/m], [N s/m]

  double middle() const { return retracted + 0.5 * stroke; }              // [m]
  double extended() const { return retracted + stroke; }                  // [m]
  double line_force() const { return stall_force.value_or(most_force); }  // [N]
};

/// Where another part is fixed.
struct Attachment {
  std::string name;
  bool on_horn = false;                                // or rod; else on the body
  Eigen::Vector3d position = Eigen::Vector3d::Zero();  // [m]
  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();   // out of the module, a unit vector
  std::string screws;                                  // their size, "M2"; empty: not known
  std::vector<Eigen::Vector3d> holes{};                // where they go in [m]
};

/// Sizes of screws that are known here, as files name them.
inline constexpr std::array<std::string_view, 8> kScrewSizes{"M1.6", "M2", "M2.5", "M2.6",
                                                             "M3",   "M4", "M5",   "M6"};
/// Diameters of their holes [m], with play: ISO 273, medium.
inline constexpr std::array<double, 8> kScrewHoles{1.8e-3, 2.4e-3, 2.9e-3, 3.0e-3,
                                                   3.4e-3, 4.5e-3, 5.5e-3, 6.6e-3};

/// A module in its own frame. SI units.
struct Module {
  std::string name;
  ModuleKind kind = ModuleKind::servo;
  std::string maker, about;
  double mass = 0.0;              // [kg]
  std::optional<double> voltage;  // at which torques and speed hold [V]
  std::optional<double> price;    // of one, in whatever currency all prices are
  std::vector<OutlineShape> outline;
  std::optional<ModuleJoint> joint;  // of a servo
  std::optional<ModuleSlide> slide;  // of a linear actuator
  std::optional<double> friction;    // of a foot's sliding
  std::vector<Attachment> attachments;
  std::vector<std::string> cable;  // attachments at which cables leave

  std::string_view kind_name() const { return kModuleKinds[static_cast<std::size_t>(kind)]; }
  /// Whether it turns a joint of a limb.
  bool is_drive() const { return kind == ModuleKind::servo || kind == ModuleKind::linear; }
};

/// The box around all of a module's outline, along its axes [m].
struct ModuleExtent {
  Eigen::Vector3d half = Eigen::Vector3d::Zero(), middle = Eigen::Vector3d::Zero();
};
ModuleExtent extent_of(const Module& module);

/// Mass distribution of a module whose outline is filled evenly.
struct ModuleInertia {
  double mass = 0.0;                                      // [kg]
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();       // [m]
  Eigen::Matrix3d inertia = Eigen::Matrix3d::Identity();  // about the centre [kg m2]
};
ModuleInertia inertia_of(const Module& module);

/// A linear actuator without its rod: the shapes of its body with their share of the mass.
Module without_rod(const Module& module);
/// The radius of its rod, by the thinnest shape of it [m]; nothing where none is in the outline.
std::optional<double> rod_radius(const Module& module);

/// Where a module stands in a body: turned and moved, perhaps mirrored in the x-z plane after that.
struct ModulePlace {
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();  // body ← module
  bool mirrored = false;

  Eigen::Vector3d point(const Eigen::Vector3d& of_module) const;
  Eigen::Vector3d direction(const Eigen::Vector3d& of_module) const;
};

/// Numbers as an attribute of MJCF: rounded() and with one blank between them.
std::string rounded_words(const Eigen::Ref<const Eigen::VectorXd>& values);

/// The outline as MJCF, a <geom> each. @param attributes of all of them, ` material="servo"`
std::vector<std::string> outline_geoms(const Module& module, const ModulePlace& place,
                                       const std::string& attributes);
/// The module's <inertial>.
std::string inertial_element(const Module& module, const ModulePlace& place);

/// A scene of the module alone, in which the output axis and the attachments are marked: for a
/// picture of it.
std::string module_scene(const Module& module);

}  // namespace legwright
