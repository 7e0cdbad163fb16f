// SPDX-License-Identifier: Apache-2.0
#include "mjcf/urdf/read_urdf.hpp"

#include <fmt/format.h>
#include <tinyxml2.h>

#include <algorithm>
#include <array>
#include <map>
#include <set>

#include "mjcf/text/compile.hpp"
#include "mjcf/text/listed.hpp"
#include "mjcf/text/numbers.hpp"
#include "mjcf/text/refusals.hpp"
#include "mjcf/text/unused_name.hpp"
#include "mjcf/text/xml.hpp"
#include "mjcf/urdf/check_urdf.hpp"
#include "mjcf/urdf/check_urdf_tree.hpp"
#include "mjcf/urdf/empty_shapes.hpp"
#include "mjcf/urdf/missing_meshes.hpp"
#include "mjcf/urdf/mjcf_of_spec.hpp"
#include "mjcf/urdf/speed_limits.hpp"
#include "mjcf/urdf/urdf_meshes.hpp"

namespace legwright {
namespace {

namespace fs = std::filesystem;

bool has_macro(const std::string& text) {
  return text.find("${") != std::string::npos || text.find("$(") != std::string::npos;
}

/// What a macro processor should have replaced, in an attribute or a name. Packages of meshes are
/// found without one.
bool is_macro(const XmlElement& element) {
  if (std::string_view(element.Name()).starts_with("xacro:")) return true;
  for (const auto* at = element.FirstAttribute(); at != nullptr; at = at->Next()) {
    const std::string value = at->Value();
    const bool mesh = std::string_view(element.Name()) == "mesh";
    if (has_macro(mesh ? behind_find_of_xacro(value).value_or(value) : value)) return true;
  }
  return false;
}

void refuse_macros(const XmlFile& xml) {
  for_each_element(xml.root(), [&](const XmlElement& element) {
    if (is_macro(element))
      throw xml.error(element,
                      "holds a macro of xacro (xacro:…, ${…} or $(…)), which has to be expanded "
                      "first: `xacro FILE.xacro > robot.urdf` with ROS, whose packages $(find …) "
                      "names, or `xacrodoc FILE.xacro -o robot.urdf` of the Python package "
                      "xacrodoc without");
  });
}

/// What MuJoCo's reader is told: to keep links and pictures, and to take paths as they are.
class UrdfEdits {
 public:
  UrdfEdits(const XmlFile& xml, MeshSources& meshes, MjcfOfUrdf& out)
      : xml_(xml),
        folder_(xml.file.parent_path()),
        mesh_folder_(urdf_mesh_folder(xml)),
        meshes_(meshes),
        out_(out) {
    document_.Parse(xml.text.data(), xml.text.size());
  }

  std::string apply() {
    XmlElement& root = *document_.RootElement();
    set_compiler(root);
    for (XmlElement* link = root.FirstChildElement("link"); link != nullptr;
         link = link->NextSiblingElement("link"))
      for (const char* shape : {"visual", "collision"}) edit_shapes(*link, shape);
    tell_meshes();
    empty_.tell(out_.notes);
    tell_empty_ranges(root);
    if (repeated_material_)
      out_.notes.emplace_back("shapes with several <material> have the first of them");
    tinyxml2::XMLPrinter printer;
    document_.Print(&printer);
    return printer.CStr();
  }

 private:
  /// CAD exporters write a range of nothing for a joint whose limits nobody gave; MuJoCo's reader
  /// takes it for none.
  void tell_empty_ranges(const XmlElement& root) {
    std::vector<std::string> names;
    for (const XmlElement* joint = root.FirstChildElement("joint"); joint != nullptr;
         joint = joint->NextSiblingElement("joint")) {
      const XmlElement* const limit = joint->FirstChildElement("limit");
      if (attribute(*joint, "type") != "revolute" || limit == nullptr) continue;
      const auto lower = parse_number(attribute(*limit, "lower")),
                 upper = parse_number(attribute(*limit, "upper"));
      if (lower.value_or(0.0) >= upper.value_or(0.0)) names.emplace_back(attribute(*joint, "name"));
    }
    if (names.empty()) return;
    out_.notes.push_back(
        fmt::format("<limit> has no range for {}, where upper is not above lower: any angle is "
                    "allowed; write the range",
                    listed(names)));
  }

