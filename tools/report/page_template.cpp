// SPDX-License-Identifier: Apache-2.0
#include "tools/report/page_template.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <vector>

#include "tools/files/escape.hpp"

namespace legwright {

Hole::Hole(std::string_view name, std::string_view text)
    : name_(name), html_(escape_attribute(text)) {}

Hole Hole::markup(std::string_view name, std::string_view html) {
  Hole hole;
  hole.name_ = name;
  hole.html_ = html;
  return hole;
}

std::string fill(std::string_view page, std::initializer_list<Hole> holes) {
  std::string out;
  std::vector<bool> used(holes.size(), false);
  for (std::size_t at = 0; at < page.size(); ++at) {
    const char c = page[at];
    const bool doubled = at + 1 < page.size() && page[at + 1] == c;
    if ((c == '{' || c == '}') && doubled) {
      out += c;
      ++at;
      continue;
    }
    if (c == '}') throw std::logic_error("page template: a lone }");
    if (c != '{') {
      out += c;
      continue;
    }
    const std::size_t end = page.find('}', at);
    if (end == std::string_view::npos) throw std::logic_error("page template: an open {");
    const std::string_view name = page.substr(at + 1, end - at - 1);
    const auto hole =
        std::find_if(holes.begin(), holes.end(), [&](const Hole& h) { return h.name() == name; });
    if (hole == holes.end())
      throw std::logic_error(fmt::format("page template: nothing for {{{}}}", name));
    out += hole->html();
    used[static_cast<std::size_t>(hole - holes.begin())] = true;
    at = end;
  }
  for (std::size_t k = 0; k < used.size(); ++k) {
    if (!used[k])
      throw std::logic_error(
          fmt::format("page template: no hole {{{}}}", (holes.begin() + k)->name()));
  }
  return out;
}

std::string small_html(std::string_view words) {
  return words.empty() ? "" : fill("<small>{words}</small>", {{"words", words}});
}

std::string number_head_html(std::string_view head) {
  return fill(R"(<th class="n">{head}</th>)", {{"head", head}});
}

}  // namespace legwright
