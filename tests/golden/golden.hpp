// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "tools/image/id_image.hpp"
#include "tools/render/posing.hpp"
#include "tools/render/renderer.hpp"

/// Stored pictures of gaits, and what is compared with them.
namespace legwright::golden {

inline constexpr int kWidth = 640, kHeight = 480;
inline constexpr int kAllowedPixels = 10;  // of an id image that may show another geom

/// tests/golden of the sources.
std::filesystem::path folder();
inline const std::vector<std::string> kRobots{"hexapod", "puppy", "quadruped"};

/// A robot with the poses of its gait that were stored, and the camera.
struct Robot {
  std::string name;
  ModelPointer model;
  View view;
  std::string twin_joint;  // the one that is moved to see the comparison fail
  struct Pose {
    std::string name;
    std::vector<double> qpos;
  };
  std::vector<Pose> poses;

  std::filesystem::path id_file(const Pose& pose) const;
  std::filesystem::path colour_file(const Pose& pose) const;
  /// The pose with the twin's joint moved [rad].
  std::vector<double> twin(const Pose& pose, double angle) const;
};

/// Reads NAME/scene.xml and NAME/poses.json. Throws std::runtime_error for files that do not fit.
Robot read_robot(const std::string& name);

/// Makes these two files from a run: the robot of its result on a plain floor, three phases of its
/// planned gait.
void adopt(const std::filesystem::path& run, const std::string& name);

/// What colours depend on: rasteriser, its version, MuJoCo. Of MuJoCo there may be several releases
/// that draw the same.
struct Versions {
  std::string gl_renderer, gl_version;
  std::vector<std::string> mujoco;
  /// Whether colours must be the same to the byte here, where there is one MuJoCo.
  bool cover(const Versions& here) const;
  std::string text() const;
};
Versions versions_here(const GlContext& context);
Versions read_versions();
/// Stores `here`: alone, or beside the releases that draw the same pictures.
void write_versions(const Versions& here, bool same_pictures);

/// Empty if at most `allowed` pixels differ. Otherwise writes side_by_side() into `picture` and
/// returns a message with the count, that file and the way to store the new picture.
std::string compare(const IdImage& stored, const IdImage& drawn, int allowed,
                    const std::filesystem::path& picture);
std::string compare(const Image& stored, const Image& drawn, const std::filesystem::path& picture);

}  // namespace legwright::golden
