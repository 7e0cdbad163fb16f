// SPDX-License-Identifier: Apache-2.0
#include "optimizer/objective/dependence.hpp"

#include "optimizer/design/actuator_length.hpp"
#include "optimizer/design/growth.hpp"

namespace legwright {
namespace {

using Kind = DerivedBlock::Kind;

/// Adds to a Dependence what lies on the way.
struct Collector : Dependence {
  void add_vector(const AffineVector& v) {
    for (const AffineVector::Slope& slope : v.slopes) parameters.insert(slope.parameter);
  }
  void add_joint(const Morphology& morphology, int index) {
    const Link& link = morphology.links[index];
    add_vector(link.origin);
    for (const JointAxis::Turn& turn : link.joint.axis.turns) parameters.insert(turn.parameter);
    if (index > 0) links.insert(index);
  }
  void add_chain(const Morphology& morphology, int link) {
    for (int l : morphology.chain_to(link)) add_joint(morphology, l);
  }
  /// A link and all below it, with what they weigh and the feet they carry.
  void add_subtree(const Morphology& morphology, const Ancestry& ancestry, int link) {
    for (int l = link; l < static_cast<int>(morphology.links.size()); ++l) {
      if (!ancestry.contains(link, l)) continue;
      add_joint(morphology, l);
      for (const PointMass& point : morphology.links[l].masses) {
        add_vector(point.position);
        for (const PointMass::Growth& growth : point.growth) parameters.insert(growth.parameter);
      }
    }
    for (const Foot& foot : morphology.feet)
      if (ancestry.contains(link, foot.link)) add_vector(foot.position);
  }
};

}  // namespace

Dependence dependence(const Morphology& morphology, const Ancestry& ancestry, Kind kind, int part) {
  Collector out;
  switch (kind) {
    case Kind::com:
    case Kind::momentum:
      out.add_subtree(morphology, ancestry, 0);
      break;
    case Kind::foot:
    case Kind::foot_turn:
      out.add_chain(morphology, morphology.feet[part].link);
      out.add_vector(morphology.feet[part].position);
      break;
    case Kind::anchor:
      out.add_chain(morphology, morphology.links[part].parent);
      out.add_vector(morphology.links[part].origin);
      break;
    case Kind::capsule_end: {
      const Capsule& capsule = morphology.capsules[part / 2];
      out.add_chain(morphology, capsule.link);
      out.add_vector(part % 2 == 0 ? capsule.from : capsule.to);
      break;
    }
    case Kind::sole_direction:
      out.add_chain(morphology, morphology.feet[part / 2].link);
      break;
    case Kind::joint_torque:
      out.add_chain(morphology, part);
      out.add_subtree(morphology, ancestry, part);
      break;
    case Kind::actuator:
      for (int parameter : actuator_parameters(morphology, morphology.linear_actuators[part]))
        out.parameters.insert(parameter);
      break;
    case Kind::mass_share:
    case Kind::printed_volume:
      for (int parameter : growth_parameters(morphology)) out.parameters.insert(parameter);
      break;
  }
  return out;
}

}  // namespace legwright
