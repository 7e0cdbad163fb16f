// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace legwright {

/// A pose in which a robot stands, found for a file that has none.
struct StandingPose {
  std::string why;         // the file's own home pose is none, in words
  std::string words;       // the pose, for people
  std::string qpos, ctrl;  // attributes of a <key>; ctrl is empty without position servos
};

/// Finds a pose to stand in for a robot whose home pose is none: a joint out of its range, legs of
/// one build that end at different heights, a trunk as low as the feet, legs folded under it, or,
/// of a file without keyframe and three legs at least, legs that are stretched out. The trunk is
/// level; each foot is below the hinge above its knee, all of them moved alike so that their middle
/// is below the centre of mass; legs are bent to 0.87 of their reach, to 0.93 or 0.97 where ranges
/// do not let them, knees backwards where ranges let them choose; angles keep off the ends of their
/// ranges; legs that are mirror images stand so. Of a file without keyframe whose drawn legs stand,
/// what is found is that pose on the ground, with such legs mirrored. The same file gives the same
/// numbers.
/// Nothing where the home pose is one, where there are no two legs of one build, or where no pose
/// stands. Faults of the file are left to its reader.
/// @param none gets a sentence where the home pose is none and no other was found
std::optional<StandingPose> find_standing_pose(const std::string& xml,
                                               const std::filesystem::path& file,
                                               std::string* none = nullptr);

/// The text with that pose as keyframe `legwright`, which comes before `home`; all other bytes
/// stay. Throws InputError as load_xml() does.
std::string with_keyframe(const std::string& xml, const std::filesystem::path& file,
                          const StandingPose& pose);

}  // namespace legwright
