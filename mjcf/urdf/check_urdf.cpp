// SPDX-License-Identifier: Apache-2.0
#include "mjcf/urdf/check_urdf.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <set>
#include <string>

#include "mjcf/text/listed.hpp"
#include "mjcf/text/nearest_word.hpp"
#include "mjcf/text/numbers.hpp"
#include "mjcf/urdf/urdf_schema.hpp"

namespace legwright {
namespace {

const std::vector<std::string>& joint_types() {
  static const std::vector<std::string> kTypes{"revolute", "continuous", "prismatic", "fixed",
                                               "floating", "planar",     "spherical"};
  return kTypes;
}

/// Words that number readers of others take: infinities, and numbers too small for a double.
bool is_endless(std::string_view word) {
  if (!word.empty() && (word[0] == '-' || word[0] == '+')) word.remove_prefix(1);
  for (const std::string_view known : {"inf", "infinity", "nan"})
    if (std::equal(word.begin(), word.end(), known.begin(), known.end(),
                   [](char a, char b) { return (a | 0x20) == b; }))
      return true;
  return false;
}

bool is_tiny(std::string_view word) {
  double value = 0.0;
  const char* const end = word.data() + word.size();
  const auto [stop, error] = std::from_chars(word.data(), end, value);
  return error == std::errc::result_out_of_range && stop == end &&
         (word.find("e-") != word.npos || word.find("E-") != word.npos);
}

/// What is wrong with the text of an attribute; empty: nothing.
std::string fault_of_numbers(const UrdfAttribute& expected, const char* text) {
  const std::vector<std::string_view> words = split_words(text);
  if (words.empty()) return "";  // as if it were not there
  bool negative = false;
  for (const std::string_view word : words) {
    const auto number = parse_number(word);
    const bool endless = expected.range == UrdfAttribute::Range::any && is_endless(word);
    if (!number && !endless && !is_tiny(word)) return explain_bad_number(word);
    negative = negative || number.value_or(1.0) < 0.0;
  }
  const auto wanted = static_cast<std::size_t>(expected.numbers);
  if (words.size() != wanted)
    return fmt::format("'{}' has {} number{}, expected {}{}", std::string_view(text).substr(0, 80),
                       words.size(), words.size() == 1 ? "" : "s", wanted,
                       wanted > 1 ? " with blanks between" : "");
  if (expected.range == UrdfAttribute::Range::length && negative)
    return fmt::format("'{}' is below 0; write the length in metres", text);
  return "";
}

class UrdfChecker {
 public:
  UrdfChecker(const XmlFile& urdf, Refusals& faults) : urdf_(urdf), faults_(faults) {}

  void check_all() {
    for (const XmlElement* each = urdf_.root().FirstChildElement(); each != nullptr;
         each = each->NextSiblingElement()) {
      if (!is_tag(*each, "link") && !is_tag(*each, "joint") && !is_tag(*each, "material")) continue;
      where_ = each;
      if (is_tag(*each, "joint")) check_joint(*each);
      check(*each, *urdf_element(each->Name()));
    }
  }

 private:
  void refuse(const XmlElement& element, const char* attribute, const std::string& message) {
    faults_.add(urdf_fault(urdf_, element, attribute, *where_, message));
  }

  void check(const XmlElement& element, const UrdfElement& expected) {
    check_attributes(element, expected);
    check_children(element, expected);
  }

  void check_attributes(const XmlElement& element, const UrdfElement& expected) {
    std::set<std::string> meant;
    for (const auto* at = element.FirstAttribute(); at != nullptr; at = at->Next()) {
      if (const UrdfAttribute* const known = expected.attribute(at->Name())) {
        if (known->numbers == 0) continue;
        const std::string fault = fault_of_numbers(*known, at->Value());
        if (!fault.empty())
          refuse(element, at->Name(),
                 fmt::format("attribute {} of <{}>: {}", at->Name(), element.Name(), fault));
        continue;
      }
      std::vector<std::string> names;
      for (const UrdfAttribute& each : expected.attributes)
        if (!has_attribute(element, each.name.c_str())) names.push_back(each.name);
      const std::string guess = guess_of(at->Name(), names, expected);
      if (guess.empty()) continue;
      meant.insert(guess);
      refuse(element, at->Name(),
             fmt::format("unknown attribute '{}' of <{}>; did you mean '{}'?", at->Name(),
                         element.Name(), guess));
    }
    for (const UrdfAttribute& each : expected.attributes) {
      const char* const text = element.Attribute(each.name.c_str());
      const bool there = text != nullptr && (each.numbers == 0 || !split_words(text).empty());
      if (there || each.need == UrdfAttribute::Need::optional || meant.count(each.name) > 0)
        continue;
      refuse(element, text ? each.name.c_str() : nullptr,
             fmt::format("<{0}> has {1} attribute {2}; write <{0} {2}=\"…\"", element.Name(),
                         text ? "nothing in its" : "no", each.name) +
                 (expected.children.empty() ? "/>" : ">"));
    }
  }

