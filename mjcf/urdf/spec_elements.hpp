// SPDX-License-Identifier: Apache-2.0
// Elements of a robot that MuJoCo's reader holds.
#pragma once

#include <mujoco/mujoco.h>

#include <algorithm>
#include <string>
#include <vector>

namespace legwright {

inline bool differs(const double* values, const std::vector<double>& from) {
  return !std::equal(from.begin(), from.end(), values);
}

inline std::string element_name(mjsElement* element) { return mjs_getString(mjs_getName(element)); }

template <class Visit>
void for_each(mjsBody& body, mjtObj type, const Visit& visit) {
  for (mjsElement* part = mjs_firstChild(&body, type, 0); part != nullptr;
       part = mjs_nextChild(&body, part, 0))
    visit(part);
}

template <class Visit>
void for_each(mjSpec& spec, mjtObj type, const Visit& visit) {
  for (mjsElement* part = mjs_firstElement(&spec, type); part != nullptr;
       part = mjs_nextElement(&spec, part))
    visit(part);
}

inline int count_of(mjsBody& body, mjtObj type) {
  int found = 0;
  for_each(body, type, [&](mjsElement*) { ++found; });
  return found;
}

}  // namespace legwright
