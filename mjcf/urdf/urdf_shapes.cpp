// SPDX-License-Identifier: Apache-2.0
#include "mjcf/urdf/urdf_shapes.hpp"

#include <fmt/format.h>

#include <cctype>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "mjcf/text/compile.hpp"
#include "mjcf/text/model_arrays.hpp"

namespace legwright {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr int kRings = 16, kSectors = 24;  // of an ellipsoid
constexpr int kFirstHiddenGroup = 3;       // MuJoCo's viewers draw the groups before

std::string vertex(const Vector3d& place) { return "v " + urdf_numbers(place) + "\n"; }

/// An ellipsoid of triangles, its vertices on the surface.
std::string ellipsoid_obj(const Vector3d& radii) {
  std::string out = vertex({0.0, 0.0, radii.z()});
  for (int ring = 1; ring < kRings; ++ring)
    for (int k = 0; k < kSectors; ++k) {
      const double down = std::numbers::pi * ring / kRings;
      const double round = 2.0 * std::numbers::pi * k / kSectors;
      const Vector3d unit(std::sin(down) * std::cos(round), std::sin(down) * std::sin(round),
                          std::cos(down));
      out += vertex(radii.cwiseProduct(unit));
    }
  out += vertex({0.0, 0.0, -radii.z()});
  const auto at = [](int ring, int k) { return 2 + (ring - 1) * kSectors + k % kSectors; };
  const int last = 2 + (kRings - 1) * kSectors;
  for (int k = 0; k < kSectors; ++k) {
    out += fmt::format("f 1 {} {}\n", at(1, k), at(1, k + 1));
    for (int ring = 1; ring + 1 < kRings; ++ring)
      out += fmt::format("f {0} {1} {2}\nf {0} {2} {3}\n", at(ring, k), at(ring + 1, k),
                         at(ring + 1, k + 1), at(ring, k + 1));
    out += fmt::format("f {} {} {}\n", at(kRings - 1, k), last, at(kRings - 1, k + 1));
  }
  return out;
}

}  // namespace

std::string urdf_number(double number) { return fmt::format("{}", number == 0.0 ? 0.0 : number); }

std::string urdf_numbers(const Vector3d& numbers) {
  return urdf_number(numbers.x()) + " " + urdf_number(numbers.y()) + " " + urdf_number(numbers.z());
}

void add_origin(tinyxml2::XMLPrinter& out, const Vector3d& place, const Matrix3d& rotation) {
  // The yaw first, and the rest of what is left: then no angle is that of two numbers near zero
  // while another one relies on it.
  const double yaw = std::atan2(rotation(1, 0), rotation(0, 0));
  const Matrix3d rest = Eigen::AngleAxisd(-yaw, Vector3d::UnitZ()) * rotation;
  const double pitch = std::atan2(-rest(2, 0), rest(0, 0));
  const double roll = std::atan2(-rest(1, 2), rest(1, 1));
  add_element(out, "origin",
              {{"xyz", urdf_numbers(place)}, {"rpy", urdf_numbers({roll, pitch, yaw})}});
}

UrdfShapes::UrdfShapes(const mjModel& model, std::string mesh_prefix)
    : model_(model), prefix_(std::move(mesh_prefix)) {}

std::string UrdfShapes::new_file(const std::string& wanted, std::string obj) {
  std::string name;
  for (const char c : wanted)
    name += std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '-' ? c : '_';
  while (!names_.insert(name).second) name += "_";
  meshes_.push_back({name + ".obj", std::move(obj)});
  return prefix_ + name + ".obj";
}

std::string UrdfShapes::mesh_file(int mesh) {
  if (const auto found = file_of_mesh_.find(mesh); found != file_of_mesh_.end())
    return found->second;
  std::string obj;
  const auto index = static_cast<std::ptrdiff_t>(mesh);
  const float* const vertices = model_.mesh_vert + std::ptrdiff_t{3} * model_.mesh_vertadr[index];
  for (int k = 0; k < model_.mesh_vertnum[index]; ++k)
    obj += vertex(Eigen::Vector3f::Map(vertices + std::ptrdiff_t{3} * k).cast<double>());
  const int* const faces = model_.mesh_face + std::ptrdiff_t{3} * model_.mesh_faceadr[index];
  for (int k = 0; k < model_.mesh_facenum[index]; ++k) {
    const int* const face = faces + std::ptrdiff_t{3} * k;
    obj += fmt::format("f {} {} {}\n", face[0] + 1, face[1] + 1, face[2] + 1);
  }
  std::string name = name_of(model_, mjOBJ_MESH, mesh);
  if (name.empty()) name = fmt::format("mesh_{}", mesh);
  return file_of_mesh_[mesh] = new_file(name, std::move(obj));
}

