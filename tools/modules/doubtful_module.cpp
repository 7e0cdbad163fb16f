// SPDX-License-Identifier: Apache-2.0
#include "tools/modules/doubtful_module.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <numbers>
#include <string_view>
#include <utility>

#include "tools/modules/doubts.hpp"

namespace legwright {
namespace {

using Eigen::Vector3d;

// Beside each limit what the library has.
constexpr double kLeastDensity = 50.0;      // [kg/m3]; 540
constexpr double kMostTorque = 160.0;       // [N m/kg]; 17 to 64, as kg cm 170 to 650
constexpr double kMostPower = 2000.0;       // [W/kg], of torque and speed in their middle; 670
constexpr double kMostMotorSpeed = 6000.0;  // [rad/s], before the gears; 3100
constexpr double kSmallServo = 0.2;         // [kg]
constexpr double kMostSmallSpeed = 40.0;    // [rad/s] of small servos; 13.5
constexpr double kMostOff = 0.5;            // off the outline, of its diagonal; 0.07
constexpr double kNearlyOn = 0.1;           // the same of a place that could be meant
constexpr double kMostRodSpeed = 1.0;       // [m/s]; 0.08
constexpr double kMostStroke = 2.0;         // of the retracted length; 0.42
// What the library has in the middle.
constexpr double kUsualTorque = 35.0;                         // [N m/kg]
constexpr double kUsualSmallSpeed = 7.0, kUsualSpeed = 45.0;  // [rad/s]

using Unit = std::pair<double, std::string_view>;
constexpr std::array<Unit, 3> kTorques{{{0.01, "N cm"}, {0.0980665, "kg cm"}, {0.001, "N mm"}}};
constexpr std::array<Unit, 2> kSpeeds{
    {{std::numbers::pi / 30.0, "rev/min"}, {std::numbers::pi / 180.0, "degrees/s"}}};

/// Of units that may be meant the one by which a figure is nearest to what is usual.
template <std::size_t N>
std::string meant(double value, double usual, const std::array<Unit, N>& units, const char* unit) {
  const Unit* best = &units[0];
  const auto off = [&](const Unit& each) { return std::abs(std::log(value * each.first / usual)); };
  for (const Unit& each : units)
    if (off(each) < off(*best)) best = &each;
  return fmt::format("{:.4g} {} are {:.4g} {}", value, best->second, value * best->first, unit);
}

class ModuleDoubts {
 public:
  ModuleDoubts(const Module& module, const toml::table& toml, const std::filesystem::path& file)
      : module_(module), extent_(extent_of(module)), doubts_(toml, file) {}

  std::vector<std::string> run() {
    check_density();
    if (module_.joint) check_joint(*module_.joint);
    if (module_.slide) check_slide(*module_.slide);
    for (std::size_t k = 0; k < module_.attachments.size(); ++k) {
      const std::string place = fmt::format("attachment[{}].", k);
      check_place(place + "position", module_.attachments[k].position);
      doubts_.check_angles(place + "turn");
    }
    return doubts_.all();
  }

 private:
  void check_density() {
    double volume = 0.0;
    for (const OutlineShape& shape : module_.outline) volume += shape.volume();
    const double least = module_.kind == ModuleKind::trunk ? kLeastTrunkDensity : kLeastDensity;
    doubts_.check_density(module_.mass, volume, least, "mass", "outline[0].size");
  }

  void check_joint(const ModuleJoint& joint) {
    check_place("joint.position", joint.position);
    doubts_.check_angles("joint.range");
    const double torque = joint.stall_torque / module_.mass;
    if (torque > kMostTorque)
      doubts_.add(
          "joint.stall_torque",
          fmt::format("is {:.4g} N m of a servo of {:.4g} kg, {} N m/kg, where servos "
                      "have up to 65; {}",
                      joint.stall_torque, module_.mass, figure_text(torque),
                      meant(joint.stall_torque, kUsualTorque * module_.mass, kTorques, "N m")));
    if (joint.no_load_speed) check_speed(joint, torque > kMostTorque);
  }

  void check_speed(const ModuleJoint& joint, bool torque_told) {
    const double speed = *joint.no_load_speed, power = 0.25 * joint.stall_torque * speed;
    const double of_motor = speed * joint.gear_ratio.value_or(1.0);
    const bool small = module_.mass < kSmallServo;
    std::string odd;
    if (of_motor > kMostMotorSpeed)
      odd = fmt::format("and {} of the motor before its gears, where motors have up to 3000",
                        figure_text(of_motor));
    else if (small && speed > kMostSmallSpeed)
      odd = "where servos of its size have up to 14";
    else if (!torque_told && power > kMostPower * module_.mass)
      odd = fmt::format("which with its torque is {} W/kg, where servos have up to 700",
                        figure_text(power / module_.mass));
    if (odd.empty()) return;
    doubts_.add(
        "joint.no_load_speed",
        fmt::format("is {:.4g} rad/s, {}; {}", speed, odd,
                    meant(speed, small ? kUsualSmallSpeed : kUsualSpeed, kSpeeds, "rad/s")));
  }

  void check_slide(const ModuleSlide& slide) {
    check_place("slide.position", slide.position);
    if (slide.no_load_speed && *slide.no_load_speed > kMostRodSpeed)
      doubts_.add("slide.no_load_speed",
                  fmt::format("is {0:.4g} m/s of the rod, where linear actuators have up to 0.1; "
                              "{0:.4g} mm/s are {1:.4g} m/s",
                              *slide.no_load_speed, 1e-3 * *slide.no_load_speed));
    if (slide.stroke > kMostStroke * slide.retracted)
      doubts_.add("slide.stroke",
                  fmt::format("is {0:.4g} m of an actuator that is {1:.4g} m long with its rod in; "
                              "{0:.4g} cm are {2:.4g} m",
                              slide.stroke, slide.retracted, 1e-2 * slide.stroke));
  }

  /// How far a place is from the box around the outline [m].
  double off_outline(const Vector3d& place) const {
    return ((place - extent_.middle).cwiseAbs() - extent_.half).cwiseMax(0.0).norm();
  }

  /// How deep a place is within that box [m]; horns and attachments are near its faces.
  double depth(const Vector3d& place) const {
    return (extent_.half - (place - extent_.middle).cwiseAbs()).minCoeff();
  }

  void check_place(const std::string& key, const Vector3d& place) {
    const double diagonal = 2.0 * extent_.half.norm(), off = off_outline(place);
    if (off <= kMostOff * diagonal) return;
    const std::string other = shorter_vectors(place, [&](const Vector3d& each) {
      return off_outline(each) < kNearlyOn * diagonal && depth(each) < kNearlyOn * diagonal;
    });
    doubts_.add(key,
                fmt::format("is {:.4g} m away from the outline of {} m; {}", off,
                            vector_text(2.0 * extent_.half), other.empty() ? "check both" : other));
  }

  const Module& module_;
  const ModuleExtent extent_;
  Doubts doubts_;
};

}  // namespace

std::vector<std::string> doubts_on_module(const Module& module, const toml::table& toml,
                                          const std::filesystem::path& file) {
  return ModuleDoubts(module, toml, file).run();
}

}  // namespace legwright
