// SPDX-License-Identifier: Apache-2.0
#include "tools/simulate/health.hpp"

namespace legwright {
namespace {

const char* warning_text(int kind) {
  switch (kind) {
    case mjWARN_INERTIA:
      return "(nearly) singular inertia matrix";
    case mjWARN_CONTACTFULL:
      return "too many contacts";
    case mjWARN_CNSTRFULL:
      return "too many constraints";
    case mjWARN_BADQPOS:
      return "bad number in the positions";
    case mjWARN_BADQVEL:
      return "bad number in the velocities";
    case mjWARN_BADQACC:
      return "bad number in the accelerations";
    case mjWARN_BADCTRL:
      return "bad number in the controls";
    default:
      return "unknown warning";
  }
}

}  // namespace

void Health::look(const mjData& data, double time) {
  for (std::size_t kind = 0; kind < mjNWARNING; ++kind)
    if (data.warning[kind].number > 0 && first_[kind] < 0) first_[kind] = time;
}

bool Health::diverged(const mjData& data) {
  return data.warning[mjWARN_BADQPOS].number > 0 || data.warning[mjWARN_BADQVEL].number > 0 ||
         data.warning[mjWARN_BADQACC].number > 0;
}

std::vector<HealthWarning> Health::warnings(const mjData& data) const {
  std::vector<HealthWarning> out;
  for (std::size_t kind = 0; kind < mjNWARNING; ++kind)
    if (first_[kind] >= 0)
      out.push_back(
          {first_[kind], warning_text(static_cast<int>(kind)), data.warning[kind].number});
  return out;
}

}  // namespace legwright
