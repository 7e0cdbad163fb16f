// SPDX-License-Identifier: Apache-2.0
#include "tests/mjcf/robots/mutate_robot.hpp"

#include <fmt/format.h>
#include <tinyxml2.h>

#include <iterator>
#include <string_view>
#include <utility>
#include <vector>

#include "mjcf/text/numbers.hpp"

namespace legwright::test {
namespace {

using tinyxml2::XMLAttribute;
using tinyxml2::XMLElement;

const char* const kJunk[] = {"",     "nan", "1e999", "0x10", "1,5",    "abc",    "1 2",
                             "-",    " 1 ", "1 1 1", "true", "0 0 0",  "1e-300", "0.1 0.1 0.1 0.1",
                             "auto", "0 1", "2 1",   "1e7",  "-0.001", "3.0.1"};
const char* const kNames[] = {"../x", "a b",      "<b>&\"", "\xC3\xBC\xC3\xB1",
                              "%s%n", "a'b",      "floor",  "gait",
                              "home", "world",    "main",   "",
                              "a|b",  "~knee",    "0.5*a",  "legwright/thing",
                              "1",    "tab\there"};
const double kFactors[] = {0.5, 0.9, 0.99, 1.001, 1.1, 2.0, -1.0, 10.0};

/// Attributes that people add, most of them allowed somewhere.
struct Extra {
  const char *tag, *name, *value;
};
const Extra kExtras[] = {{"joint", "ref", "0.1"},
                         {"joint", "pos", "0 0 0.01"},
                         {"joint", "pos", "0.01 0 0"},
                         {"joint", "range", "-1 1"},
                         {"joint", "springref", "0.2"},
                         {"joint", "damping", "0.5"},
                         {"joint", "axis", "1 1 1"},
                         {"joint", "axis", "0 0 3"},
                         {"joint", "type", "slide"},
                         {"joint", "actuatorfrcrange", "-2 3"},
                         {"body", "euler", "10 0 20"},
                         {"body", "quat", "1 0.1 0.2 0"},
                         {"body", "axisangle", "0 1 0 0.3"},
                         {"body", "gravcomp", "0.5"},
                         {"body", "childclass", "foot"},
                         {"body", "pos", "0.01 -0.02 0.03"},
                         {"geom", "density", "500"},
                         {"geom", "mass", "0.1"},
                         {"geom", "type", "capsule"},
                         {"geom", "type", "box"},
                         {"geom", "type", "sphere"},
                         {"geom", "type", "ellipsoid"},
                         {"geom", "fromto", "0 0 0 0 0 -0.1"},
                         {"geom", "fromto", "0 0 0 0.05 0 -0.1"},
                         {"geom", "size", "0.01 0.02 0.03"},
                         {"geom", "contype", "1"},
                         {"geom", "pos", "0 0.01 0"},
                         {"geom", "euler", "0.3 0 0"},
                         {"geom", "class", "servo"},
                         {"geom", "priority", "3"},
                         {"inertial", "quat", "1 0.1 0 0"},
                         {"inertial", "euler", "0.1 0 0"},
                         {"inertial", "fullinertia", "0.01 0.01 0.01 0 0 0"},
                         {"inertial", "mass", "1e-6"},
                         {"inertial", "pos", "0.01 0.02 0.03"},
                         {"compiler", "angle", "degree"},
                         {"compiler", "eulerseq", "zyx"},
                         {"compiler", "inertiafromgeom", "true"},
                         {"compiler", "boundmass", "0.01"},
                         {"compiler", "settotalmass", "3"},
                         {"compiler", "autolimits", "false"},
                         {"compiler", "fusestatic", "true"},
                         {"compiler", "balanceinertia", "true"},
                         {"position", "gear", "-2"},
                         {"position", "kp", "0"},
                         {"position", "forcerange", "-1 2"},
                         {"position", "ctrlrange", "-1 1"},
                         {"key", "qpos", "0 0 1"},
                         {"key", "ctrl", "0"},
                         {"key", "time", "1"},
                         {"site", "pos", "0 0 0.02"},
                         {"site", "type", "box"},
                         {"site", "size", "0.01 0.02 0.03"},
                         {"freejoint", "align", "true"}};

class Mutator {
 public:
  Mutator(XMLElement& root, std::mt19937& random) : random_(random) { collect(root); }

