// SPDX-License-Identifier: Apache-2.0
#include "tools/modules/figure_check.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "tools/modules/module_figures.hpp"

namespace legwright {
namespace {

bool among(const std::vector<std::string>& figures, const std::string& figure) {
  return std::find(figures.begin(), figures.end(), figure) != figures.end();
}

bool told(const ModuleFile& file, const std::string& figure) {
  const auto names = [&](const auto& entry) { return among(entry.figures, figure); };
  return std::any_of(file.sources.begin(), file.sources.end(), names) ||
         std::any_of(file.assumptions.begin(), file.assumptions.end(), names);
}

}  // namespace

void check_figures(const ModuleFile& file, const std::set<std::string>& given_keys, bool kind_known,
                   const std::map<std::string, int>& lines, Problems& problems) {
  const auto line_of = [&](const std::string& key) {
    const auto found = lines.find(key);
    return found == lines.end() ? 0 : found->second;
  };
  for (const std::string_view listed : module_figures()) {
    const std::string figure(listed);
    const bool given = given_keys.contains(figure), unknown = among(file.unknown, figure);
    if (given && !told(file, figure))
      problems.add(line_of(figure), figure,
                   "has no source; name it in the figures of a [[source]], or of an "
                   "[[assumption]] that says why it is so");
    if (!given && told(file, figure))
      problems.add(0, figure,
                   "is named by a source or an assumption and is not given; give it, or take its "
                   "name out");
    if (given && unknown)
      problems.add(line_of("unknown"), "unknown",
                   fmt::format("names \"{}\", which is given; take the name out", figure));
    if (!given && !unknown && kind_known && is_asked_for(file.module.kind, listed))
      problems.add_missing(0, figure,
                           "is neither given nor said to be unknown; give it with its source, or "
                           "name it in unknown = [...]");
  }
}

}  // namespace legwright
