// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "mjcf/text/refusals.hpp"
#include "mjcf/text/xml.hpp"

namespace legwright {

/// The folder of meshes that MuJoCo's extension of a URDF names; empty without one.
std::string urdf_mesh_folder(const XmlFile& urdf);

/// Refuses meshes of <collision> whose files are not there, with the URDF's words, where they were
/// looked for, and files whose names differ in capitals alone. A <visual> without its file is left
/// out by whoever reads.
void refuse_missing_meshes(const XmlFile& urdf, Refusals& faults);

}  // namespace legwright