  void run() {
    switch (below(12)) {
      case 0:
        return junk();
      case 1:
      case 2:
        return scale(false);
      case 3:
        return scale(true);
      case 4:
        return rename(below(3) > 0);
      case 5:
        return remove_attribute();
      case 6:
        return remove_element();
      case 7:
        return duplicate();
      case 8:
        return swap();
      case 9:
      case 10:
        return add();
      default:
        return declare();
    }
  }

 private:
  std::size_t below(std::size_t n) { return n > 0 ? random_() % n : 0; }
  template <class Range>
  auto& one_of(Range& range) {
    return range[below(std::size(range))];
  }

  void collect(XMLElement& element) {
    elements_.push_back(&element);
    for (XMLElement* child = element.FirstChildElement(); child;
         child = child->NextSiblingElement())
      collect(*child);
  }

  /// An attribute of some element, numbers only where wanted; none where luck fails.
  std::pair<XMLElement*, std::string> attribute(bool of_numbers) {
    for (int trial = 0; trial < 100; ++trial) {
      XMLElement* element = one_of(elements_);
      std::vector<const XMLAttribute*> own;
      for (const XMLAttribute* a = element->FirstAttribute(); a; a = a->Next()) {
        const auto numbers = parse_numbers(a->Value());
        if (!of_numbers || (numbers && !numbers->empty())) own.push_back(a);
      }
      if (!own.empty()) return {element, one_of(own)->Name()};
    }
    return {nullptr, ""};
  }

  /// Not the root: nothing would be left.
  XMLElement* element() {
    return elements_.size() > 1 ? elements_[1 + below(elements_.size() - 1)] : nullptr;
  }

  void junk() {
    const auto [element, name] = attribute(below(3) > 0);
    if (element) element->SetAttribute(name.c_str(), one_of(kJunk));
  }

  void scale(bool all) {
    const auto [element, name] = attribute(true);
    if (!element) return;
    auto numbers = *parse_numbers(element->Attribute(name.c_str()));
    const double factor = one_of(kFactors);
    const std::size_t only = below(numbers.size());
    std::string text;
    for (std::size_t k = 0; k < numbers.size(); ++k)
      text.append(k > 0 ? " " : "")
          .append(format_number(all || k == only ? factor * numbers[k] : numbers[k]));
    element->SetAttribute(name.c_str(), text.c_str());
  }

  /// A name, everywhere it stands (also in bindings) or where it is given only.
  void rename(bool everywhere) {
    for (int trial = 0; trial < 100; ++trial) {
      XMLElement* named = one_of(elements_);
      const char* const value = named->Attribute("name");
      if (!value || !*value) continue;
      const std::string old = value;
      std::string name = one_of(kNames);
      if (below(10) == 0) name = std::string(300, 'x');
      if (!everywhere) return named->SetAttribute("name", name.c_str());
      for (XMLElement* element : elements_)
        for (const XMLAttribute* a = element->FirstAttribute(); a; a = a->Next()) {
          std::string text = a->Value();
          for (std::size_t at = text.find(old); at != std::string::npos;
               at = text.find(old, at + name.size()))
            text.replace(at, old.size(), name);
          const_cast<XMLAttribute*>(a)->SetAttribute(text.c_str());
        }
      return;
    }
  }

  void remove_attribute() {
    const auto [element, name] = attribute(false);
    if (element) element->DeleteAttribute(name.c_str());
  }

  void remove_element() {
    if (XMLElement* gone = element()) gone->Parent()->DeleteChild(gone);
  }

