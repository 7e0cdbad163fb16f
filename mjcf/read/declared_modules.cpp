// SPDX-License-Identifier: Apache-2.0
#include "mjcf/read/declared_modules.hpp"

#include <fmt/format.h>

#include <sstream>
#include <utility>

#include "mjcf/text/compile.hpp"

namespace legwright {
namespace {

void add_geoms_of_body(const mjModel& model, DeclaredModule& module) {
  for (int k = 0; k < model.body_geomnum[module.body]; ++k)
    module.geoms.push_back(model.body_geomadr[module.body] + k);
}

/// The geoms of a foot lie one behind the other, on the link that it ends: NAME, NAME_2, NAME_3.
void add_geoms_of_foot(const mjModel& model, int first, DeclaredModule& module) {
  module.body = model.geom_bodyid[first];
  const int end = model.body_geomadr[module.body] + model.body_geomnum[module.body];
  module.geoms.push_back(first);
  for (int geom = first + 1; geom < end; ++geom)
    if (name_of(model, mjOBJ_GEOM, geom).starts_with(module.of + "_")) module.geoms.push_back(geom);
}

}  // namespace

std::vector<DeclaredModule> declared_modules(const mjModel& model) {
  std::vector<DeclaredModule> out;
  for (int t = 0; t < static_cast<int>(model.ntext); ++t) {
    const std::string name = name_of(model, mjOBJ_TEXT, t);
    if (!name.starts_with(kModulePrefix)) continue;
    DeclaredModule module;
    module.of = name.substr(kModulePrefix.size());
    std::istringstream words(model.text_data + model.text_adr[t]);
    std::string module_name;
    words >> module_name >> module.kind;
    const int body = mj_name2id(&model, mjOBJ_BODY, module.of.c_str()),
              geom = mj_name2id(&model, mjOBJ_GEOM, module.of.c_str());
    if (module.kind == "foot" ? geom < 0 : body < 0) continue;
    module.body = body;
    if (module.kind == "foot")
      add_geoms_of_foot(model, geom, module);
    else
      add_geoms_of_body(model, module);
    out.push_back(std::move(module));
  }
  return out;
}

}  // namespace legwright