  void set_compiler(XmlElement& root) {
    XmlElement* extension = root.FirstChildElement("mujoco");
    if (extension == nullptr) {
      extension = document_.NewElement("mujoco");
      root.InsertFirstChild(extension);
    }
    XmlElement* compiler = extension->FirstChildElement("compiler");
    if (compiler == nullptr) {
      compiler = document_.NewElement("compiler");
      extension->InsertFirstChild(compiler);
    }
    compiler->DeleteAttribute("meshdir");
    for (const char* off : {"fusestatic", "discardvisual", "strippath"})
      compiler->SetAttribute(off, "false");
  }

  void edit_shapes(XmlElement& link, const char* kind) {
    for (XmlElement* shape = link.FirstChildElement(kind); shape != nullptr;) {
      XmlElement* const next = shape->NextSiblingElement(kind);
      const bool only_seen = kind == std::string_view("visual");
      keep_first_material(*shape);
      if (empty_.mend(*shape, link, only_seen)) {
        link.DeleteChild(shape);
        shape = next;
        continue;
      }
      XmlElement* const geometry = shape->FirstChildElement("geometry");
      XmlElement* const mesh = geometry ? geometry->FirstChildElement("mesh") : nullptr;
      const char* const name = mesh ? mesh->Attribute("filename") : nullptr;
      if (name != nullptr) {
        if (const std::string path = path_of_mesh(name, link, only_seen); path.empty())
          link.DeleteChild(shape);
        else
          mesh->SetAttribute("filename", spec_name(path).c_str());
      }
      shape = next;
    }
  }

  /// Exporters write a shape's material twice, which MuJoCo's reader refuses.
  void keep_first_material(XmlElement& shape) {
    XmlElement* const first = shape.FirstChildElement("material");
    if (first == nullptr) return;
    while (XmlElement* const second = first->NextSiblingElement("material")) {
      shape.DeleteChild(second);
      repeated_material_ = true;
    }
  }

  /// Where a mesh lies; empty: it is left out. What may touch is there (refuse_missing_meshes()).
  std::string path_of_mesh(const std::string& name, const XmlElement& link, bool only_seen) {
    const UrdfMeshFile found = find_urdf_mesh(name, folder_, mesh_folder_);
    std::string shown = fs::path(name).filename().string();
    const bool missing = found.kind == UrdfMeshKind::missing;
    std::string fault;
    if (found.kind == UrdfMeshKind::unreadable) fault = "is of a format that MuJoCo cannot read";
    if (missing && only_seen) {
      fault = "is the file of a <visual> and not there";
      const std::string other = mesh_in_other_case(name, folder_, mesh_folder_);
      if (!other.empty())
        shown += fmt::format(" ({} is there: file names are case-sensitive here)", other);
    }
    bool colliding = false;
    if (const ColladaMesh* const read = missing ? nullptr : meshes_.collada.find(found.path)) {
      fault = read->fault;
      colliding = !only_seen && !read->is_flat && !fault.empty();
    }
    if (colliding)
      throw InputError(xml_.file.string(), 0, fmt::format("link '{}'", attribute(link, "name")),
                       fmt::format("the file '{}', which may touch, {}", found.path, fault));
    if (fault.empty()) {
      names_[found.kind].insert(shown);
      return found.path;
    }
    left_out_[fault].insert(shown);
    return "";
  }

  /// The path by which MuJoCo's reader is told of a mesh. It calls meshes by their files without
  /// folder and ending, and takes those that are called alike for one: each gets its own.
  std::string spec_name(const std::string& path) {
    const fs::path file = path;
    const std::string stem = unused_name(file.stem().string(), [&](const std::string& each) {
      return path_of_stem_.emplace(each, path).first->second != path;
    });
    if (stem == file.stem()) return path;
    std::string alias = stem + file.extension().string();
    meshes_.path_of[alias] = path;
    return alias;
  }

