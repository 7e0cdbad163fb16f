// SPDX-License-Identifier: Apache-2.0
#include "optimizer/terms/factories.hpp"
#include "optimizer/terms/linear_term.hpp"

namespace legwright {
namespace {

/// Eq (17) and what else must repeat: root height, orientation and joints, feet and forces of knot T are those of knot 0
/// one cycle later. Residuals in radians, over length, over the weight.
class Periodicity final : public LinearTerm {
 public:
  explicit Periodicity(const TermContext& context) {
    const Layout& layout = context.layout;
    const WantedPath& path = context.path;
    const int T = layout.knot_count(), size = layout.pose_size() - 2;
    Eigen::VectorXd pose = Eigen::VectorXd::Zero(size);
    pose[3] = path.turn_angle();
    add(T, -1, {{layout.pose(T) + 2, times(1.0, size)}, {layout.pose(0) + 2, times(-1.0, size)}},
        pose);
    for (int j = 0; j < layout.foot_count(); ++j) {
      const double scale = 1.0 / context.length, force = 1.0 / context.weight;
      add(T, j, {{layout.foot(T, j), times(scale)}, {layout.foot(0, j), -scale * path.turn()}},
          scale * path.travel());
      if (layout.force(0, j) >= 0)
        add(T, j, {{layout.force(T, j), times(force)}, {layout.force(0, j), -force * path.turn()}},
            Eigen::Vector3d::Zero());
    }
  }
  std::string_view name() const override { return "periodicity"; }
};

}  // namespace

std::unique_ptr<Term> make_periodicity(const TermContext& context) {
  return std::make_unique<Periodicity>(context);
}

}  // namespace legwright
