// SPDX-License-Identifier: Apache-2.0
#include "mjcf/read/bindings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <map>
#include <optional>
#include <set>

#include "mjcf/read/linear_actuators.hpp"
#include "mjcf/read/mirror.hpp"
#include "mjcf/read/stretch.hpp"
#include "mjcf/text/compile.hpp"
#include "mjcf/text/numbers.hpp"
#include "mjcf/text/refusals.hpp"

namespace legwright {
namespace {

constexpr const char* kShape =
    "expected \"UNIT | BINDING | SENTENCE\", like "
    "\"m | stretch link: left_shank right_shank | Length of the shanks.\"";

/// Declared names in order of their numeric elements.
struct Pairs {
  std::vector<std::string> order;
  std::map<std::string, DeclarationElements> elements;
};

void check_name(const XmlFile& xml, const XmlElement& element, const std::string& name) {
  const bool plain = !name.empty() && name.size() <= 80 &&
                     std::all_of(name.begin(), name.end(), [](unsigned char c) {
                       return std::isalnum(c) || c == '_' || c == '-' || c == '.';
                     });
  if (!plain)
    throw xml.error(
        element,
        "a parameter's name is made of letters, digits, _ - and . only (at most 80); rename it");
}

Pairs collect_pairs(const XmlFile& xml) {
  Pairs pairs;
  for_each_element(xml.root(), [&](const XmlElement& element) {
    const bool is_numeric = is_tag(element, "numeric");
    if (!is_numeric && !is_tag(element, "text")) return;
    const std::string_view full = attribute(element, "name");
    if (full.substr(0, kDeclarationPrefix.size()) != kDeclarationPrefix) return;
    const std::string name(full.substr(kDeclarationPrefix.size()));
    check_name(xml, element, name);
    DeclarationElements& both = pairs.elements[name];
    const XmlElement*& own = is_numeric ? both.numeric : both.text;
    if (own)
      throw xml.error(element, fmt::format("is declared twice, first in line {}; remove one",
                                           own->GetLineNum()));
    own = &element;
    if (is_numeric) pairs.order.push_back(name);
  });
  return pairs;
}

InputError without_numeric(const XmlFile& xml, const XmlElement& text) {
  return xml.error(text,
                   "has no <numeric> of the same name; add one with data=\"value lower upper\"");
}

InputError without_text(const XmlFile& xml, const XmlElement& numeric) {
  return xml.error(numeric, fmt::format("has no <text> of the same name; {}", kShape));
}

void read_values(const XmlFile& xml, const XmlElement& numeric, DesignParameter& parameter) {
  const std::string_view data = attribute(numeric, "data");
  const auto values = parse_numbers(data);
  if (!values) throw xml.error(numeric, "attribute data: " + explain_bad_number(data));
  if (values->size() != 3)
    throw xml.error(
        numeric,
        fmt::format("attribute data: {} numbers; expected three: value, lower and upper bound",
                    values->size()));
  parameter.initial = (*values)[0];
  parameter.lower = (*values)[1];
  parameter.upper = (*values)[2];
  if (parameter.lower > parameter.upper)
    throw xml.error(numeric, fmt::format("bounds are crossed: lower {} > upper {}; exchange them",
                                         parameter.lower, parameter.upper));
  if (parameter.initial < parameter.lower || parameter.initial > parameter.upper)
    throw xml.error(
        numeric,
        fmt::format("the value {} lies outside of its bounds {} to {}; widen the bounds or change "
                    "the robot",
                    parameter.initial, parameter.lower, parameter.upper));
}

/// One word behind the colon: [FACTOR*][~]NAME or [FACTOR*][^]NAME.
struct TargetWord {
  std::string text, name;
  std::optional<Across> mirror;
  double factor = 1.0;
};

/// UNIT | BINDING | SENTENCE taken apart.
struct DeclaredBinding {
  std::string verb, direction;
  std::vector<TargetWord> targets;
};

TargetWord read_target(const XmlFile& xml, const XmlElement& text, std::string_view word) {
  TargetWord out;
  out.text = word;
  if (const std::size_t star = word.find('*'); star != std::string_view::npos) {
    const auto factor = parse_number(word.substr(0, star));
    if (!factor || *factor == 0.0 || std::abs(*factor) > 1e3)
      throw xml.error(text, fmt::format("'{}': expected a factor before the *, not zero and at "
                                        "most 1000, like 0.8*left_thigh",
                                        word));
    out.factor = *factor;
    word.remove_prefix(star + 1);
  }
  if (!word.empty() && word[0] == '~') out.mirror = Across::y;
  if (!word.empty() && word[0] == '^') out.mirror = Across::x;
  if (out.mirror) word.remove_prefix(1);
  if (word.empty())
    throw xml.error(text, fmt::format("'{}' holds no name; write the name behind it", out.text));
  out.name = word;
  return out;
}

/// What a <text> says, as MuJoCo reads it: its attribute, or else its CDATA section, where MuJoCo
/// itself writes whatever holds an apostrophe or markup.
std::string_view said_by(const XmlElement& text) {
  if (has_attribute(text, "data")) return attribute(text, "data");
  for (const tinyxml2::XMLNode* node = text.FirstChild(); node; node = node->NextSibling())
    if (const tinyxml2::XMLText* inside = node->ToText(); inside && inside->CData())
      return inside->Value();
  return {};
}

DeclaredBinding read_text(const XmlFile& xml, const XmlElement& text, DesignParameter& parameter) {
  const std::string_view data = said_by(text);
  const std::size_t first = data.find('|');
  const std::size_t second = first == std::string_view::npos ? first : data.find('|', first + 1);
  if (second == std::string_view::npos)
    throw xml.error(text, fmt::format("attribute data: {}", kShape));
  parameter.unit = trimmed(data.substr(0, first));
  parameter.sentence = trimmed(data.substr(second + 1));
  if (parameter.unit != "m" && parameter.unit != "rad")
    throw xml.error(text, fmt::format("unknown unit '{}'; write m for a length or rad for an angle",
                                      parameter.unit));
  if (parameter.sentence.empty())
    throw xml.error(text, fmt::format("says nothing for people; {}", kShape));
  const std::string_view binding = trimmed(data.substr(first + 1, second - first - 1));
  const std::size_t colon = binding.find(':');
  const auto head = split_words(binding.substr(0, colon));
  if (colon == std::string_view::npos || head.size() != 2)
    throw xml.error(
        text, fmt::format("binding '{}' is not understood; write 'stretch DIRECTION: BODY …', "
                          "'axis DIRECTION: JOINT …' or 'place DIRECTION: SITE …'",
                          binding));
  DeclaredBinding out{std::string(head[0]), std::string(head[1]), {}};
  const bool is_stretch = out.verb == "stretch", is_axis = out.verb == "axis";
  if (!is_stretch && !is_axis && out.verb != "place")
    throw xml.error(
        text,
        fmt::format("binding '{}' is unknown; there are 'stretch', 'axis' and 'place'", out.verb));
  const bool is_axis_word = out.direction == "x" || out.direction == "y" || out.direction == "z";
  if (!is_axis_word && !(is_stretch && out.direction == "link"))
    throw xml.error(text, fmt::format("direction '{}' is unknown; write {}", out.direction,
                                      is_stretch ? "link, x, y or z" : "x, y or z"));
  parameter.kind = is_stretch ? ParameterKind::length
                   : is_axis  ? ParameterKind::axis_angle
                              : ParameterKind::position;
  if ((parameter.unit == "rad") != is_axis)
    throw xml.error(
        text, fmt::format("unit '{}' does not fit '{}'; a stretch and a place are in m, an axis in "
                          "rad",
                          parameter.unit, out.verb));
  for (const std::string_view word : split_words(binding.substr(colon + 1)))
    out.targets.push_back(read_target(xml, text, word));
  if (out.targets.empty())
    throw xml.error(text, "names no body, joint or site; write their names behind the colon");
  return out;
}

/// The kind of element that a parameter's binding names.
const char* bound_kind(const DesignParameter& parameter) {
  return parameter.kind == ParameterKind::length       ? "body"
         : parameter.kind == ParameterKind::axis_angle ? "joint"
                                                       : "site";
}

InputError not_in_the_model(const XmlFile& xml, const XmlElement& text, const char* kind,
                            const std::string& name) {
  return xml.error(
      text,
      fmt::format("names the {} '{}', which is not in the model; correct the name", kind, name));
}

Binding::Target resolve_stretch(const XmlFile& xml, const mjModel& model,
                                const DeclarationElements& at, const DeclaredBinding& declared,
                                const DesignParameter& parameter, const TargetWord& word,
                                const Structure& structure) {
  if (word.mirror)
    throw xml.error(*at.text,
                    fmt::format("'{}': {} mirrors axes and places; a stretch needs none, remove it",
                                word.text, *word.mirror == Across::y ? '~' : '^'));
  if (word.factor < 0.0)
    throw xml.error(
        *at.text, fmt::format("'{}': a length stays positive; write a positive factor", word.text));
  const int body = mj_name2id(&model, mjOBJ_BODY, word.name.c_str());
  const XmlElement* element = find_named(xml.root(), "body", word.name);
  if (body <= 0 || !element) throw not_in_the_model(xml, *at.text, "body", word.name);
  const StretchMeasure measure =
      measure_stretch(xml, model, *at.text, body, declared.direction, structure);
  if (std::abs(measure.length - word.factor * parameter.initial) >
      1e-6 * std::min(1.0, word.factor))
    throw xml.error(
        *at.numeric,
        fmt::format("declares {} m, but body '{}' measures {} m along {}; write that number{}, or "
                    "remove the legwright/… elements and let `legwright init ROBOT --write` "
                    "declare them anew",
                    word.factor * parameter.initial, word.name, measure.length, declared.direction,
                    word.factor == 1.0 ? "" : fmt::format(" divided by {}", word.factor)));
  if (parameter.lower <= 0.0)
    throw xml.error(
        *at.numeric,
        fmt::format("a length must stay positive; the lower bound {} is not", parameter.lower));
  check_stretchable(xml, model, *element);
  return {word.name, {}, word.factor, at.text->GetLineNum(), measure.direction, measure.still};
}

/// The direction that a word means for a joint: mirrored from that target without a mark whose
/// mirror image the joint is.
Eigen::Vector3d turn_of(const mjModel& model, const Structure& structure,
                        const DeclaredBinding& declared, const TargetWord& word, int joint) {
  Eigen::Vector3d n = Eigen::Vector3d::Unit(declared.direction[0] - 'x');
  if (!word.mirror) return n;
  std::vector<int> others;
  for (const TargetWord& other : declared.targets)
    if (!other.mirror) others.push_back(mj_name2id(&model, mjOBJ_JOINT, other.name.c_str()));
  others.erase(std::remove(others.begin(), others.end(), -1), others.end());
  const int image = mirror_image(model, structure.trunk, joint, *word.mirror, others);
  if (image < 0) return turn_in_mirror(n, *word.mirror);
  return mirrored_turn(model, structure.trunk, image, joint, *word.mirror, n);
}

Binding::Target resolve_axis(const XmlFile& xml, const mjModel& model,
                             const DeclarationElements& at, const DeclaredBinding& declared,
                             const TargetWord& word, const Structure& structure) {
  const int joint = mj_name2id(&model, mjOBJ_JOINT, word.name.c_str());
  const XmlElement* element = find_named(xml.root(), "joint", word.name);
  if (joint < 0 || !element) throw not_in_the_model(xml, *at.text, "joint", word.name);
  if (model.jnt_type[joint] != mjJNT_HINGE)
    throw xml.error(
        *at.text, fmt::format("joint '{}' is no hinge, so its axis cannot be turned; name a hinge",
                              word.name));
  for (const FrozenJoint& frozen : structure.frozen)
    if (frozen.joint == joint)
      throw xml.error(*at.text, fmt::format("joint '{}' is held in its home pose ({}), so its axis "
                                            "is no part of the plan; name a joint of a leg",
                                            word.name, frozen.why));
  if (model.qpos0[model.jnt_qposadr[joint]] != 0.0)
    throw xml.error(*element,
                    "attribute ref: a joint whose axis is designed has the angle zero where the "
                    "file draws the robot; remove ref");
  if (!is_tag(*element->Parent()->ToElement(), "body"))
    throw xml.error(
        *element, "a joint whose axis is designed must stand directly in its body, not in a frame");
  return {word.name, word.mirror, word.factor, at.text->GetLineNum(),
          turn_of(model, structure, declared, word, joint)};
}

/// The site is an end of a linear actuator and says its place itself.
Binding::Target resolve_place(const XmlFile& xml, const mjModel& model,
                              const DeclarationElements& at, const DeclaredBinding& declared,
                              const DesignParameter& parameter, const TargetWord& word) {
  const int site = mj_name2id(&model, mjOBJ_SITE, word.name.c_str());
  const XmlElement* element = find_named(xml.root(), "site", word.name);
  if (site < 0 || !element) throw not_in_the_model(xml, *at.text, "site", word.name);
  if (!is_tag(*element->Parent()->ToElement(), "body") || !has_attribute(*element, "pos") ||
      inherited_attribute(xml, *element, "fromto"))
    throw xml.error(*element,
                    "a site that is placed stands directly in its body and has a pos of its own, "
                    "not a fromto; write it so");
  if (!is_tendon_end(model, site))
    throw xml.error(*at.text, fmt::format("site '{}' is no end of a tendon, so placing it changes "
                                          "nothing; name the site of a linear actuator",
                                          word.name));
  const int axis = declared.direction[0] - 'x';
  const bool turned = word.mirror && static_cast<int>(*word.mirror) == axis;
  const double factor = (turned ? -1.0 : 1.0) * word.factor;
  const double found = model.site_pos[3 * site + axis];
  if (std::abs(found - factor * parameter.initial) > 1e-6)
    throw xml.error(*at.numeric,
                    fmt::format("declares {} m, but site '{}' is at {} = {} m; write numbers that "
                                "agree",
                                factor * parameter.initial, word.name, declared.direction, found));
  return {word.name, word.mirror, factor, at.text->GetLineNum(), Eigen::Vector3d::Unit(axis)};
}

Binding resolve(const XmlFile& xml, const mjModel& model, const DeclarationElements& at,
                const DeclaredBinding& declared, const DesignParameter& parameter,
                const Structure& structure) {
  Binding binding;
  std::set<std::string> seen;
  for (const TargetWord& word : declared.targets) {
    Binding::Target target =
        parameter.kind == ParameterKind::length
            ? resolve_stretch(xml, model, at, declared, parameter, word, structure)
        : parameter.kind == ParameterKind::axis_angle
            ? resolve_axis(xml, model, at, declared, word, structure)
            : resolve_place(xml, model, at, declared, parameter, word);
    if (!seen.insert(target.name).second)
      throw xml.error(*at.text, fmt::format("names '{}' twice; name it once", target.name));
    binding.targets.push_back(std::move(target));
  }
  const Binding::Target& front = binding.targets.front();
  binding.direction = parameter.kind == ParameterKind::axis_angle
                          ? Eigen::Vector3d::Unit(declared.direction[0] - 'x').eval()
                          : front.direction;
  return binding;
}

void add_declared(const XmlFile& xml, const mjModel& model, const std::string& name,
                  const DeclarationElements& at, const Structure& structure, Declarations& out) {
  if (!at.text) throw without_text(xml, *at.numeric);
  DesignParameter parameter;
  parameter.name = name;
  read_values(xml, *at.numeric, parameter);
  const DeclaredBinding declared = read_text(xml, *at.text, parameter);
  Binding binding = resolve(xml, model, at, declared, parameter, structure);
  parameter.tied_count = static_cast<int>(binding.targets.size());
  out.space.parameters.push_back(std::move(parameter));
  out.bindings.push_back(std::move(binding));
}

}  // namespace

void check_declarations(const XmlFile& xml, Refusals& reasons) {
  Pairs pairs;
  if (!reasons.collect([&] { pairs = collect_pairs(xml); })) return;
  for (const auto& [name, both] : pairs.elements)
    reasons.collect([&xml, &both = both] {
      if (!both.numeric) throw without_numeric(xml, *both.text);
      if (!both.text) throw without_text(xml, *both.numeric);
      DesignParameter parameter;
      read_values(xml, *both.numeric, parameter);
      for (const TargetWord& word : read_text(xml, *both.text, parameter).targets)
        if (const char* const kind = bound_kind(parameter);
            !find_named(xml.root(), kind, word.name))
          throw not_in_the_model(xml, *both.text, kind, word.name);
    });
}

Declarations read_declarations(const XmlFile& xml, const mjModel& model, const Structure& structure,
                               Refusals& reasons) {
  Pairs pairs;
  if (!reasons.collect([&] { pairs = collect_pairs(xml); })) return {};
  for (const auto& [name, both] : pairs.elements)
    if (!both.numeric) reasons.add(without_numeric(xml, *both.text));
  constexpr std::size_t kMost = 500;
  if (pairs.order.size() > kMost) {
    reasons.add(xml.error(*pairs.elements.at(pairs.order[kMost]).numeric,
                          fmt::format("more than {} design parameters", kMost)));
    return {};
  }
  Declarations out;
  for (const std::string& name : pairs.order)
    reasons.collect(
        [&] { add_declared(xml, model, name, pairs.elements.at(name), structure, out); });
  return out;
}

DeclarationElements find_declaration(const XmlFile& xml, const std::string& name) {
  const std::string full = std::string(kDeclarationPrefix) + name;
  return {find_named(xml.root(), "numeric", full), find_named(xml.root(), "text", full)};
}

}  // namespace legwright