  void tell_meshes() {
    const auto listed_in = [](const std::set<std::string>& names) {
      return listed({names.begin(), names.end()});
    };
    if (const auto found = names_.find(UrdfMeshKind::other_format); found != names_.end())
      out_.notes.push_back(
          fmt::format("meshes that MuJoCo cannot read, with an .stl or .obj in their place: {}",
                      listed_in(found->second)));
    if (const auto found = names_.find(UrdfMeshKind::collada); found != names_.end())
      out_.notes.push_back(fmt::format(
          "meshes of Collada, which MuJoCo cannot read, written into the MJCF, of about "
          "{} triangles each at most: {}",
          kColladaTriangles, listed_in(found->second)));
    for (const auto& [fault, names] : left_out_)
      out_.left_out.push_back(fmt::format("left out, as each {}: {}", fault, listed_in(names)));
    out_.notes.insert(out_.notes.end(), out_.left_out.begin(), out_.left_out.end());
  }

  const XmlFile& xml_;
  tinyxml2::XMLDocument document_;
  const fs::path folder_;
  const std::string mesh_folder_;
  MeshSources& meshes_;
  MjcfOfUrdf& out_;
  bool repeated_material_ = false;
  EmptyShapes empty_;
  std::map<std::string, std::string> path_of_stem_;
  std::map<std::string, std::set<std::string>> left_out_;  // by why
  std::map<UrdfMeshKind, std::set<std::string>> names_;
};

/// MuJoCo's reason with its line ends as blanks; lines are those of another text.
std::string reason_of(std::string text) {
  std::replace(text.begin(), text.end(), '\n', ' ');
  if (const std::size_t line = text.find(", line "); line != std::string::npos) text.resize(line);
  return text;
}

}  // namespace

bool is_urdf(std::string_view text) {
  std::size_t at = 0;
  while (at < text.size()) {
    at = text.find('<', at);
    if (at == std::string_view::npos) return false;
    const std::string_view rest = text.substr(at);
    if (rest.starts_with("<!--")) {
      at = text.find("-->", at);
    } else if (rest.starts_with("<?") || rest.starts_with("<!")) {
      at = text.find('>', at);
    } else {
      const std::size_t end = rest.find_first_of(" \t\r\n/>");
      return rest.substr(0, end) == "<robot";
    }
  }
  return false;
}

UrdfReader::UrdfReader(const std::string& text, const fs::path& file, const FileReach& reach)
    : file_(file), xml_(load_xml(text, file)), collada_(file.parent_path(), reach) {
  refuse_macros(*xml_);
  if (xml_->root().FirstChildElement("link") == nullptr)
    throw xml_->error(xml_->root(), "has no <link>; a URDF is made of <link> and <joint> elements");
  Refusals faults;
  check_urdf(*xml_, faults);
  check_urdf_tree(*xml_, faults);
  refuse_missing_meshes(*xml_, faults);
  faults.throw_if_any();
}

MjcfOfUrdf UrdfReader::read(const UrdfMending& mending) {
  MjcfOfUrdf out;
  MeshSources meshes{collada_, {}};
  const std::string mended = UrdfEdits(*xml_, meshes, out).apply();
  call_engine(file_, [&] {
    std::array<char, 1000> error{};
    const SpecPointer spec(
        mj_parseXMLString(mended.c_str(), nullptr, error.data(), static_cast<int>(error.size())));
    if (!spec)
      throw InputError(file_.string(), 0, "URDF", "MuJoCo refuses it: " + reason_of(error.data()));
    mjsBody& trunk = mend_bodies(*spec, file_, out.notes);
    MjcfOfSpec written =
        mjcf_of_spec(*spec, trunk, mending, meshes, speed_limits(*xml_), out.notes);
    out.text = std::move(written.text);
    out.without_moments = std::move(written.without_moments);
  });
  return out;
}

MjcfOfUrdf mjcf_of_urdf(const std::string& text, const fs::path& file, const UrdfMending& mending) {
  return UrdfReader(text, file).read(mending);
}

}  // namespace legwright
