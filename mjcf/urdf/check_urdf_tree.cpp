// SPDX-License-Identifier: Apache-2.0
#include "mjcf/urdf/check_urdf_tree.hpp"

#include <fmt/format.h>

#include <map>
#include <set>
#include <string>
#include <vector>

#include "mjcf/text/listed.hpp"
#include "mjcf/text/nearest_word.hpp"
#include "mjcf/urdf/check_urdf.hpp"

namespace legwright {
namespace {

class UrdfTreeChecker {
 public:
  UrdfTreeChecker(const XmlFile& urdf, Refusals& faults) : urdf_(urdf), faults_(faults) {}

  void check_all() {
    for (const XmlElement* each = first("link"); each != nullptr; each = next(*each, "link"))
      add_link(*each);
    for (const XmlElement* each = first("joint"); each != nullptr; each = next(*each, "joint")) {
      joints_.emplace_back(attribute(*each, "name"));
      for (const char* end : {"parent", "child"}) named_.insert(link_at(*each, end));
    }
    for (const XmlElement* each = first("joint"); each != nullptr; each = next(*each, "joint")) {
      check_ends(*each);
      check_mimic(*each);
    }
    refuse_circles();
  }

 private:
  const XmlElement* first(const char* tag) const { return urdf_.root().FirstChildElement(tag); }
  static const XmlElement* next(const XmlElement& element, const char* tag) {
    return element.NextSiblingElement(tag);
  }

  /// Name of the link at an end of a joint; empty where none is given.
  static std::string link_at(const XmlElement& joint, const char* end) {
    const XmlElement* const element = joint.FirstChildElement(end);
    return element ? std::string(attribute(*element, "link")) : "";
  }

  void add_link(const XmlElement& link) {
    if (!has_attribute(link, "name")) return;  // check_urdf() tells it
    const auto [known, added] = links_.emplace(attribute(link, "name"), &link);
    if (!added)
      faults_.add(urdf_fault(
          urdf_, link, "name", link,
          fmt::format("attribute name: the link in line {} has it, too; give each its own",
                      known->second->GetLineNum())));
  }

  void check_ends(const XmlElement& joint) {
    for (const char* end : {"parent", "child"}) {
      const XmlElement* const element = joint.FirstChildElement(end);
      if (element == nullptr || !has_attribute(*element, "link")) continue;
      const std::string name = link_at(joint, end);
      if (links_.count(name) == 0)
        faults_.add(urdf_fault(urdf_, *element, "link", joint, unknown_link(end, name)));
    }
    const std::string parent = link_at(joint, "parent"), child = link_at(joint, "child");
    if (links_.count(parent) == 0 || links_.count(child) == 0) return;
    const auto [above, added] = joint_above_.emplace(child, &joint);
    if (!added)
      faults_.add(urdf_fault(
          urdf_, *joint.FirstChildElement("child"), "link", joint,
          fmt::format("child '{}' hangs on joint '{}' of line {} already; a link hangs on one "
                      "joint, mend the name or remove one of the joints",
                      child, attribute(*above->second, "name"), above->second->GetLineNum())));
  }

  std::string unknown_link(const char* end, const std::string& name) {
    std::vector<std::string> unused, all;
    for (const auto& [link, element] : links_) {
      all.push_back(link);
      if (named_.count(link) == 0) unused.push_back(link);
    }
    std::string hint = "; mend the name, or write the link";
    if (const std::string guess = guess_among(unused, name); !guess.empty())
      hint = fmt::format("; did you mean '{}', which no joint names?", guess);
    else if (const std::string other = guess_among(all, name); !other.empty())
      hint = fmt::format("; did you mean '{}'?", other);
    return fmt::format("{} '{}' is no <link> of this file{}", end, name.substr(0, 200), hint);
  }

  std::string guess_among(const std::vector<std::string>& names, const std::string& name) {
    constexpr int kMostGuesses = 100;       // each looks at all names
    constexpr std::size_t kLongName = 100;  // [bytes]
    if (name.size() > kLongName || ++guesses_ > kMostGuesses) return "";
    return nearest(name, names);
  }

  void check_mimic(const XmlElement& joint) {
    const XmlElement* const mimic = joint.FirstChildElement("mimic");
    if (mimic == nullptr || attribute(joint, "type") == "fixed") return;
    const std::string name(attribute(*mimic, "joint"));
    for (const std::string& known : joints_)
      if (known == name) return;
    if (++guesses_ > 100) return;
    if (const std::string guess = slip_of(name, joints_); !guess.empty())
      faults_.add(urdf_fault(urdf_, *mimic, "joint", joint,
                             fmt::format("attribute joint of <mimic>: '{}' is no joint of this "
                                         "file; did you mean '{}'?",
                                         name, guess)));
  }

  /// Each link that hangs on itself in the end, told once for its circle.
  void refuse_circles() {
    std::set<std::string> seen;
    for (const auto& start : links_) {
      std::vector<std::string> way;
      std::set<std::string> on_way;
      std::string link = start.first;
      while (seen.insert(link).second) {
        way.push_back(link);
        on_way.insert(link);
        const auto above = joint_above_.find(link);
        if (above == joint_above_.end()) break;
        link = link_at(*above->second, "parent");
        if (on_way.count(link) > 0) refuse_circle(link, way);
      }
    }
  }

  void refuse_circle(const std::string& link, const std::vector<std::string>& way) {
    const XmlElement& joint = *joint_above_.at(link);
    std::vector<std::string> circle{link};
    for (auto each = way.rbegin(); *each != link; ++each) circle.push_back(*each);
    circle.push_back(link);
    faults_.add(urdf_fault(urdf_, *joint.FirstChildElement("parent"), "link", joint,
                           fmt::format("its links hang on each other in a circle ({}); mend "
                                       "<parent> or <child> of one of their joints",
                                       listed(circle, 6, " > "))));
  }

  const XmlFile& urdf_;
  Refusals& faults_;
  std::map<std::string, const XmlElement*> links_;  // by name
  std::set<std::string> named_;                     // by joints
  std::vector<std::string> joints_;
  std::map<std::string, const XmlElement*> joint_above_;  // by the name of the link below
  int guesses_ = 0;
};

}  // namespace

void check_urdf_tree(const XmlFile& urdf, Refusals& faults) {
  UrdfTreeChecker(urdf, faults).check_all();
}

}  // namespace legwright
