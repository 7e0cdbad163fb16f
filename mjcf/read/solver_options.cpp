// SPDX-License-Identifier: Apache-2.0
#include "mjcf/read/solver_options.hpp"

#include <fmt/format.h>

#include <functional>

namespace legwright {
namespace {

/// What scenes have in place of MuJoCo's defaults.
mjOption scene_options(double time_step) {
  mjOption option;
  mj_defaultOption(&option);
  option.timestep = time_step;
  option.integrator = mjINT_IMPLICITFAST;
  option.cone = mjCONE_ELLIPTIC;
  option.impratio = 10;
  return option;
}

struct SolverSetting {
  const char* name;
  std::function<std::string(const mjOption&)> text;  // as in MJCF
  bool always = false;                               // whether each scene writes it
};

/// The flag as MJCF has it: `enable` or `disable`.
SolverSetting disabling(const char* name, int bit) {
  return {name, [bit](const mjOption& option) -> std::string {
            return (option.disableflags & bit) != 0 ? "disable" : "enable";
          }};
}

template <class Number>
SolverSetting number_of(const char* name, Number mjOption::*member, bool always = false) {
  return {name,
          [member](const mjOption& option) { return fmt::format("{:g}", 1.0 * option.*member); },
          always};
}

SolverSetting word_of(const char* name, int mjOption::*member, std::vector<std::string> words,
                      bool always = false) {
  return {name,
          [member, words = std::move(words)](const mjOption& option) {
            const auto at = static_cast<std::size_t>(option.*member);
            return at < words.size() ? words[at] : std::string("unknown");
          },
          always};
}

const std::vector<SolverSetting>& attributes() {
  static const std::vector<SolverSetting> table{
      number_of("timestep", &mjOption::timestep, true),
      word_of("integrator", &mjOption::integrator, {"Euler", "RK4", "implicit", "implicitfast"},
              true),
      word_of("cone", &mjOption::cone, {"pyramidal", "elliptic"}, true),
      number_of("impratio", &mjOption::impratio, true),
      word_of("jacobian", &mjOption::jacobian, {"dense", "sparse", "auto"}),
      word_of("solver", &mjOption::solver, {"PGS", "CG", "Newton"}),
      number_of("iterations", &mjOption::iterations),
      number_of("tolerance", &mjOption::tolerance),
      number_of("ls_iterations", &mjOption::ls_iterations),
      number_of("ls_tolerance", &mjOption::ls_tolerance),
      number_of("noslip_iterations", &mjOption::noslip_iterations),
      number_of("ccd_iterations", &mjOption::ccd_iterations),
      number_of("ccd_tolerance", &mjOption::ccd_tolerance)};
  return table;
}

/// Without which feet pass through the floor or servos do not push; and what would set aside the
/// contact settings of the scene's floor.
const std::vector<SolverSetting>& flags() {
  static const std::vector<SolverSetting> table{
      disabling("constraint", mjDSBL_CONSTRAINT),
      disabling("limit", mjDSBL_LIMIT),
      disabling("contact", mjDSBL_CONTACT),
      disabling("clampctrl", mjDSBL_CLAMPCTRL),
      disabling("warmstart", mjDSBL_WARMSTART),
      disabling("actuation", mjDSBL_ACTUATION),
      disabling("refsafe", mjDSBL_REFSAFE),
      disabling("sensor", mjDSBL_SENSOR),
      {"override", [](const mjOption& option) -> std::string {
         return (option.enableflags & mjENBL_OVERRIDE) != 0 ? "enable" : "disable";
       }}};
  return table;
}

}  // namespace

std::vector<OverriddenOption> overridden_options(const mjOption& robot, double time_step) {
  mjOption defaults;
  mj_defaultOption(&defaults);
  const mjOption scene = scene_options(time_step);
  std::vector<OverriddenOption> out;
  for (const auto* table : {&attributes(), &flags()})
    for (const SolverSetting& setting : *table) {
      const std::string file = setting.text(robot), wanted = setting.text(scene);
      if (file != wanted && file != setting.text(defaults))
        out.push_back({setting.name, file, wanted});
    }
  return out;
}

void set_solver(tinyxml2::XMLElement& option, const mjOption& robot, double time_step) {
  const mjOption scene = scene_options(time_step);
  for (const SolverSetting& setting : attributes())
    if (const std::string text = setting.text(scene); setting.always || text != setting.text(robot))
      option.SetAttribute(setting.name, text.c_str());
  tinyxml2::XMLElement* flag = nullptr;
  for (const SolverSetting& setting : flags()) {
    const std::string text = setting.text(scene);
    if (text == setting.text(robot)) continue;
    if (flag == nullptr) flag = option.InsertNewChildElement("flag");
    flag->SetAttribute(setting.name, text.c_str());
  }
}

std::string describe_overridden(const std::vector<OverriddenOption>& overridden) {
  std::string out;
  for (const OverriddenOption& one : overridden)
    out += fmt::format("{}{} {} (its file has {})", out.empty() ? "" : ", ", one.name, one.scene,
                       one.file);
  return out.empty() ? "" : "scenes have options of their own: " + out;
}

}  // namespace legwright
