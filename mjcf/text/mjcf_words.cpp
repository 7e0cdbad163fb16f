// SPDX-License-Identifier: Apache-2.0
#include "mjcf/text/mjcf_words.hpp"

#include <fmt/format.h>
#include <mujoco/mujoco.h>

#include <algorithm>
#include <array>
#include <map>
#include <vector>

#include "mjcf/text/nearest_word.hpp"
#include "mjcf/text/numbers.hpp"

namespace legwright {
namespace {

/// Attributes by the names of their elements, wherever these stand.
using MjcfSchema = std::map<std::string, std::vector<std::string>, std::less<>>;

/// Elements that MuJoCo takes besides those that it prints, with any attributes.
constexpr std::array<std::string_view, 3> kBesides{"frame", "replicate", "include"};

/// As MuJoCo prints it: "   geom (*)   attribute attribute …" and further attributes on lines that
/// begin far to the right; "(world)body" for both.
MjcfSchema read_schema() {
  constexpr int kBytes = 1 << 18;
  constexpr std::size_t kFurther = 30;  // [columns]
  std::string text(kBytes, '\0');
  text.resize(static_cast<std::size_t>(
      std::clamp(mj_printSchema(nullptr, text.data(), kBytes, 0, 0), 0, kBytes)));
  MjcfSchema out;
  std::vector<std::string>* attributes = nullptr;
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
    if (attributes) attributes->insert(attributes->end(), words.begin(), words.end());
  }
  out["body"] = out["worldbody"] = out["(world)body"];
  out.erase("(world)body");
  return out;
}

const MjcfSchema& schema() {
  static const MjcfSchema kSchema = read_schema();
  return kSchema;
}

const std::vector<std::string>& element_names() {
  static const std::vector<std::string> kNames = [] {
    std::vector<std::string> out;
    for (const auto& [name, attributes] : schema()) out.push_back(name);
    out.insert(out.end(), kBesides.begin(), kBesides.end());
    return out;
  }();
  return kNames;
}

std::string cure(const std::string& guess) {
  return guess.empty() ? "; remove it, or correct the word"
                       : fmt::format("; did you mean '{}'?", guess);
}

/// Visits unknown words: `visit(element, attribute's name or null, what it is a slip of)`.
template <class Visit>
void for_each_unknown(const XmlFile& xml, const Visit& visit) {
  for_each_element(xml.root(), [&](const XmlElement& element) {
    if (std::find(kBesides.begin(), kBesides.end(), element.Name()) != kBesides.end()) return;
    auto known = schema().find(std::string_view(element.Name()));
    if (known == schema().end()) {
      const std::string guess = slip_of(element.Name(), element_names());
      visit(element, nullptr, guess);
      known = schema().find(guess);
      if (known == schema().end()) return;
    }
    const std::vector<std::string>& names = known->second;
    for (const auto* at = element.FirstAttribute(); at != nullptr; at = at->Next())
      if (std::find(names.begin(), names.end(), at->Name()) == names.end())
        visit(element, at->Name(), slip_of(at->Name(), names));
  });
}

}  // namespace

Refusals unknown_words(const XmlFile& xml) {
  Refusals out;
  for_each_unknown(xml, [&](const XmlElement& element, const char* attribute,
                            const std::string& guess) {
    out.add(xml.error(element, attribute == nullptr
                                   ? "is no element of MJCF" + cure(guess)
                                   : fmt::format("attribute {}: MJCF has none of that name here{}",
                                                 attribute, cure(guess))));
  });
  return out;
}

std::string with_known_words(const XmlFile& xml) {
  struct Edit {
    std::size_t begin, end;
    std::string text;
  };
  std::vector<Edit> edits;
  for_each_unknown(
      xml, [&](const XmlElement& element, const char* attribute, const std::string& guess) {
        const TagSpan& tag = xml.tag(element);
        if (attribute == nullptr) {
          if (guess.empty()) return;
          edits.push_back({tag.begin + 1, tag.begin + 1 + tag.name.size(), guess});
          if (tag.close_begin != tag.end)
            edits.push_back({tag.close_begin + 2, tag.close_begin + 2 + tag.name.size(), guess});
          return;
        }
        const auto span =
            std::find_if(tag.attributes.begin(), tag.attributes.end(),
                         [&](const AttributeSpan& each) { return each.name == attribute; });
        const auto name = static_cast<std::size_t>(span->name.data() - xml.text.data());
        if (!guess.empty() && !has_attribute(element, guess.c_str())) {
          edits.push_back({name, name + span->name.size(), guess});
          return;
        }
        std::string blanks = xml.text.substr(name, span->end - name);
        for (char& c : blanks)
          if (c != '\n') c = ' ';
        edits.push_back({name, span->end, blanks});
      });
  std::sort(edits.begin(), edits.end(),
            [](const Edit& a, const Edit& b) { return a.begin > b.begin; });
  std::string out = xml.text;
  for (const Edit& edit : edits) out.replace(edit.begin, edit.end - edit.begin, edit.text);
  return out;
}

std::string cure_of_refusal(std::string_view message) {
  const auto tells = [&](std::string_view words) { return message.find(words) != message.npos; };
  if (tells("STL file") || tells("MSH file") || tells("OBJ file") || tells("no decoder found"))
    return "write that mesh file anew, as a binary STL (MuJoCo reads none of text) or as OBJ";
  if (tells("at least 4 vertices required"))
    return "the mesh file has fewer that can be read; write it anew, as a binary STL or as OBJ";
  return "mend the file so that MuJoCo opens it without Legwright";
}

}  // namespace legwright
