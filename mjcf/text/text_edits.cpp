// SPDX-License-Identifier: Apache-2.0
#include "mjcf/text/text_edits.hpp"

#include <fmt/format.h>

#include "mjcf/text/numbers.hpp"

namespace legwright {
namespace {

double unrounded(double value) { return value; }

const AttributeSpan* find_span(const TagSpan& tag, std::string_view name) {
  for (const AttributeSpan& span : tag.attributes)
    if (span.name == name) return &span;
  return nullptr;
}

}  // namespace

std::string escape_xml(std::string_view value, std::string_view quotes) {
  std::string out;
  for (const char c : value) {
    if (c == '&')
      out += "&amp;";
    else if (c == '<')
      out += "&lt;";
    else if (quotes.find(c) != std::string_view::npos)
      out += c == '"' ? "&quot;" : "&apos;";
    else
      out += c;
  }
  return out;
}

void TextEdits::replace(std::size_t begin, std::size_t end, std::string text, bool append) {
  const auto [at, is_new] = edits_.try_emplace(begin, Edit{end, text});
  if (is_new) return;
  if (append)
    at->second.text += text;
  else
    at->second = {end, std::move(text)};
}

void TextEdits::set(const XmlElement& element, const char* name, const std::string& value) {
  const TagSpan& tag = xml_.tag(element);
  if (const AttributeSpan* span = find_span(tag, name)) {
    replace(span->value_begin, span->value_end, escape_xml(value));
    return;
  }
  const std::size_t at = tag.attributes.empty() ? tag.name_end : tag.attributes.back().end;
  replace(at, at, fmt::format(" {}=\"{}\"", name, escape_xml(value)), true);
}

void TextEdits::set_numbers(const XmlElement& element, const char* name,
                            const Eigen::Ref<const Eigen::VectorXd>& values) {
  set_words(element, name, rounded(values), rounded);
}

void TextEdits::set_exactly(const XmlElement& element, const char* name,
                            const Eigen::Ref<const Eigen::VectorXd>& values) {
  set_words(element, name, values, unrounded);
}

void TextEdits::set_words(const XmlElement& element, const char* name,
                          const Eigen::Ref<const Eigen::VectorXd>& values,
                          double (*written)(double)) {
  const AttributeSpan* span = find_span(xml_.tag(element), name);
  if (!span) return set(element, name, format_numbers(values));
  const std::string_view old =
      std::string_view(xml_.text).substr(span->value_begin, span->value_end - span->value_begin);
  const auto words = split_words(old);
  if (static_cast<Eigen::Index>(words.size()) != values.size())
    return set(element, name, format_numbers(values));
  std::string text;
  const char* copied = old.data();
  for (std::size_t i = 0; i < words.size(); ++i) {
    const std::optional<double> number = parse_number(words[i]);
    if (number && written(*number) == values[static_cast<Eigen::Index>(i)]) continue;
    text.append(copied, words[i].data());
    text += format_number(values[static_cast<Eigen::Index>(i)]);
    copied = words[i].data() + words[i].size();
  }
  text.append(copied, old.data() + old.size());
  if (text != old) replace(span->value_begin, span->value_end, text);
}

void TextEdits::copy_behind(const XmlElement& element, std::map<std::string, std::string> values) {
  const TagSpan& tag = xml_.tag(element);
  // The blanks before it, so that a copy stands below the original where that has its own line.
  std::size_t blank = tag.begin;
  while (blank > 0 && std::string_view(" \t\r\n").find(xml_.text[blank - 1]) != std::string::npos)
    --blank;
  std::string text = xml_.text.substr(blank, tag.begin - blank) + "<" + std::string(tag.name);
  for (const AttributeSpan& span : tag.attributes) {
    const auto own = values.find(std::string(span.name));
    if (own == values.end()) {
      text += xml_.text.substr(span.begin, span.end - span.begin);
      continue;
    }
    text += xml_.text.substr(span.begin, span.value_begin - span.begin) + escape_xml(own->second) +
            span.quote;
    values.erase(own);
  }
  for (const auto& [name, value] : values)
    text += fmt::format(" {}=\"{}\"", name, escape_xml(value));
  replace(tag.close_end, tag.close_end, text + "/>", true);
}

void TextEdits::remove(const XmlElement& element, const char* name) {
  if (const AttributeSpan* span = find_span(xml_.tag(element), name))
    replace(span->begin, span->end, "");
}

std::string TextEdits::apply() const {
  std::string out;
  std::size_t copied = 0;
  for (const auto& [begin, edit] : edits_) {
    out.append(xml_.text, copied, begin - copied);
    out += edit.text;
    copied = edit.end;
  }
  return out.append(xml_.text, copied, std::string::npos);
}

}  // namespace legwright
