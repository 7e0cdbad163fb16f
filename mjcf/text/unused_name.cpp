// SPDX-License-Identifier: Apache-2.0
#include "mjcf/text/unused_name.hpp"

#include <fmt/format.h>

namespace legwright {

std::string unused_name(const std::string& stem,
                        const std::function<bool(const std::string& name)>& is_taken) {
  std::string name = stem;
  for (int n = 2; is_taken(name); ++n) name = fmt::format("{}_{}", stem, n);
  return name;
}

std::string unused_name(const mjModel& model, mjtObj type, const std::string& stem) {
  return unused_name(
      stem, [&](const std::string& name) { return mj_name2id(&model, type, name.c_str()) >= 0; });
}

}  // namespace legwright
