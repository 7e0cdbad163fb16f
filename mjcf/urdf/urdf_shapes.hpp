// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <mujoco/mujoco.h>
#include <tinyxml2.h>

#include <Eigen/Geometry>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "mjcf/urdf/print_xml.hpp"
#include "mjcf/urdf/write_urdf.hpp"

namespace legwright {

/// Shortest text of a number, or of each, that reads back as the same.
std::string urdf_number(double number);
std::string urdf_numbers(const Eigen::Vector3d& numbers);
/// <origin>: Rz(yaw) Ry(pitch) Rx(roll), exact also where the pitch is a right angle.
void add_origin(tinyxml2::XMLPrinter& out, const Eigen::Vector3d& place,
                const Eigen::Matrix3d& rotation);

/// Writes the geoms of a model as <visual> and <collision>, and collects their meshes.
class UrdfShapes {
 public:
  /// @param mesh_prefix before the name of each mesh's file
  UrdfShapes(const mjModel& model, std::string mesh_prefix);

  /// The geoms of a body. @param origin of the URDF link in the body's frame
  void add_geoms(tinyxml2::XMLPrinter& out, int body, const Eigen::Vector3d& origin);

  const std::vector<UrdfMesh>& meshes() const { return meshes_; }
  int capsules() const { return capsules_; }
  int ellipsoids() const { return ellipsoids_; }
  int left_out() const {
    return left_out_;
  }  // planes, height fields, hidden ones that touch nothing

 private:
  struct Part {
    Eigen::Vector3d place = Eigen::Vector3d::Zero();  // in the geom's frame
    const char* shape = "";
    XmlAttributes attributes;
  };
  std::vector<Part> parts_of(int geom);
  void add_part(tinyxml2::XMLPrinter& out, int geom, const Part& part,
                const Eigen::Vector3d& origin, bool visual) const;
  std::string mesh_file(int mesh);
  std::string ellipsoid_file(const Eigen::Vector3d& radii);
  std::string new_file(const std::string& wanted, std::string obj);

  const mjModel& model_;
  std::string prefix_;
  std::vector<UrdfMesh> meshes_;
  std::map<int, std::string> file_of_mesh_;
  std::set<std::string> names_;
  int capsules_ = 0, ellipsoids_ = 0, left_out_ = 0;
};

}  // namespace legwright
