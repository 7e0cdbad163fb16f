// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Geometry>
#include <map>
#include <string>

#include "mjcf/text/xml.hpp"

namespace legwright {

/// A mesh asset as its element has it: a vertex v of the file is shown at S Qᵀ (v − refpos).
struct MeshAsset {
  const XmlElement* element = nullptr;
  Eigen::Vector3d scale = Eigen::Vector3d::Ones();           // S, its diagonal
  Eigen::Quaterniond turn = Eigen::Quaterniond::Identity();  // Q, the asset's refquat

  /// From the file's axes to those in which geoms place the mesh.
  Eigen::Matrix3d shown() const { return scale.asDiagonal() * turn.toRotationMatrix().transpose(); }
};

/// The mesh assets of a robot by the names that geoms use: their own, else those of their files.
std::map<std::string, MeshAsset> find_meshes(const XmlFile& xml);

/// The asset that a geom shows; the identity where it shows none.
MeshAsset mesh_of(const XmlFile& xml, const XmlElement& geom);

/// Whether a geom weighs nothing by its own words: mass or density zero.
bool is_weightless(const XmlFile& xml, const XmlElement& geom);

/// Whether a geom is a mesh that grows with its body when that is stretched: it must not be what
/// the body's weight comes from.
bool mesh_grows(const XmlFile& xml, const XmlElement& geom);

}  // namespace legwright
