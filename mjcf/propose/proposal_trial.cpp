// SPDX-License-Identifier: Apache-2.0
#include "mjcf/propose/proposal_trial.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "mjcf/propose/declare.hpp"
#include "mjcf/read/read_robot.hpp"
#include "mjcf/text/input_error.hpp"
#include "mjcf/write/rewrite_robot.hpp"

namespace legwright {

std::string refusal_of(const std::string& text, const std::filesystem::path& file, int declared,
                       const std::vector<Proposal>& proposals) {
  try {
    const RobotModel read = parse_robot(with_declarations(text, file, proposals), file);
    const int wanted = declared + static_cast<int>(proposals.size());
    return read.space.size() == wanted ? "" : "what is written into the file is not read again";
  } catch (const InputError& error) {
    // The place is in a text that nobody has seen; what is wrong stands behind it.
    const std::string all = error.what(), prefix = file.string() + ":";
    if (all.compare(0, prefix.size(), prefix) != 0) return all;
    const std::size_t cut = all.find(": ", prefix.size());
    return cut == std::string::npos ? all : all.substr(cut + 2);
  }
}

std::string fault_at_bounds(const std::string& text, const std::filesystem::path& file,
                            const std::vector<Proposal>& proposals) {
  try {
    const RobotModel read = parse_robot(with_declarations(text, file, proposals), file);
    for (const bool upper : {false, true}) {
      Eigen::VectorXd s = read.space.initial();
      for (int k = 0; k < read.space.size(); ++k) {
        const DesignParameter& parameter = read.space.parameters[static_cast<std::size_t>(k)];
        if (std::any_of(proposals.begin(), proposals.end(),
                        [&](const Proposal& one) { return one.name == parameter.name; }))
          s[k] = upper ? parameter.upper : parameter.lower;
      }
      rewrite_robot(read, s);
    }
    return "";
  } catch (const std::logic_error& error) {
    const std::string all = error.what();
    const std::size_t cut = all.rfind("': ");
    return "a design at its bounds would not be read back as the planned one: " +
           (cut == std::string::npos ? all : all.substr(cut + 3));
  } catch (const InputError& error) {
    return fmt::format("a design at its bounds is refused: {}", error.what());
  }
}

}  // namespace legwright
