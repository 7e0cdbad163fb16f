// SPDX-License-Identifier: Apache-2.0
#include "optimizer/objective/derived/dependence.hpp"

namespace legwright {
namespace {

void add_vector(const AffineVector& v, Dependence& out) {
  for (const AffineVector::Slope& slope : v.slopes) out.parameters.insert(slope.parameter);
}

void add_joint(const Morphology& morphology, int index, Dependence& out) {
  const Link& link = morphology.links[index];
  add_vector(link.origin, out);
  for (const JointAxis::Turn& turn : link.joint.axis.turns) out.parameters.insert(turn.parameter);
  if (index > 0) out.links.insert(index);
}

}  // namespace

Dependence on_chain(const Morphology& morphology, int link) {
  Dependence out;
  for (int l : morphology.chain_to(link)) add_joint(morphology, l, out);
  return out;
}

Dependence on_point(const Morphology& morphology, int link, const AffineVector& point) {
  Dependence out = on_chain(morphology, link);
  add_vector(point, out);
  return out;
}

Dependence on_point_of_trunk(const Morphology& morphology, int link, const AffineVector& point) {
  Dependence out = on_point(morphology, link, point);
  out.root = false;
  return out;
}

Dependence on_subtree(const Morphology& morphology, const Ancestry& ancestry, int link) {
  Dependence out;
  for (int l = link; l < static_cast<int>(morphology.links.size()); ++l) {
    if (!ancestry.contains(link, l)) continue;
    add_joint(morphology, l, out);
    for (const PointMass& point : morphology.links[l].masses) {
      add_vector(point.position, out);
      for (const PointMass::Growth& growth : point.growth) out.parameters.insert(growth.parameter);
      for (const auto& turn : point.arm.turns) out.parameters.insert(turn.parameter);
    }
  }
  for (const Foot& foot : morphology.feet)
    if (ancestry.contains(link, foot.link)) add_vector(foot.position, out);
  return out;
}

Dependence operator|(Dependence a, const Dependence& b) {
  a.root = a.root || b.root;
  a.links.insert(b.links.begin(), b.links.end());
  a.parameters.insert(b.parameters.begin(), b.parameters.end());
  return a;
}

}  // namespace legwright
