// SPDX-License-Identifier: Apache-2.0
#include "tools/validate/self_contact.hpp"

#include <algorithm>
#include <cstddef>
#include <map>

#include "mjcf/text/compile.hpp"

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

namespace {

/// Whether a body is of the tree below another one and moves against its parent, or is that one.
bool is_link(const mjModel& model, int body, int root_body) {
  return model.body_rootid[body] == model.body_rootid[root_body] && model.body_weldid[body] == body;
}

bool masks_match(const mjModel& model, int a, int b) {
  return (model.geom_contype[a] & model.geom_conaffinity[b]) != 0 ||
         (model.geom_contype[b] & model.geom_conaffinity[a]) != 0;
}

}  // namespace

std::vector<std::string> links_that_never_touch(const mjModel& model, int root_body) {
  std::vector<bool> touches(static_cast<std::size_t>(model.nbody), false);
  const auto link_of = [&](int geom) { return model.body_weldid[model.geom_bodyid[geom]]; };
  const auto is_own = [&](int geom) { return is_link(model, link_of(geom), root_body); };
  for (int a = 0; a < static_cast<int>(model.ngeom); ++a) {
    if (!is_own(a)) continue;
    for (int b = a + 1; b < static_cast<int>(model.ngeom); ++b) {
      if (!is_own(b) || link_of(a) == link_of(b) || !masks_match(model, a, b)) continue;
      touches[static_cast<std::size_t>(link_of(a))] = true;
      touches[static_cast<std::size_t>(link_of(b))] = true;
    }
  }
  std::vector<std::string> out;
  for (int body = 1; body < static_cast<int>(model.nbody); ++body)
    if (is_link(model, body, root_body) && !touches[static_cast<std::size_t>(body)])
      out.push_back(name_of(model, mjOBJ_BODY, body));
  return out;
}

int link_count(const mjModel& model, int root_body) {
  int out = 0;
  for (int body = 1; body < static_cast<int>(model.nbody); ++body)
    out += is_link(model, body, root_body);
  return out;
}

}  // namespace legwright
