// SPDX-License-Identifier: Apache-2.0
#include "mjcf/urdf/collada.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <memory>
#include <numbers>
#include <optional>
#include <string_view>
#include <vector>

#include "mjcf/text/numbers.hpp"
#include "mjcf/text/xml.hpp"

namespace legwright {
namespace {

using Eigen::Affine3d;
using Eigen::Vector3d;

constexpr XmlLimits kColladaLimits{std::size_t{64} << 20, std::size_t{1} << 20, 200'000, 90};
constexpr int kDeepest = 32;            // nodes that show others
constexpr double kFarthestPoint = 1e6;  // [m]
// Numbers read, parts shown and corners placed: some ten times what parts of robots have.
constexpr std::size_t kMostWork = 20'000'000, kWorkOfPart = 100;

template <class Visit>
void for_each_child(const XmlElement& parent, const char* name, const Visit& visit) {
  for (const XmlElement* child = parent.FirstChildElement(name); child != nullptr;
       child = child->NextSiblingElement(name))
    visit(*child);
}

std::string_view text_of(const XmlElement& element) {
  const char* const text = element.GetText();
  return text == nullptr ? std::string_view() : std::string_view(text);
}

class ColladaReader {
 public:
  ColladaReader(std::string text, const std::filesystem::path& file)
      : xml_(load_xml(std::move(text), file, kColladaLimits)) {}

  DrawnMesh run() {
    const XmlElement& root = xml_->root();
    if (!is_tag(root, "COLLADA"))
      throw xml_->error(root, "is no <COLLADA>, which a .dae file holds");
    for_each_element(root, [&](const XmlElement& element) {
      if (has_attribute(element, "id")) by_id_[std::string(attribute(element, "id"))] = &element;
    });
    const Affine3d scaled(Eigen::Scaling(metres_per_unit(root)));
    const XmlElement* const scene = scene_of(root);
    if (scene != nullptr)
      for_each_child(*scene, "node", [&](const XmlElement& node) { add_node(node, scaled); });
    if (scene == nullptr || scene->FirstChildElement("node") == nullptr)
      for_each_child(root, "library_geometries", [&](const XmlElement& library) {
        for_each_child(library, "geometry",
                       [&](const XmlElement& geometry) { add_geometry(geometry, scaled); });
      });
    if (out_.faces.empty()) throw xml_->error(root, "shows no triangles or polygons");
    return std::move(out_);
  }

 private:
  /// The scene that the file shows: the one that <scene> names, else the first.
  const XmlElement* scene_of(const XmlElement& root) const {
    const XmlElement* const shown = root.FirstChildElement("scene");
    const XmlElement* const instance =
        shown ? shown->FirstChildElement("instance_visual_scene") : nullptr;
    if (instance != nullptr)
      if (const XmlElement* const scene = named(attribute(*instance, "url"))) return scene;
    const XmlElement* const library = root.FirstChildElement("library_visual_scenes");
    return library ? library->FirstChildElement("visual_scene") : nullptr;
  }

  /// Throws where a small file asks for more than any robot needs.
  void spend(const XmlElement& at, std::size_t work) {
    work_ += work;
    if (work_ > kMostWork)
      throw xml_->error(at,
                        "the file shows more than any robot has: parts within parts, or "
                        "millions of points; simplify it");
  }

  double metres_per_unit(const XmlElement& root) const {
    const XmlElement* const asset = root.FirstChildElement("asset");
    const XmlElement* const unit = asset ? asset->FirstChildElement("unit") : nullptr;
    if (unit == nullptr || !has_attribute(*unit, "meter")) return 1.0;
    const auto metres = parse_number(attribute(*unit, "meter"));
    if (!metres || !(*metres > 0.0))
      throw xml_->error(*unit, "attribute meter: is no length; write 1 for metres");
    return *metres;
  }

  std::vector<double> numbers_of(const XmlElement& element, std::optional<std::size_t> count = {}) {
    auto numbers = parse_numbers(text_of(element));
    if (!numbers) throw xml_->error(element, explain_bad_number(text_of(element)));
    spend(element, numbers->size());
    if (count && numbers->size() != *count)
      throw xml_->error(element,
                        fmt::format("holds {} numbers, {} are expected", numbers->size(), *count));
    return std::move(*numbers);
  }

  /// What a reference like "#mesh" or "mesh" names; null where it is of another file or missing.
  const XmlElement* named(std::string_view reference) const {
    if (reference.starts_with('#')) reference.remove_prefix(1);
    const auto found = by_id_.find(std::string(reference));
    return found == by_id_.end() ? nullptr : found->second;
  }

  /// The turns and shifts of a node apply one after the other.
  Affine3d placed(const XmlElement& node) {
    Affine3d out = Affine3d::Identity();
    for (const XmlElement* step = node.FirstChildElement(); step != nullptr;
         step = step->NextSiblingElement()) {
      if (is_tag(*step, "matrix")) {
        const std::vector<double> m = numbers_of(*step, 16);
        Eigen::Matrix4d matrix = Eigen::Matrix<double, 4, 4, Eigen::RowMajor>::Map(m.data());
        matrix.row(3) << 0.0, 0.0, 0.0, 1.0;
        out = out * Affine3d(matrix);
      } else if (is_tag(*step, "translate")) {
        out.translate(Vector3d(Vector3d::Map(numbers_of(*step, 3).data())));
      } else if (is_tag(*step, "scale")) {
        out.scale(Vector3d(Vector3d::Map(numbers_of(*step, 3).data())));
      } else if (is_tag(*step, "rotate")) {
        const std::vector<double> r = numbers_of(*step, 4);
        const Vector3d axis = Vector3d::Map(r.data());
        if (axis.norm() > 0.0)
          out.rotate(Eigen::AngleAxisd(r[3] * std::numbers::pi / 180.0, axis.normalized()));
      }
    }
    return out;
  }

  void add_node(const XmlElement& node, const Affine3d& above, int depth = 0) {
    spend(node, kWorkOfPart);
    if (depth > kDeepest)
      throw xml_->error(node, "shows nodes within nodes, deeper than 32: without end?");
    const Affine3d here = above * placed(node);
    for_each_child(node, "instance_geometry", [&](const XmlElement& instance) {
      const XmlElement* const geometry = named(attribute(instance, "url"));
      if (geometry != nullptr) add_geometry(*geometry, here);
    });
    for_each_child(node, "node",
                   [&](const XmlElement& below) { add_node(below, here, depth + 1); });
    for_each_child(node, "instance_node", [&](const XmlElement& instance) {
      const XmlElement* const below = named(attribute(instance, "url"));
      if (below != nullptr) add_node(*below, here, depth + 1);
    });
  }

  void add_geometry(const XmlElement& geometry, const Affine3d& place) {
    const XmlElement* const mesh = geometry.FirstChildElement("mesh");
    if (mesh == nullptr) return;
    const auto known = parts_.find(mesh);
    const DrawnMesh& part =
        known != parts_.end() ? known->second : parts_[mesh] = triangles_of(*mesh);
    spend(geometry, kWorkOfPart + part.vertices.size() + part.faces.size());
    const auto first = static_cast<std::uint32_t>(out_.vertices.size() / 3);
    for (std::size_t v = 0; v + 2 < part.vertices.size(); v += 3) {
      const Vector3d at =
          place * Vector3d(part.vertices[v], part.vertices[v + 1], part.vertices[v + 2]);
      for (const double x : at) {
        if (!(std::abs(x) < kFarthestPoint))
          throw xml_->error(geometry, fmt::format("has a point {:.3g} m away", std::abs(x)));
        out_.vertices.push_back(static_cast<float>(x));
      }
    }
    const bool mirrored = place.linear().determinant() < 0.0;
    for (std::size_t f = 0; f + 2 < part.faces.size(); f += 3) {
      out_.faces.push_back(first + part.faces[f]);
      out_.faces.push_back(first + part.faces[f + (mirrored ? 2 : 1)]);
      out_.faces.push_back(first + part.faces[f + (mirrored ? 1 : 2)]);
    }
  }

  DrawnMesh triangles_of(const XmlElement& mesh) {
    DrawnMesh out;
    const XmlElement* const vertices = mesh.FirstChildElement("vertices");
    if (vertices == nullptr) return out;
    for_each_child(*vertices, "input", [&](const XmlElement& input) {
      if (attribute(input, "semantic") == "POSITION") out.vertices = positions(input);
    });
    for (const char* kind : {"triangles", "polylist", "polygons"})
      for_each_child(mesh, kind, [&](const XmlElement& faces) { add_faces(faces, out); });
    return without_unused(out);
  }

  /// Points of lines and of nothing are left out.
  static DrawnMesh without_unused(const DrawnMesh& mesh) {
    constexpr auto kUnused = std::numeric_limits<std::uint32_t>::max();
    std::vector<std::uint32_t> renamed(mesh.vertices.size() / 3, kUnused);
    DrawnMesh out;
    for (const std::uint32_t vertex : mesh.faces) {
      std::uint32_t& own = renamed[vertex];
      if (own == kUnused) {
        own = static_cast<std::uint32_t>(out.vertices.size() / 3);
        const auto from = mesh.vertices.begin() + 3 * static_cast<std::ptrdiff_t>(vertex);
        out.vertices.insert(out.vertices.end(), from, from + 3);
      }
      out.faces.push_back(own);
    }
    return out;
  }

  std::vector<float> positions(const XmlElement& input) {
    const XmlElement* const source = named(attribute(input, "source"));
    const XmlElement* const array = source ? source->FirstChildElement("float_array") : nullptr;
    if (array == nullptr) throw xml_->error(input, "names no <source> with a <float_array>");
    const XmlElement* const common = source->FirstChildElement("technique_common");
    const XmlElement* const accessor = common ? common->FirstChildElement("accessor") : nullptr;
    std::size_t stride = 3;
    if (accessor != nullptr && has_attribute(*accessor, "stride"))
      stride = whole(*accessor, parse_number(attribute(*accessor, "stride")), 3, 64);
    const std::vector<double> numbers = numbers_of(*array);
    std::vector<float> out;
    out.reserve(numbers.size());
    for (std::size_t at = 0; at + 2 < numbers.size(); at += stride)
      for (std::size_t k = 0; k < 3; ++k) out.push_back(static_cast<float>(numbers[at + k]));
    return out;
  }

  std::size_t whole(const XmlElement& at, const std::optional<double>& number, double least,
                    double most) const {
    if (!number || *number != std::floor(*number) || *number < least || *number > most)
      throw xml_->error(at,
                        fmt::format("holds what is no whole number from {} to {}", least, most));
    return static_cast<std::size_t>(*number);
  }

  /// How the indices of a corner follow each other: so many, of which one is the vertex.
  struct Corner {
    std::size_t vertex = 0, size = 1;
  };
  Corner corner_of(const XmlElement& faces) const {
    Corner out;
    for_each_child(faces, "input", [&](const XmlElement& input) {
      const std::size_t offset = has_attribute(input, "offset")
                                     ? whole(input, parse_number(attribute(input, "offset")), 0, 64)
                                     : 0;
      if (attribute(input, "semantic") == "VERTEX") out.vertex = offset;
      out.size = std::max(out.size, offset + 1);
    });
    return out;
  }

  void add_faces(const XmlElement& faces, DrawnMesh& out) {
    const Corner corner = corner_of(faces);
    const XmlElement* const counts = faces.FirstChildElement("vcount");
    const std::vector<double> corners = counts ? numbers_of(*counts) : std::vector<double>();
    for_each_child(faces, "p", [&](const XmlElement& p) {
      const std::vector<double> indices = numbers_of(p);
      spend(p, corners.size());
      const std::size_t given = indices.size() / corner.size;
      const std::size_t vertices = out.vertices.size() / 3;
      const double most = static_cast<double>(vertices) - 1.0;
      const auto add_fan = [&](std::size_t first, std::size_t size) {
        const auto vertex = [&](std::size_t k) {
          return static_cast<std::uint32_t>(
              whole(p, indices[(first + k) * corner.size + corner.vertex], 0, most));
        };
        for (std::size_t k = 2; k < size; ++k)
          for (const std::size_t of : {std::size_t{0}, k - 1, k}) out.faces.push_back(vertex(of));
      };
      if (is_tag(faces, "polygons")) return add_fan(0, given);
      if (counts == nullptr) {
        for (std::size_t first = 0; first + 3 <= given; first += 3) add_fan(first, 3);
        return;
      }
      std::size_t first = 0;
      for (const double count : corners) {
        const std::size_t size = whole(*counts, count, 0, static_cast<double>(given - first));
        add_fan(first, size);
        first += size;
      }
    });
  }

  std::unique_ptr<XmlFile> xml_;
  std::map<std::string, const XmlElement*> by_id_;
  std::map<const XmlElement*, DrawnMesh> parts_;
  DrawnMesh out_;
  std::size_t work_ = 0;
};

}  // namespace

DrawnMesh read_collada(std::string text, const std::filesystem::path& file) {
  return ColladaReader(std::move(text), file).run();
}

}  // namespace legwright
