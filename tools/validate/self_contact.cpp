// SPDX-License-Identifier: Apache-2.0
#include "tools/validate/self_contact.hpp"

#include <algorithm>
#include <map>

namespace legwright {

void SelfContactWatch::observe(double time, const mjData& data) {
  std::map<Pair, double> forces;
  for (int c = 0; c < data.ncon; ++c) {
    const mjContact& contact = data.contact[c];
    if (contact.geom[0] < 0 || contact.geom[1] < 0) continue;
    const Pair bodies =
        std::minmax({model_.geom_bodyid[contact.geom[0]], model_.geom_bodyid[contact.geom[1]]});
    if (bodies.first == 0) continue;
    out_.depth_max = std::max(out_.depth_max, -contact.dist);
    mjtNum force[6];
    mj_contactForce(&model_, &data, c, force);
    forces[bodies] += force[0];
  }
  std::set<Pair> touching;
  for (const auto& [bodies, force] : forces) {
    touching.insert(bodies);
    out_.count += !touching_.contains(bodies);
    if (force <= out_.force_max) continue;
    out_.force_max = force;
    out_.force_time = time;
    hardest_ = bodies;
  }
  ++samples_;
  touched_ += !touching.empty();
  touching_ = std::move(touching);
}

SelfContact SelfContactWatch::finish() const {
  SelfContact out = out_;
  out.share = static_cast<double>(touched_) / static_cast<double>(std::max(1LL, samples_));
  const auto name = [&](int body) {
    const char* text = body < 0 ? nullptr : mj_id2name(&model_, mjOBJ_BODY, body);
    return std::string(text == nullptr ? "" : text);
  };
  out.first = name(hardest_.first);
  out.second = name(hardest_.second);
  return out;
}

}  // namespace legwright
