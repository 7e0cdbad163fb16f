// SPDX-License-Identifier: Apache-2.0
#include "mjcf/propose/declare.hpp"

#include <fmt/format.h>

#include "mjcf/read/bindings.hpp"
#include "mjcf/text/numbers.hpp"
#include "mjcf/text/text_edits.hpp"
#include "mjcf/text/xml.hpp"

namespace legwright {
namespace {

/// Nine digits are enough for a nanometre, and can be read.
std::string nine_digits(double value) {
  const std::string text = fmt::format("{:.9g}", value);
  return text == "-0" ? "0" : text;
}

std::vector<std::string> declarations(const std::vector<Proposal>& proposals,
                                      const std::string& end) {
  std::vector<std::string> out;
  for (const Proposal& p : proposals) {
    const std::string name = escape_xml(std::string(kDeclarationPrefix) + p.name, "\"");
    out.push_back(fmt::format("<numeric name=\"{}\" data=\"{} {} {}\"/>", name,
                              nine_digits(p.value), nine_digits(p.lower), nine_digits(p.upper)));
    out.push_back(fmt::format("<text name=\"{}\"{}          data=\"{} | {} | {}\"/>", name, end,
                              p.unit, escape_xml(p.binding, "\""), escape_xml(p.sentence, "\"")));
  }
  return out;
}

std::string without_last(const std::string& text, const std::string& end) {
  return text.substr(0, text.size() - end.size());
}

/// Behind the start tag of such a section of the file; npos where there is none that is open.
std::size_t inside_section(const XmlFile& xml, const char* section) {
  const XmlElement* found = xml.root().FirstChildElement(section);
  if (!found) return std::string::npos;
  const TagSpan& tag = xml.tag(*found);
  const std::size_t from = tag.attributes.empty() ? tag.name_end : tag.attributes.back().end;
  const std::size_t close = xml.text.find('>', from);
  return xml.text[close - 1] == '/' ? std::string::npos : close + 1;
}

/// Where the root's end tag starts: the last one of that name that is not in a comment.
std::size_t end_tag(const XmlFile& xml) {
  const std::string& text = xml.text;
  const TagSpan& last = xml.scan.tags.back();
  std::size_t at = last.attributes.empty() ? last.name_end : last.attributes.back().end;
  std::size_t found = std::string::npos;
  while ((at = text.find('<', at)) != std::string::npos) {
    const auto skip = [&](std::string_view open, std::string_view close) {
      if (text.compare(at, open.size(), open) != 0) return false;
      const std::size_t end = text.find(close, at + open.size());
      at = end == std::string::npos ? text.size() : end + close.size();
      return true;
    };
    if (skip("<!--", "-->") || skip("<![CDATA[", "]]>") || skip("<?", "?>")) continue;
    if (text.compare(at, 8, "</mujoco") == 0) found = at;
    ++at;
  }
  return found;
}

}  // namespace

std::string line_end(const std::string& text) {
  return text.find("\r\n") == std::string::npos ? "\n" : "\r\n";
}

std::string with_lines_in_section(const std::string& text, const std::filesystem::path& file,
                                  const char* section, const std::vector<std::string>& lines) {
  const auto xml = load_xml(text, file);
  const std::string end = line_end(text), indent = "    ";
  std::string all;
  for (const std::string& line : lines) all.append(indent).append(line).append(end);
  std::string out = xml->text;
  if (const std::size_t at = inside_section(*xml, section); at != std::string::npos)
    return out.insert(at, end + without_last(all, end));
  const std::size_t close = end_tag(*xml);
  if (close == std::string::npos)
    throw xml->error(xml->root(), "has no end tag </mujoco>; a robot is a <body> in <worldbody>");
  // Before the last line's end tag: on a line of its own, as it mostly stands already.
  const bool own_line = close == 0 || out[close - 1] == '\n';
  return out.insert(
      close, fmt::format("{0}  <{1}>{2}{3}  </{1}>{2}", own_line ? "" : end, section, end, all));
}

std::string with_declarations(const std::string& text, const std::filesystem::path& file,
                              const std::vector<Proposal>& proposals) {
  if (proposals.empty()) return text;
  return with_lines_in_section(text, file, "custom", declarations(proposals, line_end(text)));
}

std::string with_named_bodies(const std::string& text, const std::filesystem::path& file,
                              const std::set<std::string>& joints) {
  const auto xml = load_xml(text, file);
  TextEdits edits(*xml);
  for (const std::string& name : joints) {
    const XmlElement* const joint = find_named(xml->root(), "joint", name);
    const XmlElement* const body = joint ? joint->Parent()->ToElement() : nullptr;
    if (!body || !is_tag(*body, "body") || has_attribute(*body, "name")) continue;
    const bool free = !find_named(xml->root(), "body", name);
    edits.set(*body, "name", free ? name : name + "_body");
  }
  return edits.apply();
}

}  // namespace legwright
