// SPDX-License-Identifier: Apache-2.0
#include "mjcf/text/written_out.hpp"

#include <fmt/format.h>

namespace legwright {

std::string written_out_cure(const std::filesystem::path& file) {
  std::string from = file.string();
  // Within quotes of Python within quotes of a shell.
  if (from.empty() || from.find_first_of("\"'\\`$!") != std::string::npos) from = "robot.xml";
  const std::filesystem::path path = from;
  const std::string to = (path.parent_path() / (path.stem().string() + "_flat.xml")).string();
  return fmt::format(
      "let MuJoCo write all of it into one file and take that: python3 -c \"import mujoco as m; "
      "m.mj_saveLastXML('{}', m.MjModel.from_xml_path('{}'))\" (pip install mujoco)",
      to, from);
}

}  // namespace legwright
