// SPDX-License-Identifier: Apache-2.0
#include "tools/report/html.hpp"

#include <fmt/format.h>

#include <stdexcept>

namespace legwright {

void Html::start(std::string_view tag, Attributes attributes) {
  out_ += '<';
  out_ += tag;
  for (const auto& [name, value] : attributes)
    out_ += fmt::format(" {}=\"{}\"", name, escape_attribute(value));
}

Html& Html::open(std::string_view tag, Attributes attributes) {
  start(tag, attributes);
  out_ += '>';
  open_.emplace_back(tag);
  return *this;
}

Html& Html::close() {
  if (open_.empty()) throw std::logic_error("Html: nothing to close");
  out_ += fmt::format("</{}>", open_.back());
  // A line break is a blank between words: only after elements that stand alone.
  for (const char* block :
       {"div", "p", "tr", "table", "section", "figure", "li", "style", "script", "head"}) {
    if (open_.back() == block) out_ += '\n';
  }
  open_.pop_back();
  return *this;
}

Html& Html::lone(std::string_view tag, Attributes attributes) {
  start(tag, attributes);
  out_ += "/>";
  return *this;
}

Html& Html::text(std::string_view text) {
  out_ += escape_text(text);
  return *this;
}

Html& Html::element(std::string_view tag, std::string_view content, Attributes attributes) {
  return open(tag, attributes).text(content).close();
}

Html& Html::note(std::string_view content, std::string_view style) {
  return element("p", content, {{"class", style}});
}

Html& Html::number(std::string_view content, std::optional<std::string_view> label) {
  if (!label) return element("td", content, {{"class", "n"}});
  return element("td", content, {{"class", "n"}, {"data-label", *label}});
}

Html& Html::open_table(std::string_view style, const std::vector<TableColumn>& columns) {
  (style.empty() ? open("table") : open("table", {{"class", style}})).open("thead").open("tr");
  for (const TableColumn& column : columns) {
    if (column.style)
      element("th", column.head, {{"class", *column.style}});
    else
      element("th", column.head);
  }
  return close().close().open("tbody");
}

Html& Html::raw(std::string_view markup) {
  out_ += markup;
  return *this;
}

std::string Html::take() {
  if (!open_.empty()) throw std::logic_error(fmt::format("Html: <{}> is still open", open_.back()));
  return std::exchange(out_, {});
}

}  // namespace legwright
