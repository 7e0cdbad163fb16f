// SPDX-License-Identifier: Apache-2.0
#include "mjcf/urdf/missing_meshes.hpp"

#include <fmt/format.h>

#include "mjcf/urdf/check_urdf.hpp"
#include "mjcf/urdf/urdf_meshes.hpp"

namespace legwright {
namespace {

void refuse_mesh(const XmlFile& urdf, const XmlElement& link, const XmlElement& mesh,
                 const std::string& mesh_folder, Refusals& faults) {
  const std::string name(attribute(mesh, "filename"));
  const std::filesystem::path folder = urdf.file.parent_path();
  if (find_urdf_mesh(name, folder, mesh_folder).kind != UrdfMeshKind::missing) return;
  const std::string other = mesh_in_other_case(name, folder, mesh_folder);
  const std::string cure =
      other.empty() ? "copy the file to there, or mend the path"
                    : other + " is there: file names are case-sensitive here, mend one of the two";
  faults.add(urdf_fault(
      urdf, mesh, "filename", link,
      fmt::format("the mesh '{}' of its <collision> is not there; {}", name.substr(0, 200), cure)));
  faults.add(InputError(urdf.file.string(), 0, "note",
                        fmt::format("{}. What touches (<collision>) has to be there; a <visual> "
                                    "alone would be left out",
                                    where_mesh_was_sought(name, folder, mesh_folder))));
}

}  // namespace

std::string urdf_mesh_folder(const XmlFile& urdf) {
  const XmlElement* const extension = urdf.root().FirstChildElement("mujoco");
  const XmlElement* const compiler = extension ? extension->FirstChildElement("compiler") : nullptr;
  return compiler ? std::string(attribute(*compiler, "meshdir")) : "";
}

void refuse_missing_meshes(const XmlFile& urdf, Refusals& faults) {
  const std::string mesh_folder = urdf_mesh_folder(urdf);
  for (const XmlElement* link = urdf.root().FirstChildElement("link"); link != nullptr;
       link = link->NextSiblingElement("link"))
    for (const XmlElement* shape = link->FirstChildElement("collision"); shape != nullptr;
         shape = shape->NextSiblingElement("collision")) {
      const XmlElement* const geometry = shape->FirstChildElement("geometry");
      const XmlElement* const mesh = geometry ? geometry->FirstChildElement("mesh") : nullptr;
      if (mesh != nullptr && has_attribute(*mesh, "filename"))
        refuse_mesh(urdf, *link, *mesh, mesh_folder, faults);
    }
}

}  // namespace legwright
