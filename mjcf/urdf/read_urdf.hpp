// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "mjcf/text/file_reach.hpp"
#include "mjcf/text/xml.hpp"
#include "mjcf/urdf/collada_meshes.hpp"
#include "mjcf/urdf/mend_urdf.hpp"

namespace legwright {

/// A URDF as MJCF.
struct MjcfOfUrdf {
  std::string text;
  std::vector<std::string> notes;     // what was mended or left out on the way, a sentence each
  std::vector<std::string> left_out;  // those of them on meshes that are, which may be missed
  std::vector<std::string> without_moments;  // as mjcf_of_spec() tells them
};

/// Whether the root element of a text is a URDF's <robot>. No fault of the text is told.
bool is_urdf(std::string_view text);

/// Reads a URDF as often as it is asked to, and the Collada files that it names once.
class UrdfReader {
 public:
  /// @param reach of the Collada files; others are read by whoever compiles the MJCF. Throws
  /// InputError as mjcf_of_urdf().
  UrdfReader(const std::string& text, const std::filesystem::path& file,
             const FileReach& reach = {});
  /// mjcf_of_urdf() of it.
  MjcfOfUrdf read(const UrdfMending& mending = {});

 private:
  std::filesystem::path file_;
  std::unique_ptr<XmlFile> xml_;
  ColladaMeshes collada_;
};

/// The robot of a URDF as MuJoCo's own reader takes it, as MJCF that stands where the URDF does:
/// links and joints keep their names, masses, frames and colours. Mended: the trunk gets a free
/// joint in the place of links without mass above it; joints with <limit effort> get position
/// servos of that torque with default gains (kFullTorqueError, kDampingTime), motor lines of their
/// <limit velocity> (motor_line_data()), and the reflected inertia of geared motors; paths of
/// meshes (package://, file://) are looked up, Collada is written out (ColladaMeshes), and what
/// nobody can read is left out; links without <inertial> stay without mass, those that move get
/// that of what is fixed to them.
/// Throws InputError with the line in the URDF, or with MuJoCo's reason.
/// @param mending nothing but for a second reading (mending_of())
MjcfOfUrdf mjcf_of_urdf(const std::string& text, const std::filesystem::path& file,
                        const UrdfMending& mending = {});

}  // namespace legwright
