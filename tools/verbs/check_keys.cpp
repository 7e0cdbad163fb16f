// SPDX-License-Identifier: Apache-2.0
#include "tools/verbs/check_keys.hpp"

#include <fmt/format.h>

#include "optimizer/terms/registry.hpp"
#include "tools/verbs/key_words.hpp"

namespace legwright {
namespace {

std::string role_name(TermRole role) {
  switch (role) {
    case TermRole::objective:
      return "objective";
    case TermRole::constraint:
      return "constraint";
    case TermRole::regulariser:
      return "regulariser";
    case TermRole::outer:
      return "outer";
  }
  return "";
}

}  // namespace

std::string keys_text() {
  std::string out = "Keys of a task file (TOML, SI units).\n" + key_list_text(task_keys(), true);
  out += "\nTERM, with its default weight\n";
  for (const TermEntry& term : term_registry())
    if (term.role != TermRole::outer)
      out += fmt::format("    {:20} {:<8} {}\n", term.name, term.default_weight, term.label);
  return out;
}

Json keys_json() {
  Json terms = Json::array();
  for (const TermEntry& term : term_registry())
    terms.push_back({{"name", term.name},
                     {"role", role_name(term.role)},
                     {"equation", term.equation},
                     {"weight", term.default_weight},
                     {"unit", term.unit},
                     {"label", term.label}});
  return {{"schema", "legwright/task_keys"},
          {"version", 1},
          {"keys", key_list_json(task_keys())},
          {"terms", terms}};
}

}  // namespace legwright