  void check_children(const XmlElement& element, const UrdfElement& expected) {
    std::set<std::string> meant;
    const bool shapes = expected.tag == "geometry";
    const std::string shape = shapes ? shape_in(element) : "";
    for (const XmlElement* child = element.FirstChildElement(); child != nullptr;
         child = child->NextSiblingElement()) {
      const std::string tag = child->Name();
      if (expected.has_child(tag)) {
        if ((shapes && tag != shape) || is_passed_over(element, tag)) continue;
        if (element.FirstChildElement(child->Name()) == child || may_repeat(tag))
          check(*child, *urdf_element(tag));
        else if (tag != "material")  // UrdfEdits keeps the first
          refuse(*child, nullptr,
                 fmt::format("a second <{}> in one <{}>, which has one; remove one of them", tag,
                             element.Name()));
        continue;
      }
      std::vector<std::string> tags;
      for (const std::string& each : expected.children)
        if (shape.empty() && (may_repeat(each) || !element.FirstChildElement(each.c_str())))
          tags.push_back(each);
      const std::string guess = guess_of(tag, tags, expected);
      if (guess.empty()) continue;
      meant.insert(guess);
      refuse(*child, nullptr,
             fmt::format("unknown element <{}> in <{}>; did you mean <{}>?", tag, element.Name(),
                         guess));
    }
    for (const std::string& tag : expected.required)
      if (element.FirstChildElement(tag.c_str()) == nullptr && meant.count(tag) == 0)
        refuse(element, nullptr,
               fmt::format("<{}> has no <{}>; add {}", element.Name(), tag,
                           sample_of(*urdf_element(tag))));
    if (shapes && shape.empty() && meant.empty()) refuse_shapeless(element);
    if (expected.tag == "material" && is_tag(*element.Parent()->ToElement(), "visual") &&
        !has_attribute(element, "name") && element.FirstChildElement("color") == nullptr)
      refuse(element, nullptr,
             "<material> has neither a name nor a <color>; add <color rgba=\"…\"/> or remove it");
  }

  static bool may_repeat(const std::string& tag) { return tag == "visual" || tag == "collision"; }

  /// Of a joint that does not move nothing but its place is read.
  static bool is_passed_over(const XmlElement& element, const std::string& tag) {
    return is_tag(element, "joint") && attribute(element, "type") == "fixed" &&
           (tag == "limit" || tag == "dynamics" || tag == "mimic");
  }

  static std::string shape_in(const XmlElement& geometry) {
    for (const std::string& tag : urdf_shape_tags())
      if (geometry.FirstChildElement(tag.c_str()) != nullptr) return tag;
    return "";
  }

  void refuse_shapeless(const XmlElement& geometry) {
    const XmlElement* const other = geometry.FirstChildElement();
    refuse(geometry, nullptr,
           fmt::format(
               "<geometry> has {}; write one of <{}>",
               other ? fmt::format("<{}>, of which no shape is made", other->Name()) : "no shape",
               listed(urdf_shape_tags(), 5, ">, <")));
  }

  /// The word that another one is a slip of. Prefixes are of extensions.
  static std::string guess_of(const std::string& word, const std::vector<std::string>& known,
                              const UrdfElement& expected) {
    const std::vector<std::string>& others = expected.others;
    if (word.find(':') != word.npos ||
        std::find(others.begin(), others.end(), word) != others.end())
      return "";
    return slip_of(word, known);
  }

  void check_joint(const XmlElement& joint) {
    const std::string type(attribute(joint, "type"));
    const std::vector<std::string>& types = joint_types();
    if (has_attribute(joint, "type") &&
        std::find(types.begin(), types.end(), type) == types.end()) {
      const std::string guess = type.size() > 40 ? "" : nearest(type, types);
      refuse(joint, "type",
             fmt::format("attribute type: '{}' is no type of joint; {}expected one of {}",
                         type.substr(0, 40),
                         guess.empty() ? "" : fmt::format("did you mean '{}'? ", guess),
                         listed(types, types.size())));
    }
    const XmlElement* const axis = joint.FirstChildElement("axis");
    const bool turns = type == "revolute" || type == "continuous" || type == "prismatic";
    if (axis == nullptr || !turns) return;
    const auto numbers = parse_numbers(attribute(*axis, "xyz"));
    if (numbers && numbers->size() == 3 &&
        std::all_of(numbers->begin(), numbers->end(), [](double x) { return x == 0.0; }))
      refuse(*axis, "xyz",
             fmt::format("attribute xyz of <axis>: '{}' has no direction; write the one in which "
                         "the joint turns or slides, as 0 1 0",
                         attribute(*axis, "xyz").substr(0, 80)));
  }

  const XmlFile& urdf_;
  Refusals& faults_;
  const XmlElement* where_ = nullptr;
};

}  // namespace

void check_urdf(const XmlFile& urdf, Refusals& faults) { UrdfChecker(urdf, faults).check_all(); }

InputError urdf_fault(const XmlFile& urdf, const XmlElement& element, const char* attribute,
                      const XmlElement& where, const std::string& message) {
  const TagSpan& tag = urdf.tag(element);
  int line = tag.line;
  for (const AttributeSpan& span : tag.attributes)
    if (attribute != nullptr && span.name == attribute)
      line += static_cast<int>(
          std::count(urdf.text.begin() + static_cast<std::ptrdiff_t>(tag.begin),
                     urdf.text.begin() + static_cast<std::ptrdiff_t>(span.value_begin), '\n'));
  std::string place = where.Name();
  if (has_attribute(where, "name"))
    place += fmt::format(" '{}'", legwright::attribute(where, "name").substr(0, 200));
  return InputError(urdf.file.string(), line, place, message);
}

}  // namespace legwright
