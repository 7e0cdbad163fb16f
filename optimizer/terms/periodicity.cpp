// SPDX-License-Identifier: Apache-2.0
#include "optimizer/motion/margins.hpp"
#include "optimizer/terms/factories.hpp"
#include "optimizer/terms/linear_term.hpp"

namespace legwright {
namespace {

/// Eq (17) and what else must repeat: root height, orientation and joints, feet and forces of knot
/// T are those of knot 0 one cycle later. Residuals in radians, over length, over the weight; the
/// root's height over length/0.21, which is in metres for legs of 21 cm.
class Periodicity final : public LinearTerm {
 public:
  explicit Periodicity(const TermContext& context)
      : length_(context.length), height_(context.length / kKnownLeg), weight_(context.weight) {
    const Layout& layout = context.layout;
    const WantedPath& path = context.path;
    const int T = layout.knot_count(), size = layout.pose_size() - 2;
    Eigen::VectorXd pose = Eigen::VectorXd::Zero(size);
    pose[3] = path.turn_angle();
    kinds_.push_back(Kind::pose);
    Eigen::MatrixXd same = times(1.0, size);
    same(0, 0) = 1.0 / height_;  // the root's height, before its angles
    add(T, -1, {{layout.pose(T) + 2, same}, {layout.pose(0) + 2, -same}}, pose);
    for (int j = 0; j < layout.foot_count(); ++j) {
      const double scale = 1.0 / context.length, force = 1.0 / context.weight;
      kinds_.push_back(Kind::foot);
      add(T, j, {{layout.foot(T, j), times(scale)}, {layout.foot(0, j), -scale * path.turn()}},
          scale * path.travel());
      if (layout.force(0, j) < 0) continue;
      kinds_.push_back(Kind::force);
      add(T, j, {{layout.force(T, j), times(force)}, {layout.force(0, j), -force * path.turn()}},
          Eigen::Vector3d::Zero());
    }
  }
  std::string_view name() const override { return "periodicity"; }
  ResidualUnit unit(int element, int row) const override {
    if (kinds_[element] == Kind::force) return {weight_, "N"};
    if (kinds_[element] == Kind::foot) return {length_, "m"};
    return row == 0 ? ResidualUnit{height_, "m"} : ResidualUnit{1.0, "rad"};  // root height first
  }

 private:
  enum class Kind { pose, foot, force };
  std::vector<Kind> kinds_;  // by element
  double length_, height_, weight_;
};

}  // namespace

std::unique_ptr<Term> make_periodicity(const TermContext& context) {
  return std::make_unique<Periodicity>(context);
}

}  // namespace legwright
