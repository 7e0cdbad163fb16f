// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "mjcf/propose/fixed_root.hpp"
#include "mjcf/propose/floating_root.hpp"
#include "mjcf/propose/home_touches.hpp"
#include "mjcf/propose/proposals.hpp"
#include "mjcf/propose/standing_pose.hpp"
#include "mjcf/propose/trunk_axes.hpp"
#include "mjcf/text/robot_files.hpp"

namespace legwright {

/// A robot as `legwright init` studies it: its files, and what a designer may change in it.
struct StudiedRobot {
  RobotFiles files;  // with the pose, names, turn and free root of what is told below
  ProposedParameters found;
  std::optional<StandingPose> pose;  // found for it; nothing where its home pose is one
  std::string text;                  // of the main file as it was read
  std::set<std::string> named;       // joints whose bodies had no name
  bool of_urdf = false;              // `files` hold the MJCF that was made of it
  std::vector<std::string> mended;   // on the way from it
  std::string trunk;                 // what it is called that had no name; else empty
  std::optional<TrunkAxes> axes;     // of the file, where its trunk's frame is turned
  std::optional<SixJointRoot> root;  // that had the place of the free joint in `files`
  std::string freed;                 // what is told of a free joint for a trunk fixed to the world
  std::vector<BodyTouch> excluded;   // that overlap in every pose, and now may

  /// Whether `files` differ from the robot's but for declarations and names of bodies.
  bool is_changed() const;
};

/// A URDF is studied as the MJCF that mjcf_of_urdf() makes of it.
/// Throws InputError as parse_robot() does, and for a task file in the place of its robot.
StudiedRobot study_robot(const std::filesystem::path& file, const FileReach& reach = {},
                         const Forward& forward = {});

/// What writing changes besides declarations and poses, a sentence each: `mended`, `trunk`,
/// `freed`, `root`, `axes` and `excluded`.
std::vector<std::string> changes_besides(const StudiedRobot& robot);

/// What a designer is told before anything is changed, a sentence each: changes_besides(), the pose
/// that was found, the bodies that get names, and what may be a mistake in the file.
std::vector<std::string> told_of(const StudiedRobot& robot);

/// Its files with some of its proposals declared.
RobotFiles with_declared(const StudiedRobot& robot, const std::vector<Proposal>& chosen);

/// Declares the proposals in the robot's file, or in the new file `output`, and adds the keyframe
/// of a pose that was found; all other bytes stay. In another folder than the robot's the files
/// that it names are written beside `output` (write_main_file()).
/// Throws InputError for a URDF without `output`, which has no place for them.
/// Throws IoError where `output` or one of those is there already, or the robot's file has been
/// changed since it was studied.
/// @param output empty for the robot's file @return what was written; empty: nothing to add
std::string write_proposals(const StudiedRobot& robot, const std::string& output);

}  // namespace legwright
