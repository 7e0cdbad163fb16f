// SPDX-License-Identifier: Apache-2.0
#include "optimizer/design/morphology.hpp"

#include <Eigen/Geometry>
#include <algorithm>

namespace legwright {

Eigen::Vector3d AffineVector::at(const Eigen::VectorXd& s) const {
  Eigen::Vector3d v = constant;
  for (const Slope& slope : slopes) v += s[slope.parameter] * slope.slope;
  return v;
}

Eigen::Vector3d TurnedVector::at(const Eigen::VectorXd& s) const {
  return turned(turns, s, reference);
}

Eigen::Vector3d turned(const std::vector<TurnedVector::Turn>& turns, const Eigen::VectorXd& s,
                       Eigen::Vector3d vector) {
  for (auto turn = turns.rbegin(); turn != turns.rend(); ++turn)
    vector = Eigen::AngleAxisd(turn->factor * s[turn->parameter], turn->about) * vector;
  return vector;
}

Eigen::Vector3d turned_back(const std::vector<TurnedVector::Turn>& turns, const Eigen::VectorXd& s,
                            Eigen::Vector3d vector) {
  for (const TurnedVector::Turn& turn : turns)
    vector = Eigen::AngleAxisd(-turn.factor * s[turn.parameter], turn.about) * vector;
  return vector;
}

double PointMass::growth_at(const Eigen::VectorXd& s) const {
  double factor = 1.0;
  for (const Growth& g : growth) factor *= s[g.parameter] / g.initial;
  return factor;
}

bool Morphology::grows() const {
  for (const Link& link : links)
    for (const PointMass& point : link.masses)
      if (!point.growth.empty()) return true;
  return false;
}

double Morphology::total_mass() const {
  double sum = 0.0;
  for (const Link& link : links)
    for (const PointMass& point : link.masses) sum += point.mass;
  return sum;
}

Eigen::VectorXd Morphology::nominal_joints() const {
  Eigen::VectorXd angles(joint_count());
  for (int a = 0; a < joint_count(); ++a) angles[a] = links[a + 1].joint.nominal;
  return angles;
}

std::vector<int> Morphology::chain_to(int link) const {
  std::vector<int> chain;
  for (; link > 0; link = links[link].parent) chain.push_back(link);
  std::reverse(chain.begin(), chain.end());
  return chain;
}

double stretched_limb(const Morphology& morphology, int foot, const Eigen::VectorXd& s) {
  const std::vector<int> chain = morphology.chain_to(morphology.feet[foot].link);
  const double centre = morphology.feet[foot].position.at(s).norm();
  // The middle of a round sole lies above the ankle: there the leg ends at the sole.
  double sum =
      centre < morphology.feet[foot].radius ? morphology.feet[foot].radius - centre : centre;
  for (std::size_t a = 1; a < chain.size(); ++a)
    sum += morphology.links[chain[a]].origin.at(s).norm();
  return sum;
}

bool stands_on_soles(const Morphology& morphology) {
  return std::all_of(morphology.feet.begin(), morphology.feet.end(),
                     [](const Foot& foot) { return foot.sole.has_value(); });
}

}  // namespace legwright
