// SPDX-License-Identifier: Apache-2.0
#include "mjcf/text/elements.hpp"

#include <cctype>
#include <numbers>
#include <string>

#include "mjcf/text/model_arrays.hpp"
#include "mjcf/text/numbers.hpp"
#include "optimizer/design/rotation.hpp"

namespace legwright {
namespace {

using Eigen::Matrix3d;
using Eigen::Quaterniond;
using Eigen::Vector3d;

/// Visits the parts of one body, also those in its frames, in the order of the document.
template <typename Visit>
void for_each_part(const XmlElement& body, const Visit& visit) {
  for (const XmlElement* part = body.FirstChildElement(); part; part = part->NextSiblingElement()) {
    if (is_tag(*part, "frame"))
      for_each_part(*part, visit);
    else
      visit(*part);
  }
}

class Collector {
 public:
  explicit Collector(TreeElements& out) : out_(out) {}

  void world(const XmlElement& root) {
    out_.bodies.push_back(nullptr);
    for (const char* const tag : {"geom", "site"})
      for (const XmlElement* section = root.FirstChildElement("worldbody"); section;
           section = section->NextSiblingElement("worldbody"))
        own(*section, tag);
    for (const XmlElement* section = root.FirstChildElement("worldbody"); section;
         section = section->NextSiblingElement("worldbody"))
      children(*section);
  }

 private:
  void children(const XmlElement& body) {
    for_each_part(body, [&](const XmlElement& part) {
      if (!is_tag(part, "body")) return;
      out_.bodies.push_back(&part);
      for (const char* const tag : {"joint", "geom", "site"}) own(part, tag);
      children(part);
    });
  }
  void own(const XmlElement& body, std::string_view tag) {
    for_each_part(body, [&](const XmlElement& part) {
      if (tag == "joint" && (is_tag(part, "joint") || is_tag(part, "freejoint")))
        out_.joints.push_back(&part);
      if (tag == "geom" && is_tag(part, "geom")) out_.geoms.push_back(&part);
      if (tag == "site" && is_tag(part, "site")) out_.sites.push_back(&part);
    });
  }

  TreeElements& out_;
};

bool agree(const mjModel& model, mjtObj type, const std::vector<const XmlElement*>& elements) {
  for (std::size_t id = 0; id < elements.size(); ++id) {
    if (!elements[id]) continue;
    const char* const name = mj_id2name(&model, type, static_cast<int>(id));
    if (attribute(*elements[id], "name") != (name ? name : "")) return false;
  }
  return true;
}

Quaterniond euler(const Vector3d& angles, const std::string& order) {
  Quaterniond out = Quaterniond::Identity();
  for (int k = 0; k < 3 && k < static_cast<int>(order.size()); ++k) {
    const auto c = static_cast<unsigned char>(order[static_cast<std::size_t>(k)]);
    const Quaterniond turn(Eigen::AngleAxisd(angles[k], Vector3d::Unit(std::tolower(c) - 'x')));
    out = std::islower(c) ? out * turn : turn * out;
  }
  return out;
}

Matrix3d orientation_of(const XmlFile& xml, const XmlElement& element) {
  // What the element says itself holds before what its class says in another way; only a quat
  // gives way to either.
  bool has_own = false;
  for (const char* const name : {"axisangle", "euler", "xyaxes", "zaxis"})
    has_own = has_own || has_attribute(element, name);
  const auto read = [&](const char* name) {
    const char* const text =
        has_own ? element.Attribute(name) : inherited_attribute(xml, element, name);
    return text ? parse_numbers(text).value_or(std::vector<double>{}) : std::vector<double>{};
  };
  const double unit =
      compiler_setting(xml, "angle", "degree") == "radian" ? 1.0 : std::numbers::pi / 180;
  if (const auto a = read("axisangle"); a.size() == 4)
    return Eigen::AngleAxisd(unit * a[3], Vector3d(a[0], a[1], a[2]).normalized())
        .toRotationMatrix();
  if (const auto e = read("euler"); e.size() == 3)
    return euler(unit * Vector3d(e[0], e[1], e[2]), compiler_setting(xml, "eulerseq", "xyz"))
        .toRotationMatrix();
  if (const auto v = read("xyaxes"); v.size() == 6) {
    const Vector3d x = Vector3d(v[0], v[1], v[2]).normalized(), given(v[3], v[4], v[5]);
    const Vector3d y = (given - x * x.dot(given)).normalized();
    Matrix3d out;
    out << x, y, x.cross(y);
    return out;
  }
  if (const auto z = read("zaxis"); z.size() == 3)
    return smallest_rotation(Vector3d::UnitZ(), Vector3d(z[0], z[1], z[2])).toRotationMatrix();
  if (const auto q = read("quat"); q.size() == 4) return rotation_of(q.data());
  return Matrix3d::Identity();
}

}  // namespace

std::string compiler_setting(const XmlFile& xml, const char* name, const char* otherwise) {
  std::string value = otherwise;
  for (const XmlElement* section = xml.root().FirstChildElement("compiler"); section;
       section = section->NextSiblingElement("compiler"))
    if (has_attribute(*section, name)) value = attribute(*section, name);
  return value;
}

TreeElements find_elements(const XmlFile& xml, const mjModel& model) {
  TreeElements out;
  Collector(out).world(xml.root());
  const bool same = out.bodies.size() == static_cast<std::size_t>(model.nbody) &&
                    out.joints.size() == static_cast<std::size_t>(model.njnt) &&
                    out.geoms.size() == static_cast<std::size_t>(model.ngeom) &&
                    out.sites.size() == static_cast<std::size_t>(model.nsite) &&
                    agree(model, mjOBJ_BODY, out.bodies) && agree(model, mjOBJ_JOINT, out.joints) &&
                    agree(model, mjOBJ_GEOM, out.geoms) && agree(model, mjOBJ_SITE, out.sites);
  if (!same)
    throw xml.error(xml.root(),
                    "MuJoCo's bodies, joints, geoms and sites are not those of the file, in its "
                    "order; write generated parts out as plain elements");
  return out;
}

SectionElements::SectionElements(const XmlFile& xml, const char* section) : root_(xml.root()) {
  for (const XmlElement* one = root_.FirstChildElement(section); one;
       one = one->NextSiblingElement(section))
    for (const XmlElement* element = one->FirstChildElement(); element;
         element = element->NextSiblingElement())
      elements_.push_back(element);
}

const XmlElement& SectionElements::operator[](int id) const {
  const auto at = static_cast<std::size_t>(id);
  return at < elements_.size() ? *elements_[at] : root_;
}

Eigen::Isometry3d pose_of(const XmlFile& xml, const XmlElement& element) {
  Eigen::Isometry3d out = Eigen::Isometry3d::Identity();
  if (const char* const text = inherited_attribute(xml, element, "pos"))
    if (const auto p = parse_numbers(text); p && p->size() == 3)
      out.translation() = Vector3d((*p)[0], (*p)[1], (*p)[2]);
  out.linear() = orientation_of(xml, element);
  return out;
}

Eigen::Isometry3d pose_in_body(const XmlFile& xml, const XmlElement& element) {
  Eigen::Isometry3d out = pose_of(xml, element);
  for (const XmlElement* above = element.Parent()->ToElement(); above && is_tag(*above, "frame");
       above = above->Parent()->ToElement())
    out = pose_of(xml, *above) * out;
  return out;
}

}  // namespace legwright
