// SPDX-License-Identifier: Apache-2.0
#include "mjcf/read/trunk_capsules.hpp"

#include <algorithm>
#include <limits>

#include "mjcf/read/collisions.hpp"
#include "mjcf/read/moving_parts.hpp"
#include "mjcf/shape/capsules.hpp"
#include "mjcf/text/compile.hpp"
#include "mjcf/text/model_arrays.hpp"
#include "optimizer/design/segment_distance.hpp"

namespace legwright {
namespace {

using Eigen::Vector3d;

// A box's edges are covered where rounded ones would leave out more than half of that, share of the
// leg.
constexpr double kSharpEdge = 0.03;
// Pairs of shapes; fewer have all 32 pairs of capsules that two meshes may, or 8 of them, else 4.
constexpr std::size_t kMany = 600, kVeryMany = 2500;
constexpr double kFarthest = 10.0;  // to which distances are looked for, share of the leg
constexpr double kRounding = 1e-6;  // of a distance of capsules [m]

class TrunkCapsuleBuilder {
 public:
  TrunkCapsuleBuilder(const XmlFile& xml, const TreeElements& elements, const mjModel& model,
                      const Structure& structure,
                      const std::function<const std::vector<Stretch>&(int)>& stretches_of,
                      const Eigen::VectorXd& initial, double length)
      : xml_(xml),
        elements_(elements),
        model_(model),
        structure_(structure),
        stretches_of_(stretches_of),
        initial_(initial),
        length_(length) {}

  TrunkCapsules run() {
    data_ = kinematics_at(model_, home_qpos(model_), xml_.file);
    const auto pairs = trunk_collisions(model_, structure_);
    const bool many = pairs.size() > kMany;
    const CoverDetail of_trunk = pairs.size() > kVeryMany ? CoverDetail::rough
                                 : many                   ? CoverDetail::coarse
                                                          : CoverDetail::edges;
    for (const auto& [trunk, limb] : pairs) {
      cover(trunk, of_trunk);
      cover(limb, many ? CoverDetail::rough : CoverDetail::coarse);
      if (out_.of_geom.at(trunk).empty() || out_.of_geom.at(limb).empty()) continue;
      double hidden = 0.0;
      if (is_mesh(trunk) || is_mesh(limb)) {
        const double apart = distance(trunk, limb);
        if (apart <= 0.0) continue;
        hidden = std::max(0.0, gap(trunk, limb) - apart);
      }
      out_.pairs.push_back({trunk, limb, hidden});
    }
    return std::move(out_);
  }

 private:
  bool is_mesh(int geom) const { return model_.geom_type[geom] == mjGEOM_MESH; }

  void cover(int geom, CoverDetail detail) {
    const auto [found, is_new] = out_.of_geom.emplace(geom, std::vector<Capsule>{});
    if (is_new)
      found->second =
          capsules_of(xml_, elements_, model_, geom, stretches_of_(model_.geom_bodyid[geom]),
                      kSharpEdge * length_, detail);
  }

  /// Between the shapes as the engine collides them.
  double distance(int trunk, int limb) const {
    const double limit = kFarthest * length_;
    double found = limit;
    call_engine(xml_.file, [&] {
      found = mj_geomDistance(&model_, data_.get(), trunk, limb, limit, nullptr);
    });
    return found;
  }

  double gap(int trunk, int limb) const {
    double least = std::numeric_limits<double>::infinity();
    for (const Capsule& a : out_.of_geom.at(trunk))
      for (const Capsule& b : out_.of_geom.at(limb))
        least = std::min(
            least, segment_distance(place(trunk, a.from), place(trunk, a.to), place(limb, b.from),
                                    place(limb, b.to), kRounding, DistanceDetail::value)
                           .value -
                       a.radius - b.radius);
    return least;
  }

  Vector3d place(int geom, const AffineVector& point) const {
    const int body = model_.geom_bodyid[geom];
    return vector_at(data_->xpos, body) + rotation_at(data_->xquat, body) * point.at(initial_);
  }

  const XmlFile& xml_;
  const TreeElements& elements_;
  const mjModel& model_;
  const Structure& structure_;
  const std::function<const std::vector<Stretch>&(int)>& stretches_of_;
  const Eigen::VectorXd& initial_;
  const double length_;
  DataPointer data_;
  TrunkCapsules out_;
};

}  // namespace

TrunkCapsules trunk_capsules(const XmlFile& xml, const TreeElements& elements, const mjModel& model,
                             const Structure& structure,
                             const std::function<const std::vector<Stretch>&(int)>& stretches_of,
                             const Eigen::VectorXd& initial, double length) {
  return TrunkCapsuleBuilder(xml, elements, model, structure, stretches_of, initial, length).run();
}

}  // namespace legwright
