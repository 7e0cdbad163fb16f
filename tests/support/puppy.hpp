// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <array>

#include "optimizer/design/design.hpp"
#include "optimizer/design/morphology.hpp"
#include "optimizer/motion/task.hpp"

namespace legwright::test {

/// The puppy without a file: trunk 0.24 × 0.14 × 0.05 m, four legs of three lateral hinges, exact
/// point masses.
struct Puppy {
  Morphology morphology;
  DesignSpace space;
};

/// @param tied true: 20 parameters, left and right mirrored; false: 38, every leg on its own, in
/// the order 12 lengths, 12 × (turn about z, turn about x), body width, body length.
Puppy make_puppy(bool tied);

/// Which of its point masses change with the design in other ways than that they move along.
enum class Masses { plain, printed, turning };
void make_masses(Puppy& puppy, Masses masses);

/// Adds a linear actuator to each knee and the three coordinates of its lower end as parameters.
void add_pistons(Puppy& puppy);

/// Makes the shanks, thighs and the trunk printed: their masses grow with their lengths, the
/// trunk's with two of them.
void print_bodies(Puppy& puppy);

/// Hangs a servo before and beside each hinge, which turns with its axis.
void hang_servos(Puppy& puppy);

/// Gives the trunk two capsules along its sides, which follow its width and length, and each thigh
/// and shank one; trunk and limbs may not touch. `low`: how far below the hips the trunk's are, and
/// their radius [m].
void add_capsules(Puppy& puppy, double low = 0.035, double radius = 0.02);
/// The same, thick and above the hips: wide against the step of central differences.
void add_thick_capsules(Puppy& puppy);

/// Makes the feet flat: soles askew in their links, each in its own way.
void add_soles(Puppy& puppy);

/// Sideways at 0.1 m/s; walk (1 s, duty 0.75) or trot (0.4 s, duty 0.5).
Task make_sideways_task(bool trot, int knot_count = 24, int planted_margin = 1);

}  // namespace legwright::test
