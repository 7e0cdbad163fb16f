// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <initializer_list>
#include <string>
#include <vector>

namespace legwright::test {

/// One body of a chain, as MJCF text.
struct BodyText {
  std::string attributes;            // of its start tag
  std::vector<std::string> content;  // what stands in it before the next body, a line each
};

/// Bodies one within the other, from the trunk outwards. Each line begins with its line break and
/// `indent` blanks, two more for each body around it.
std::string chain(const std::vector<BodyText>& bodies, int indent = 6);

/// <joint> of a hinge; `more` holds further attributes.
std::string hinge(const std::string& name, const std::string& axis, const std::string& more = "");

/// <inertial>: centre [m], mass [kg], principal moments [kg m²].
std::string inertial(const std::string& pos, double mass, const std::string& diaginertia);

/// The same with the mass first, as in robots that come out of CAD.
std::string cad_inertial(double mass, const std::string& pos, const std::string& diaginertia);

/// What a design parameter is told by: the pair <numeric>, <text> of a <custom> section.
struct DeclarationText {
  const char *name, *data, *text;
};
/// Those pairs, each element with a line break and `indent` blanks before it.
std::string declarations(std::initializer_list<DeclarationText> parameters, int indent = 4);

/// `format` once for each leg and each of its joints, {0} the leg and {1} the joint.
std::string for_each_joint(const char* format, std::initializer_list<const char*> legs,
                           std::initializer_list<const char*> joints);

/// A leg of the hinges SIDE_roll, SIDE_pitch and SIDE_knee, 20 cm from pitch to knee and from there
/// to its ball SIDE_foot. Offsets are to the left; those of side "R" are mirrored.
/// @param hip, thigh what these bodies hold besides, {} for the side
std::string roll_pitch_knee_leg(const std::string& side, double hip_y, double thigh_y,
                                const std::vector<std::string>& hip,
                                const std::vector<std::string>& thigh);
/// Motors of 9 N m for two of them.
std::string roll_pitch_knee_motors();

/// The corners of a box [m] as the vertices of a mesh, z running fastest.
std::string box_vertices(double half_x, double half_y, double z_low, double z_high);

}  // namespace legwright::test
