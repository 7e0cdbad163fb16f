// SPDX-License-Identifier: Apache-2.0
#include "tools/validate/self_contact.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <set>

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

int link_of(const mjModel& model, int geom) { return model.body_weldid[model.geom_bodyid[geom]]; }

using Masks = std::set<std::pair<int, int>>;  // contype, conaffinity

bool match(const Masks& a, const Masks& b) {
  return std::any_of(a.begin(), a.end(), [&](const std::pair<int, int>& one) {
    return std::any_of(b.begin(), b.end(), [&](const std::pair<int, int>& other) {
      return (one.first & other.second) != 0 || (other.first & one.second) != 0;
    });
  });
}

/// Whether MuJoCo passes over contacts of two links, whatever their masks: <exclude>, and the
/// filter of links next to each other.
bool is_filtered(const mjModel& model, int a, int b) {
  const auto above = [&](int link) { return model.body_weldid[model.body_parentid[link]]; };
  if ((model.opt.disableflags & mjDSBL_FILTERPARENT) == 0 && (above(a) == b || above(b) == a))
    return true;
  const int signature = (std::min(a, b) << 16) + std::max(a, b);
  return std::count(model.exclude_signature, model.exclude_signature + model.nexclude, signature) >
         0;
}

/// Links that can touch another one.
std::set<int> touching_links(const mjModel& model, int root_body) {
  std::set<int> out;
  if ((model.opt.disableflags & (mjDSBL_CONTACT | mjDSBL_CONSTRAINT)) != 0) return out;
  for (int k = 0; k < model.npair; ++k) {
    const int a = link_of(model, model.pair_geom1[k]), b = link_of(model, model.pair_geom2[k]);
    if (a != b && is_link(model, a, root_body) && is_link(model, b, root_body)) out.insert({a, b});
  }
  std::map<int, Masks> masks;
  for (int geom = 0; geom < static_cast<int>(model.ngeom); ++geom)
    if (const int link = link_of(model, geom); is_link(model, link, root_body))
      masks[link].insert({model.geom_contype[geom], model.geom_conaffinity[geom]});
  for (auto a = masks.begin(); a != masks.end(); ++a)
    for (auto b = std::next(a); b != masks.end(); ++b)
      if (match(a->second, b->second) && !is_filtered(model, a->first, b->first))
        out.insert({a->first, b->first});
  return out;
}

}  // namespace

std::vector<std::string> links_that_never_touch(const mjModel& model, int root_body) {
  const std::set<int> touch = touching_links(model, root_body);
  std::vector<std::string> out;
  for (int body = 1; body < static_cast<int>(model.nbody); ++body) {
    if (!is_link(model, body, root_body) || touch.contains(body)) continue;
    const std::string name = name_of(model, mjOBJ_BODY, body);
    out.push_back(name.empty() ? fmt::format("body {}", body) : name);
  }
  return out;
}

int link_count(const mjModel& model, int root_body) {
  int out = 0;
  for (int body = 1; body < static_cast<int>(model.nbody); ++body)
    out += is_link(model, body, root_body);
  return out;
}

}  // namespace legwright
