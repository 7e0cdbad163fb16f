// SPDX-License-Identifier: Apache-2.0
#include "optimizer/terms/factories.hpp"
#include "optimizer/terms/linear_term.hpp"

namespace legwright {
namespace {

/// Not in the paper, which knows feet as points: a flat foot lies level, on the ground and in the
/// air, and does not turn about the vertical while it is planted. Its middle carries the force,
/// farthest from all edges, so that nothing tips it. Residuals [rad]: at every knot the heights of
/// the sole's two directions, u_z; between knots at which the foot is planted how far the one ahead
/// turns, (u_{i+1} − u_i)_xy.
class FlatFoot final : public LinearTerm {
 public:
  explicit FlatFoot(const TermContext& context) {
    const Layout& layout = context.layout;
    const Gait& gait = context.task.gait;
    const int margin = layout.planted_margin();
    for (int i = 0; i <= layout.knot_count(); ++i)
      for (int j = 0; j < layout.foot_count(); ++j) {
        if (!context.morphology.feet[j].sole) continue;
        const int ahead = layout.sole_direction(i, j, 0), beside = layout.sole_direction(i, j, 1);
        add(i, j, {{ahead, height(0)}, {beside, height(1)}}, Eigen::Vector2d::Zero());
        if (i < layout.knot_count() && gait.planted(i, j, margin) && gait.planted(i + 1, j, margin))
          add(i, j, {{layout.sole_direction(i + 1, j, 0), in_plane(1.0)}, {ahead, in_plane(-1.0)}},
              Eigen::Vector2d::Zero());
      }
  }
  std::string_view name() const override { return "flat_foot"; }
  ResidualUnit unit(int, int) const override { return {1.0, "rad"}; }

 private:
  static Eigen::MatrixXd height(int row) {
    Eigen::MatrixXd out = Eigen::MatrixXd::Zero(2, 3);
    out(row, 2) = 1.0;
    return out;
  }
  static Eigen::MatrixXd in_plane(double scale) {
    Eigen::MatrixXd out = Eigen::MatrixXd::Zero(2, 3);
    out.leftCols<2>() = scale * Eigen::Matrix2d::Identity();
    return out;
  }
};

}  // namespace

std::unique_ptr<Term> make_flat_foot(const TermContext& context) {
  return std::make_unique<FlatFoot>(context);
}

}  // namespace legwright
