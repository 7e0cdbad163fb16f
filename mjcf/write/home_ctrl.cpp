// SPDX-License-Identifier: Apache-2.0
#include "mjcf/write/home_ctrl.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "mjcf/read/moving_parts.hpp"
#include "mjcf/text/compile.hpp"
#include "mjcf/text/text_edits.hpp"
#include "mjcf/text/xml.hpp"

namespace legwright {

std::optional<std::vector<double>> holding_ctrl(const mjModel& model, const mjtNum* qpos,
                                                const std::filesystem::path& file) {
  const DataPointer data = kinematics_at(model, qpos, file);
  mj_fwdPosition(&model, data.get());
  std::vector<double> ctrl(static_cast<std::size_t>(model.nu), 0.0);
  bool any = false;
  for (int i = 0; i < static_cast<int>(model.nactuator); ++i) {
    const int type = model.actuator_trntype[i];
    if ((type != mjTRN_JOINT && type != mjTRN_JOINTINPARENT && type != mjTRN_TENDON) ||
        model.actuator_biastype[i] != mjBIAS_AFFINE ||
        !(model.actuator_biasprm[mjNBIAS * i + 1] < 0.0))
      continue;
    const int at = model.actuator_ctrladr[i];
    const mjtNum* const range = model.actuator_ctrlrange + std::ptrdiff_t{2} * at;
    double value = data->actuator_length[model.actuator_outadr[i]];
    if (model.actuator_ctrllimited[at]) value = std::clamp(value, range[0], range[1]);
    ctrl[static_cast<std::size_t>(at)] = value + 0.0;
    any = true;
  }
  return any ? std::optional(ctrl) : std::nullopt;
}

std::string ctrl_text(const std::vector<double>& ctrl) {
  return fmt::format("{:.10g}", fmt::join(ctrl, " "));
}

RobotFiles with_home_ctrl(const RobotFiles& files) {
  const ModelPointer model = compile_mjcf(files.text(), files.file());
  const int home = home_keyframe(*model);
  if (home < 0) return files;
  const auto xml = load_xml(files.text(), files.file());
  int key = 0;  // MuJoCo counts them in the order of the file
  const XmlElement* found = nullptr;
  for_each_element(xml->root(), [&](const XmlElement& element) {
    if (is_tag(element, "key") && key++ == home) found = &element;
  });
  if (found == nullptr || !has_attribute(*found, "qpos") || has_attribute(*found, "ctrl"))
    return files;
  const auto ctrl = holding_ctrl(*model, home_qpos(*model), files.file());
  if (!ctrl) return files;
  TextEdits edits(*xml);
  edits.set(*found, "ctrl", ctrl_text(*ctrl));
  return files.with_text(edits.apply());
}

}  // namespace legwright