  void duplicate() {
    XMLElement* twin = element();
    if (!twin) return;
    tinyxml2::XMLNode* copy = twin->DeepClone(twin->GetDocument());
    twin->Parent()->InsertAfterChild(twin, copy);
    if (copy->ToElement()->Attribute("name") && below(2) == 0)
      copy->ToElement()->DeleteAttribute("name");
  }

  /// Behind its next sibling, or below some other element of its parent's kind.
  void swap() {
    XMLElement* moved = element();
    if (!moved) return;
    XMLElement* const next = moved->NextSiblingElement();
    if (next && below(2) == 0) {
      moved->Parent()->InsertAfterChild(next, moved);
      return;
    }
    XMLElement* const parent = moved->Parent()->ToElement();
    XMLElement* const other = one_of(elements_);
    if (!parent || std::string_view(parent->Name()) != other->Name()) return;
    for (const tinyxml2::XMLNode* above = other; above; above = above->Parent())
      if (above == moved) return;  // it would hang below itself
    other->InsertEndChild(moved);
  }

  void add() {
    for (int trial = 0; trial < 100; ++trial) {
      const Extra& extra = one_of(kExtras);
      XMLElement* at = one_of(elements_);
      if (std::string_view(at->Name()) != extra.tag) continue;
      at->SetAttribute(extra.name, extra.value);
      return;
    }
  }

  /// Another declaration: its bounds, its unit, or a word of its binding.
  void declare() {
    std::vector<XMLElement*> texts, numerics;
    for (XMLElement* element : elements_) {
      const char* const name = element->Attribute("name");
      if (!name || std::string_view(name).substr(0, 10) != "legwright/" ||
          !element->Attribute("data"))
        continue;
      (std::string_view(element->Name()) == "text" ? texts : numerics).push_back(element);
    }
    if (texts.empty() || numerics.empty()) return;
    if (below(2) == 0) {
      XMLElement* numeric = one_of(numerics);
      auto numbers = parse_numbers(numeric->Attribute("data"));
      if (!numbers || numbers->size() != 3) return;
      if (below(3) == 0)
        (*numbers)[1] = (*numbers)[2] = (*numbers)[0];  // frozen
      else
        (*numbers)[below(3)] *= one_of(kFactors);
      numeric->SetAttribute("data",
                            format_numbers(Eigen::VectorXd::Map(numbers->data(), 3)).c_str());
      return;
    }
    XMLElement* text = one_of(texts);
    std::vector<std::string> words;
    for (const std::string_view word : split_words(text->Attribute("data")))
      words.emplace_back(word);
    if (words.size() < 6) return;
    std::string& word = words[2 + below(4)];
    const char* const kWords[] = {"link:", "x:", "y:", "z:", "stretch", "axis", "place", "|", "m"};
    switch (below(5)) {
      case 0:
        word = one_of(kWords);
        break;
      case 1:
        word = fmt::format("{}{}", below(2) == 0 ? "~" : "^", word);
        break;
      case 2:
        word = fmt::format("{}{}", "0.5*", word);
        break;
      case 3:
        word = fmt::format("{}{}", "-2*", word);
        break;
      default: {
        const char* const name = one_of(elements_)->Attribute("name");
        word.append(" ").append(name ? name : "trunk");
      }
    }
    std::string data;
    for (const std::string& w : words) data.append(data.empty() ? "" : " ").append(w);
    text->SetAttribute("data", data.c_str());
  }

  std::mt19937& random_;
  std::vector<XMLElement*> elements_;
};

}  // namespace

std::string mutated_robot(const std::string& xml, std::mt19937& random) {
  tinyxml2::XMLDocument dom;
  if (dom.Parse(xml.c_str(), xml.size()) != tinyxml2::XML_SUCCESS) return xml;
  const auto changes = 1 + random() % 3;
  for (unsigned k = 0; k < changes; ++k) Mutator(*dom.RootElement(), random).run();
  tinyxml2::XMLPrinter printer;
  dom.Print(&printer);
  return printer.CStr();
}

}  // namespace legwright::test
