// SPDX-License-Identifier: Apache-2.0
#include "mjcf/text/mjcf_words.hpp"

#include <fmt/format.h>
#include <mujoco/mujoco.h>

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "mjcf/text/nearest_word.hpp"
#include "mjcf/text/numbers.hpp"

namespace legwright {
namespace {

constexpr std::size_t kMostTold = 50;  // words: those that follow are as a rule the same again

using Names = std::set<std::string, std::less<>>;
/// Attributes by the names of their elements, wherever these stand.
using MjcfSchema = std::map<std::string, Names, std::less<>>;

/// Elements that MuJoCo takes besides those that it prints, with any attributes.
constexpr std::array<std::string_view, 3> kBesides{"frame", "replicate", "include"};

/// As MuJoCo prints it: "   geom (*)   attribute attribute …" and further attributes on lines that
/// begin far to the right; "(world)body" for both. Empty where it prints something else.
MjcfSchema read_schema() {
  constexpr int kBytes = 1 << 18;
  constexpr std::size_t kFurther = 30;  // [columns]
  std::string text(kBytes, '\0');
  text.resize(static_cast<std::size_t>(
      std::clamp(mj_printSchema(nullptr, text.data(), kBytes, 0, 0), 0, kBytes)));
  MjcfSchema out;
  Names* attributes = nullptr;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    const std::string_view line(text.data() + at, end - at);
    std::vector<std::string_view> words = split_words(line);
    at = end + 1;
    if (words.empty()) continue;
    if (line.find_first_not_of(' ') < kFurther) {
      attributes = &out[std::string(words.front())];
      words.erase(words.begin(), words.begin() + std::min<std::ptrdiff_t>(2, std::ssize(words)));
    }
    if (attributes) attributes->insert(words.begin(), words.end());
  }
  out["body"] = out["worldbody"] = out["(world)body"];
  out.erase("(world)body");
  return out["geom"].contains("size") ? out : MjcfSchema();
}

const MjcfSchema& schema() {
  static const MjcfSchema kSchema = read_schema();
  return kSchema;
}

const Names& element_names() {
  static const Names kNames = [] {
    Names out(kBesides.begin(), kBesides.end());
    for (const auto& [name, attributes] : schema()) out.insert(name);
    return out;
  }();
  return kNames;
}

/// The name that a word is a slip of, looked for once for each word.
class Slips {
 public:
  const std::string& of(const std::string& word, const Names& names) {
    const auto [at, is_new] = known_.try_emplace({&names, word});
    if (is_new) at->second = slip_of(word, {names.begin(), names.end()});
    return at->second;
  }

 private:
  std::map<std::pair<const Names*, std::string>, std::string> known_;
};

std::string cure(const std::string& guess) {
  return guess.empty() ? "; remove it, or correct the word"
                       : fmt::format("; did you mean '{}'?", guess);
}

/// Visits unknown words: `visit(element, attribute's name or null, what it is a slip of)`.
template <class Visit>
void for_each_unknown(const XmlFile& xml, const Visit& visit) {
  if (schema().empty()) return;
  Slips slips;
  for_each_element(xml.root(), [&](const XmlElement& element) {
    if (std::find(kBesides.begin(), kBesides.end(), element.Name()) != kBesides.end()) return;
    auto known = schema().find(std::string_view(element.Name()));
    if (known == schema().end()) {
      const std::string& guess = slips.of(element.Name(), element_names());
      visit(element, nullptr, guess);
      known = schema().find(guess);
      if (known == schema().end()) return;
    }
    for (const auto* at = element.FirstAttribute(); at != nullptr; at = at->Next())
      if (!known->second.contains(std::string_view(at->Name())))
        visit(element, at->Name(), slips.of(at->Name(), known->second));
  });
}

}  // namespace

Refusals unknown_words(const XmlFile& xml) {
  std::vector<InputError> found;
  std::size_t more = 0;
  const XmlElement* last = nullptr;
  for_each_unknown(
      xml, [&](const XmlElement& element, const char* attribute, const std::string& guess) {
        last = &element;
        if (found.size() == kMostTold) {
          ++more;
          return;
        }
        found.push_back(
            xml.error(element, attribute == nullptr
                                   ? "is no element of MJCF" + cure(guess)
                                   : fmt::format("attribute {}: MJCF has none of that name here{}",
                                                 attribute, cure(guess))));
      });
  Refusals out;
  for (const InputError& each : found) out.add(each);
  if (more > 0)
    out.add(xml.error(*last, fmt::format("is the last of {} more places with words that MJCF does "
                                         "not have; mend those above likewise",
                                         more)));
  return out;
}

std::string with_known_words(const XmlFile& xml) {
  std::map<std::size_t, std::pair<std::size_t, std::string>> edits;  // begin: end, what goes there
  const auto blanks_of = [&](std::size_t begin, std::size_t end) {
    std::string blanks = xml.text.substr(begin, end - begin);
    for (char& c : blanks)
      if (c != '\n') c = ' ';
    return blanks;
  };
  for_each_unknown(
      xml, [&](const XmlElement& element, const char* attribute, const std::string& guess) {
        const TagSpan& tag = xml.tag(element);
        if (attribute == nullptr) {
          if (guess.empty()) return;
          edits[tag.begin + 1] = {tag.begin + 1 + tag.name.size(), guess};
          if (tag.close_begin != tag.end)
            edits[tag.close_begin + 2] = {tag.close_begin + 2 + tag.name.size(), guess};
          return;
        }
        const auto span =
            std::find_if(tag.attributes.begin(), tag.attributes.end(),
                         [&](const AttributeSpan& each) { return each.name == attribute; });
        const auto name = static_cast<std::size_t>(span->name.data() - xml.text.data());
        if (!guess.empty() && !has_attribute(element, guess.c_str()))
          edits[name] = {name + span->name.size(), guess};
        else
          edits[name] = {span->end, blanks_of(name, span->end)};
      });
  std::string out;
  std::size_t at = 0;
  for (const auto& [begin, edit] : edits) {
    out.append(xml.text, at, begin - at).append(edit.second);
    at = edit.first;
  }
  return out.append(xml.text, at);
}

std::string cure_of_refusal(std::string_view message) {
  const auto tells = [&](std::string_view words) { return message.find(words) != message.npos; };
  if (tells("STL file") || tells("MSH file") || tells("OBJ file") || tells("no decoder found"))
    return "write that mesh file anew, as a binary STL (MuJoCo reads none of text) or as OBJ";
  if (tells("at least 4 vertices required"))
    return "the mesh file has fewer that can be read; write it anew, as a binary STL or as OBJ";
  if (tells("not found in "))
    return "where that stands in a file that includes this one, as a scene with the floor does, "
           "name that file in the place of this one; else mend the name";
  return "mend the file so that MuJoCo opens it without Legwright";
}

}  // namespace legwright
