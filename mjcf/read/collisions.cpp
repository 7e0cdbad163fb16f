// SPDX-License-Identifier: Apache-2.0
#include "mjcf/read/collisions.hpp"

#include <algorithm>
#include <set>

#include "mjcf/read/moving_parts.hpp"

namespace legwright {
namespace {

class Filter {
 public:
  Filter(const mjModel& model, const Structure& structure) : model_(model), structure_(structure) {
    for (int k = 0; k < model.nexclude; ++k) excluded_.insert(model.exclude_signature[k]);
    for (int k = 0; k < model.npair; ++k)
      wanted_.insert(std::minmax(model.pair_geom1[k], model.pair_geom2[k]));
  }

  bool of_robot(int geom) const {
    return model_.body_rootid[model_.geom_bodyid[geom]] == structure_.trunk;
  }
  /// The body that moves a geom when the robot is played; held joints are gone then.
  int moving_body_of(int geom) const {
    return moving_body(model_, structure_, model_.geom_bodyid[geom]);
  }

  bool collide(int trunk_geom, int limb_geom) const {
    if (wanted_.count(std::minmax(trunk_geom, limb_geom))) return true;
    const bool masks =
        (model_.geom_contype[trunk_geom] & model_.geom_conaffinity[limb_geom]) != 0 ||
        (model_.geom_contype[limb_geom] & model_.geom_conaffinity[trunk_geom]) != 0;
    if (!masks) return false;
    const int above =
        moving_body(model_, structure_, model_.body_parentid[moving_body_of(limb_geom)]);
    const bool filters = (model_.opt.disableflags & mjDSBL_FILTERPARENT) == 0;
    if (filters && above == structure_.trunk) return false;
    const auto [low, high] =
        std::minmax(model_.geom_bodyid[trunk_geom], model_.geom_bodyid[limb_geom]);
    return excluded_.count((low << 16) + high) == 0;
  }

 private:
  const mjModel& model_;
  const Structure& structure_;
  std::set<int> excluded_;                // as MuJoCo signs pairs of bodies
  std::set<std::pair<int, int>> wanted_;  // whatever the masks say
};

}  // namespace

std::vector<std::pair<int, int>> trunk_collisions(const mjModel& model,
                                                  const Structure& structure) {
  std::vector<std::pair<int, int>> pairs;
  if ((model.opt.disableflags & (mjDSBL_CONTACT | mjDSBL_CONSTRAINT)) != 0) return pairs;
  const Filter filter(model, structure);
  for (int a = 0; a < model.ngeom; ++a) {
    if (!filter.of_robot(a) || filter.moving_body_of(a) != structure.trunk) continue;
    for (int b = 0; b < model.ngeom; ++b)
      if (filter.of_robot(b) && filter.moving_body_of(b) != structure.trunk && filter.collide(a, b))
        pairs.emplace_back(a, b);
  }
  return pairs;
}

}  // namespace legwright
