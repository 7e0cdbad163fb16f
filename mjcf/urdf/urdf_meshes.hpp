// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace legwright {

/// What a mesh file of a URDF turned out to be.
enum class UrdfMeshKind {
  found,
  other_format,  // MuJoCo reads no such file, but the one of the same name that was found beside it
  collada,       // MuJoCo reads no such file, but read_collada() may
  unreadable,    // MuJoCo reads no such file
  missing,
};

struct UrdfMeshFile {
  UrdfMeshKind kind;
  std::string path;  // for an MJCF in the URDF's place; of a missing one the likeliest
};

/// Whether a file is called .dae.
bool is_collada(const std::string& name);

/// NAME/REST of $(find NAME)/REST, with or without file:// before it: what xacro makes a path of,
/// but a file that has nothing else of xacro is a URDF. Nothing for other texts.
std::optional<std::string> behind_find_of_xacro(const std::string& name);

/// Looks up a mesh of a URDF. package://NAME/REST, or $(find NAME)/REST, is searched for in the
/// folders above the URDF: as REST in one called NAME, as NAME/REST beside them, as REST; so is
/// /…/share/NAME/REST, where another machine has it; a plain path from the URDF's folder, or from
/// `mesh_folder` there. Backslashes part folders, too. Of a format that MuJoCo cannot read an STL
/// or OBJ of the same name beside it serves, else a Collada file itself.
/// @param name as the URDF has it @param folder of the URDF
/// @param mesh_folder of MuJoCo's extension; may be empty
UrdfMeshFile find_urdf_mesh(const std::string& name, const std::filesystem::path& folder,
                            const std::string& mesh_folder);

/// Where a mesh that is missing was looked for, as a sentence without its point.
std::string where_mesh_was_sought(const std::string& name, const std::filesystem::path& folder,
                                  const std::string& mesh_folder);

/// The file in the place of a missing one whose path differs in capitals alone, seen from the
/// URDF's folder; empty: there is none.
std::string mesh_in_other_case(const std::string& name, const std::filesystem::path& folder,
                               const std::string& mesh_folder);

}  // namespace legwright
