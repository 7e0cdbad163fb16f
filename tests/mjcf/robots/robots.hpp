// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <random>
#include <string>
#include <vector>

#include "optimizer/design/design.hpp"

namespace legwright::test {

std::filesystem::path source_path(const std::string& relative);
std::string read_file(const std::filesystem::path& file);
/// The puppy of the examples.
std::filesystem::path puppy_file();
/// Text of the robot of examples/NAME.
std::string example_robot(const std::string& name);
/// The robot without its <custom> section, in which it declares design parameters.
std::string undeclared(std::string xml);
/// A small robot with everything that makes a tree general: turned bodies, a fixed body in between,
/// two hinges in one body, hinges away from the origin of their body, an oblique link, axes that
/// start turned, parts that inherit their place from a class, an inertia in turned axes.
std::string crooked_robot();
/// The crooked robot with linear actuators at two hinges, one over a fixed body in between, whose
/// ends are placed; a scaled length and a scaled turn.
std::string crooked_piston_robot();
/// The crooked robot with printed bodies: boxes, capsules, cylinders, balls and ellipsoids along,
/// across and off the stretches.
std::string crooked_printed_robot();
/// The files tests/robots/*/robot.xml that are taken as they are, sorted: all but tailor's, which
/// is in centimetres.
std::vector<std::filesystem::path> taken_robots();
/// Strider of tests/robots, drawn so that it faces +y: what hangs at its trunk is turned.
std::string strider_to_the_left();
/// The same, with all that stands in its trunk in other axes: `frame` is their turn as w x y z, and
/// `inertial` what the trunk's <inertial> has but its mass.
std::string strider_in_axes(const std::string& frame, const std::string& inertial);
/// The same as a CAD program draws it: z of its trunk became y.
std::string strider_with_y_up();
/// By the names "crooked_printed", "crooked_weighed", "puppy", "piston_puppy" (of the examples),
/// "crooked", "crooked_piston"; with "shifted_" before the name as `shifted_robot` makes it.
std::string named_robot(const std::string& name);
/// Replaces the first occurrence; fails the test if there is none.
std::string with(std::string text, const std::string& old_part, const std::string& new_part);
/// Uniform within the bounds.
Eigen::VectorXd random_design(const DesignSpace& space, std::mt19937& random);

}  // namespace legwright::test
