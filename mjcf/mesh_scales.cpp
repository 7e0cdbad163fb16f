// SPDX-License-Identifier: Apache-2.0
#include "mjcf/mesh_scales.hpp"

#include <cmath>
#include <map>
#include <optional>

#include "mjcf/compile.hpp"
#include "mjcf/feet.hpp"
#include "mjcf/numbers.hpp"

namespace legwright {
namespace {

using Eigen::Vector3d;

constexpr double kAlong = 1.0 - 1e-9;  // cosine: parallel but for rounding

/// Name of a mesh asset: its own, else that of its file.
std::string mesh_name(const XmlElement& mesh) {
  if (has_attribute(mesh, "name")) return std::string(attribute(mesh, "name"));
  return std::filesystem::path(std::string(attribute(mesh, "file"))).stem().string();
}

/// How a geom wants its mesh scaled along the mesh's axes; ones where it must stay as it is.
Vector3d wanted_scale(const XmlFile& xml, const mjModel& model, const TreeElements& elements,
                      int geom, const StretchMap& stretches, const Eigen::VectorXd& s) {
  const int body = model.geom_bodyid[geom];
  const auto found = stretches.find(name_of(model, mjOBJ_BODY, body));
  if (found == stretches.end() || collides(model, geom) || model.geom_type[geom] != mjGEOM_MESH)
    return Vector3d::Ones();
  const XmlElement& element = *elements.geoms[static_cast<std::size_t>(geom)];
  const bool weighs =
      !elements.bodies[static_cast<std::size_t>(body)]->FirstChildElement("inertial") &&
      !is_weightless(xml, element);
  if (weighs) return Vector3d::Ones();
  const Eigen::Matrix3d axes = pose_in_body(xml, element).linear();
  Vector3d scale = Vector3d::Ones();
  for (const Stretch& stretch : found->second) {
    Eigen::Index along = -1;
    for (Eigen::Index k = 0; k < 3; ++k)
      if (std::abs(axes.col(k).dot(stretch.direction)) > kAlong) along = k;
    if (along < 0) return Vector3d::Ones();  // oblique: a scale would shear it
    scale[along] *= s[stretch.parameter] / stretch.initial;
  }
  return scale;
}

}  // namespace

bool is_weightless(const XmlFile& xml, const XmlElement& geom) {
  for (const char* const name : {"mass", "density"})
    if (const char* const text = inherited_attribute(xml, geom, name))
      if (const auto number = parse_numbers(text); number && !number->empty())
        return number->front() == 0.0;
  return false;
}

void write_mesh_scales(const XmlFile& xml, const mjModel& model, const TreeElements& elements,
                       const StretchMap& stretches, const Eigen::VectorXd& s, TextEdits& edits) {
  std::map<std::string, std::optional<Vector3d>> wanted;  // by asset; nothing: they disagree
  for (int g = 0; g < model.ngeom; ++g) {
    const char* const mesh =
        inherited_attribute(xml, *elements.geoms[static_cast<std::size_t>(g)], "mesh");
    if (!mesh) continue;
    const Vector3d scale = wanted_scale(xml, model, elements, g, stretches, s);
    const auto [at, is_new] = wanted.try_emplace(mesh, scale);
    if (!is_new && at->second && *at->second != scale) at->second.reset();
  }
  for (const XmlElement* section = xml.root().FirstChildElement("asset"); section;
       section = section->NextSiblingElement("asset"))
    for (const XmlElement* mesh = section->FirstChildElement("mesh"); mesh;
         mesh = mesh->NextSiblingElement("mesh")) {
      const auto found = wanted.find(mesh_name(*mesh));
      if (found == wanted.end() || !found->second || *found->second == Vector3d::Ones()) continue;
      const char* const text = inherited_attribute(xml, *mesh, "scale");
      const auto own = text ? parse_numbers(text) : std::vector<double>{1.0, 1.0, 1.0};
      if (!own || own->size() != 3) continue;
      edits.set_numbers(*mesh, "scale", Vector3d::Map(own->data()).cwiseProduct(*found->second));
    }
}

}  // namespace legwright
