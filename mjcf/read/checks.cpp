// SPDX-License-Identifier: Apache-2.0
#include "mjcf/read/checks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "mjcf/text/compile.hpp"
#include "mjcf/text/elements.hpp"
#include "mjcf/text/mjcf_words.hpp"
#include "mjcf/text/nearest_word.hpp"
#include "mjcf/text/numbers.hpp"
#include "mjcf/text/size_limits.hpp"
#include "mjcf/text/written_out.hpp"
#include "optimizer/design/morphology.hpp"

namespace legwright {
namespace {

/// Attributes that hold numbers wherever they occur in MJCF, but for <flag>, <config> and <text>.
/// MuJoCo reads "nan" and "0x10" in them.
constexpr std::string_view kNumbers =
    " accel act actdim actrange actuatorfrcrange adhesion alpha ambient anchor area armature"
    " attenuation axis axisangle azimuth bias biasprm bindpos bindquat boundinertia boundmass"
    " bulbradius ccd_iterations ccd_tolerance center coef cogging conaffinity condim contype"
    " cranklength ctrl ctrlrange cutoff damping dampratio delay density diameter diaginertia"
    " diffuse dim dir divisor dynprm elevation emission euler exponent extent ffrange fluidcoef"
    " focal focalpixel fogend fogstart force forcerange fovy fpmax friction frictionloss fromto"
    " fullinertia fvmax gain gainprm gap gear glow gravcomp gravity gridsize group haze height imax"
    " impratio inductance inheritrange intensity interval inttotal ipd iterations ki kp kv"
    " lengthrange linewidth lmax lmin ls_iterations ls_tolerance lugre magnetic margin markrgb mass"
    " maxforce maxhullvert meaninertia meanmass meansize metallic motorconst mpos mquat ncol"
    " nconmax njmax nkey noise nominal normal noslip_iterations noslip_tolerance nrow nsample num"
    " numquads numslices numstacks nuserdata nuser_actuator nuser_body nuser_cam nuser_geom"
    " nuser_jnt nuser_sensor nuser_site nuser_tendon o_friction o_margin o_solimp o_solref"
    " offheight offsamples offwidth polycoef pos posrange principal principalpixel priority prm"
    " qpos quat qvel radius random range realtime ref reflectance refpos refquat relpose resistance"
    " resolution rgb1 rgb2 rgba roughness saturation scale sdf_initpoints sdf_iterations"
    " sensorsize settotalmass shadowclip shadowscale shadowsize shininess size sleep_tolerance"
    " slewmax softness solimp solimpfriction solimplimit solmix solref solreffriction solreflimit"
    " specular springdamper springlength springref stiffness stiffnessrot surfacevel tausmooth"
    " texcoord texrepeat thermal time timeconst timestep tolerance tolrange torque torquescale user"
    " velrange vertex vertweight viscosity vmax width wind xyaxes zaxis zfar znear ";

/// Elements below <visual> that hold nothing but numbers; elsewhere some of their names are words.
constexpr std::string_view kNumberElements = " rgba scale map quality ";

/// Whether a list with a blank before and behind each entry holds a word, which has no blank.
bool is_listed(std::string_view list, std::string_view word) {
  for (std::size_t at = list.find(word); at != std::string_view::npos; at = list.find(word, at + 1))
    if (list[at - 1] == ' ' && list[at + word.size()] == ' ') return true;
  return false;
}

constexpr std::string_view kGenerators = " composite replicate attach ";
constexpr std::string_view kSoftBodies = " flexcomp flex ";

/// Beyond these bounds digits get lost that the checks after a rewrite look at.
void check_magnitude(const XmlFile& xml, const XmlElement& element, std::string_view name,
                     const std::vector<double>& values) {
  const double bound = name == "pos" || name == "fromto" ? 1e3 : 1e10;
  for (const double value : values)
    if (std::abs(value) > bound)
      throw xml.error(element, fmt::format("attribute {}: {} is beyond any robot (at most {} in SI "
                                           "units; is the file in millimetres or grams?)",
                                           name, value, bound));
}

bool holds_numbers(const XmlElement& element, std::string_view attribute) {
  if (is_tag(element, "config") || is_tag(element, "text") || is_tag(element, "flag")) return false;
  return is_listed(kNumbers, attribute) || is_listed(kNumberElements, element.Name()) ||
         (is_tag(element, "numeric") && attribute == "data");
}

void check_numbers(const XmlFile& xml, const XmlElement& element) {
  for (const tinyxml2::XMLAttribute* a = element.FirstAttribute(); a; a = a->Next()) {
    if (!holds_numbers(element, a->Name())) continue;
    const auto values = parse_numbers(a->Value());
    if (values && values->empty())  // MuJoCo takes it for absent, or for another class's
      throw xml.error(
          element, fmt::format("attribute {}: is empty; write a number, or remove it", a->Name()));
    if (!values)
      throw xml.error(element,
                      fmt::format("attribute {}: {}", a->Name(), explain_bad_number(a->Value())));
    check_magnitude(xml, element, a->Name(), *values);
  }
}

constexpr std::size_t kLongestName = 200;  // [bytes], of a trajectory's columns too

/// References like &#7; bring what no UTF-8 check of the text sees; a terminal would obey it.
void check_texts(const XmlFile& xml, const XmlElement& element) {
  for (const tinyxml2::XMLAttribute* a = element.FirstAttribute(); a; a = a->Next()) {
    const std::string_view value = a->Value();
    for (const char c : value)
      if ((static_cast<unsigned char>(c) < 0x20 && c != '\t' && c != '\n' && c != '\r') ||
          c == 0x7F)
        throw xml.error(
            element, fmt::format("attribute {}: holds a control character; remove it", a->Name()));
    const bool is_name = a->Name() == std::string_view("name") ||
                         a->Name() == std::string_view("class") ||
                         a->Name() == std::string_view("model");
    if (is_name && value.size() > kLongestName)
      throw InputError(xml.file.string(), element.GetLineNum(), element.Name(),
                       fmt::format("attribute {}: {} bytes long; a name may have {}, shorten it",
                                   a->Name(), value.size(), kLongestName));
  }
}

void check_axis(const XmlFile& xml, const XmlElement& element) {
  if (!is_tag(element, "joint") || !has_attribute(element, "axis")) return;
  const auto axis = parse_numbers(attribute(element, "axis"));
  if (axis->size() == 3 && std::hypot((*axis)[0], (*axis)[1], (*axis)[2]) < 1e-8)
    throw xml.error(
        element,
        "attribute axis: a zero axis has no direction; write the direction the hinge turns "
        "about, like 0 1 0");
}

/// Whether a body stands in the world and turns there.
bool is_hinged_to_the_world(const XmlElement& element) {
  return is_tag(element, "body") && is_tag(*element.Parent()->ToElement(), "worldbody") &&
         element.FirstChildElement("joint") != nullptr;
}

/// Told before MuJoCo stumbles over a keyframe that does not fit a robot without free joint.
void check_has_free_joint(const XmlFile& xml) {
  bool found = false;
  int hinged = 0;
  const XmlElement* first_body = nullptr;
  for_each_element(xml.root(), [&](const XmlElement& element) {
    // One with a slip in its name is told as that.
    found = found || slip_of(element.Name(), {"freejoint"}) == "freejoint" ||
            (is_tag(element, "joint") && attribute(element, "type") == "free");
    if (!first_body && is_tag(element, "body")) first_body = &element;
    hinged += is_hinged_to_the_world(element);
  });
  if (found) return;
  if (hinged > 1)
    throw xml.error(
        *first_body,
        fmt::format("no trunk: {} bodies hang at the world by joints of their own, as MuJoCo makes "
                    "it of a URDF, whose base it merges with the world; write a <body> with "
                    "<freejoint/>, <inertial> and the trunk's geoms around them, or start from the "
                    "URDF: legwright init ROBOT.urdf -o robot.xml",
                    hinged));
  if (!first_body)
    throw xml.error(xml.root(),
                    "holds no body; a robot is a <body> with a <freejoint/> in <worldbody>");
  int slides = 0, hinges = 0;
  for (const XmlElement* joint = first_body->FirstChildElement("joint"); joint != nullptr;
       joint = joint->NextSiblingElement("joint"))
    ++(attribute(*joint, "type") == "slide" ? slides : hinges);
  const bool floats = slides == 3 && hinges == 3;
  throw xml.error(*first_body,
                  fmt::format("no free root: the trunk of a walking robot moves freely; {}",
                              !floats ? "add <freejoint/> to it, as legwright init ROBOT.xml "
                                        "--write does where limbs move on it"
                              : attribute(*first_body, "name").empty()
                                  ? "give it a name; then legwright init ROBOT.xml -o NEW.xml "
                                    "puts a free joint in the place of its six"
                                  : "legwright init ROBOT.xml -o NEW.xml puts a free joint in the "
                                    "place of its six where their axes span space"));
}

/// Throws InputError at the first thing in an element with which no robot is read.
void check_element(const XmlFile& xml, const XmlElement& element) {
  if (is_listed(kGenerators, element.Name()))
    throw xml.error(element, "generated parts are not read; " + written_out_cure(xml.file));
  if (is_listed(kSoftBodies, element.Name()))
    throw xml.error(element, "soft bodies are not read; remove it");
  if (is_tag(element, "compiler") && attribute(element, "fusestatic") == "true")
    throw xml.error(element, "attribute fusestatic: hides bodies that parameters name; remove it");
  if (is_tag(element, "plugin") || is_tag(element, "extension"))
    throw xml.error(element,
                    "a robot with engine plugins is not read; use the elements of plain MJCF");
  check_texts(xml, element);
  check_sizes(xml, element);
  check_numbers(xml, element);
  check_axis(xml, element);
}

/// Where a body, joint or geom stands that may have no name; 0 where MuJoCo's are not the file's.
int line_in_tree(const XmlFile& xml, const mjModel& model, mjtObj type, int id) {
  try {
    const TreeElements tree = find_elements(xml, model);
    const auto& all = type == mjOBJ_BODY    ? tree.bodies
                      : type == mjOBJ_JOINT ? tree.joints
                                            : tree.geoms;
    const XmlElement* const element = all.at(static_cast<std::size_t>(id));
    return element ? element->GetLineNum() : 0;
  } catch (const InputError&) {
    return 0;
  }
}

}  // namespace

std::string with_decimal_points(const XmlFile& xml) {
  std::string out = xml.text;
  for_each_element(xml.root(), [&](const XmlElement& element) {
    for (const AttributeSpan& span : xml.tag(element).attributes) {
      std::string value = xml.text.substr(span.value_begin, span.value_end - span.value_begin);
      if (!holds_numbers(element, span.name) || parse_numbers(value)) continue;
      std::replace(value.begin(), value.end(), ',', '.');
      if (parse_numbers(value)) out.replace(span.value_begin, value.size(), value);
    }
  });
  return out;
}

void check_values(const XmlFile& xml) {
  for_each_element(xml.root(), [&](const XmlElement& element) {
    check_texts(xml, element);
    check_sizes(xml, element);
    check_numbers(xml, element);
  });
}

void check_text(const XmlFile& xml, Refusals& reasons) {
  if (!is_tag(xml.root(), "mujoco"))
    throw xml.error(xml.root(), "the root element of a robot is <mujoco>; is this an MJCF file?");
  bool is_readable = true;
  const auto collect = [&](const auto& check) {
    try {
      check();
    } catch (const InputError& fault) {
      reasons.add(fault);
      is_readable = false;
    }
  };
  for_each_element(xml.root(), [&](const XmlElement& element) {
    collect([&] { check_element(xml, element); });
  });
  const Refusals words = unknown_words(xml);
  for (const InputError& fault : words.all()) reasons.add(fault);
  is_readable = is_readable && words.empty();
  collect([&] { check_has_free_joint(xml); });
  if (!is_readable) reasons.throw_if_any();
}

InputError error_at(const XmlFile& xml, const mjModel& model, mjtObj type, int id,
                    const std::string& message) {
  const char* const tag = type == mjOBJ_BODY ? "body" : type == mjOBJ_JOINT ? "joint" : "geom";
  const std::string name = name_of(model, type, id);
  const XmlElement* element = nullptr;
  if (!name.empty()) element = find_named(xml.root(), tag, name);
  if (!element && !name.empty() && type == mjOBJ_JOINT)
    element = find_named(xml.root(), "freejoint", name);
  if (element) return xml.error(*element, message);
  if (name.empty() && type != mjOBJ_BODY) {
    const int body = type == mjOBJ_JOINT ? model.jnt_bodyid[id] : model.geom_bodyid[id];
    const InputError at_body =
        error_at(xml, model, mjOBJ_BODY, body, fmt::format("its unnamed {}: {}", tag, message));
    const int line = line_in_tree(xml, model, type, id);
    return InputError(at_body.file(), line > 0 ? line : at_body.line(), at_body.where(),
                      at_body.message());
  }
  return InputError(xml.file.string(), line_in_tree(xml, model, type, id),
                    name.empty() ? fmt::format("unnamed {}", tag) : tag + (" '" + name + "'"),
                    message);
}

}  // namespace legwright