std::string UrdfShapes::ellipsoid_file(const Vector3d& radii) {
  const std::string obj = ellipsoid_obj(radii);
  for (const UrdfMesh& mesh : meshes_)
    if (mesh.obj == obj) return prefix_ + mesh.file;
  return new_file("ellipsoid", obj);
}

std::vector<UrdfShapes::Part> UrdfShapes::parts_of(int geom) {
  const Vector3d size = vector_at(model_.geom_size, geom);
  const auto sphere = [&](double z) {
    return Part{{0.0, 0.0, z}, "sphere", {{"radius", urdf_number(size[0])}}};
  };
  const auto cylinder = [&] {
    return Part{Vector3d::Zero(),
                "cylinder",
                {{"radius", urdf_number(size[0])}, {"length", urdf_number(2.0 * size[1])}}};
  };
  switch (model_.geom_type[geom]) {
    case mjGEOM_SPHERE:
      return {sphere(0.0)};
    case mjGEOM_CYLINDER:
      return {cylinder()};
    case mjGEOM_BOX:
      return {{Vector3d::Zero(), "box", {{"size", urdf_numbers(2.0 * size)}}}};
    case mjGEOM_CAPSULE:
      ++capsules_;
      return {cylinder(), sphere(size[1]), sphere(-size[1])};
    case mjGEOM_ELLIPSOID:
      ++ellipsoids_;
      return {{Vector3d::Zero(), "mesh", {{"filename", ellipsoid_file(size)}}}};
    case mjGEOM_MESH:
      return {{Vector3d::Zero(), "mesh", {{"filename", mesh_file(model_.geom_dataid[geom])}}}};
    default:
      return {};
  }
}

void UrdfShapes::add_part(tinyxml2::XMLPrinter& out, int geom, const Part& part,
                          const Vector3d& origin, bool visual) const {
  const Matrix3d rotation = rotation_at(model_.geom_quat, geom);
  out.OpenElement(visual ? "visual" : "collision");
  add_origin(out, vector_at(model_.geom_pos, geom) - origin + rotation * part.place, rotation);
  out.OpenElement("geometry");
  add_element(out, part.shape, part.attributes);
  out.CloseElement();
  if (visual) {
    const int material = model_.geom_matid[geom];
    const float* const colour = (material >= 0 ? model_.mat_rgba : model_.geom_rgba) +
                                std::ptrdiff_t{4} * (material >= 0 ? material : geom);
    const std::string rgba = fmt::format("{} {} {} {}", colour[0], colour[1], colour[2], colour[3]);
    std::string name = material >= 0 ? name_of(model_, mjOBJ_MATERIAL, material) : "";
    if (name.empty()) name = "rgba " + rgba;
    open_element(out, "material", {{"name", name}});
    add_element(out, "color", {{"rgba", rgba}});
    out.CloseElement();
  }
  out.CloseElement();
}

void UrdfShapes::add_geoms(tinyxml2::XMLPrinter& out, int body, const Vector3d& origin) {
  const int first = model_.body_geomadr[body];
  for (int geom = first; geom < first + model_.body_geomnum[body]; ++geom) {
    const bool touches = model_.geom_contype[geom] != 0 || model_.geom_conaffinity[geom] != 0;
    const bool drawn = model_.geom_group[geom] < kFirstHiddenGroup;
    const std::vector<Part> parts = touches || drawn ? parts_of(geom) : std::vector<Part>();
    if (parts.empty()) ++left_out_;
    for (const Part& part : parts) {
      if (drawn) add_part(out, geom, part, origin, true);
      if (touches) add_part(out, geom, part, origin, false);
    }
  }
}

}  // namespace legwright
