// SPDX-License-Identifier: Apache-2.0
#include "mjcf/shape/mesh_assets.hpp"

#include <filesystem>

#include "mjcf/text/numbers.hpp"
#include "mjcf/text/safe_path.hpp"

namespace legwright {
namespace {

std::string name_of_mesh(const XmlElement& mesh) {
  if (has_attribute(mesh, "name")) return std::string(attribute(mesh, "name"));
  return std::filesystem::path(slashed(std::string(attribute(mesh, "file")))).stem().string();
}

MeshAsset read_mesh(const XmlFile& xml, const XmlElement& element) {
  MeshAsset out;
  out.element = &element;
  if (const char* const text = inherited_attribute(xml, element, "scale"))
    if (const auto s = parse_numbers(text); s && s->size() == 3)
      out.scale = Eigen::Vector3d::Map(s->data());
  if (const char* const text = inherited_attribute(xml, element, "refquat"))
    if (const auto q = parse_numbers(text); q && q->size() == 4)
      out.turn = Eigen::Quaterniond((*q)[0], (*q)[1], (*q)[2], (*q)[3]).normalized();
  return out;
}

template <typename Visit>
void for_each_mesh(const XmlFile& xml, const Visit& visit) {
  for (const XmlElement* section = xml.root().FirstChildElement("asset"); section;
       section = section->NextSiblingElement("asset"))
    for (const XmlElement* mesh = section->FirstChildElement("mesh"); mesh;
         mesh = mesh->NextSiblingElement("mesh"))
      visit(*mesh);
}

/// The body that holds a part, through the frames around it.
const XmlElement* holding_body(const XmlElement& part) {
  const XmlElement* above = part.Parent()->ToElement();
  while (above && is_tag(*above, "frame")) above = above->Parent()->ToElement();
  return above;
}

}  // namespace

std::map<std::string, MeshAsset> find_meshes(const XmlFile& xml) {
  std::map<std::string, MeshAsset> out;
  for_each_mesh(
      xml, [&](const XmlElement& mesh) { out.emplace(name_of_mesh(mesh), read_mesh(xml, mesh)); });
  return out;
}

MeshAsset mesh_of(const XmlFile& xml, const XmlElement& geom) {
  const char* const name = inherited_attribute(xml, geom, "mesh");
  if (!name) return {};
  const XmlElement* found = nullptr;
  for_each_mesh(xml, [&](const XmlElement& mesh) {
    if (!found && name_of_mesh(mesh) == name) found = &mesh;
  });
  return found ? read_mesh(xml, *found) : MeshAsset{};
}

bool is_weightless(const XmlFile& xml, const XmlElement& geom) {
  for (const char* const name : {"mass", "density"})
    if (const char* const text = inherited_attribute(xml, geom, name))
      if (const auto number = parse_numbers(text); number && !number->empty())
        return number->front() == 0.0;
  return false;
}

bool mesh_grows(const XmlFile& xml, const XmlElement& geom) {
  const char* const type = inherited_attribute(xml, geom, "type");
  if (!type || type != std::string_view("mesh")) return false;
  const XmlElement* const body = holding_body(geom);
  return body && (body->FirstChildElement("inertial") || is_weightless(xml, geom));
}

}  // namespace legwright
