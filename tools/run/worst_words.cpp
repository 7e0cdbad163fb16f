// SPDX-License-Identifier: Apache-2.0
#include "tools/run/worst_words.hpp"

#include "tools/run/joined_by_and.hpp"

namespace legwright {

std::string worst_words(const std::vector<WorstPart>& worst,
                        const std::function<std::string(const WorstPart&)>& value_words) {
  if (worst.empty()) return {};
  std::vector<std::string> names;
  for (const WorstPart& part : worst) {
    const std::string value = value_words && worst.size() > 1 ? value_words(part) : "";
    names.push_back(part.name + (value.empty() ? "" : " (" + value + ")"));
  }
  return (worst.front().kind == "body" ? "; hardest between " : "; worst ") + joined_by_and(names);
}

}  // namespace legwright
