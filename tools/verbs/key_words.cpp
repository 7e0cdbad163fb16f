// SPDX-License-Identifier: Apache-2.0
#include "tools/verbs/key_words.hpp"

#include <fmt/format.h>

#include <cmath>

namespace legwright {
namespace {

constexpr std::size_t kLineEnd = 100, kMeaningIndent = 4;

std::string scope_name(KeyScope scope) {
  switch (scope) {
    case KeyScope::file:
      return "file";
    case KeyScope::shared:
      return "file or task";
    case KeyScope::task:
      return "task";
    case KeyScope::both:
      return "file and task";
  }
  return "";
}

/// Words in lines of kLineEnd at most, indented.
std::string indented_lines(std::string_view text) {
  std::string out, line(kMeaningIndent, ' ');
  const auto end_line = [&] {
    out += line + "\n";
    line.assign(kMeaningIndent, ' ');
  };
  while (!text.empty()) {
    const std::size_t blank = std::min(text.find(' '), text.size());
    const std::string_view word = text.substr(0, blank);
    if (line.size() > kMeaningIndent && line.size() + 1 + word.size() > kLineEnd) end_line();
    if (line.size() > kMeaningIndent) line += ' ';
    line += word;
    text.remove_prefix(std::min(blank + 1, text.size()));
  }
  if (line.size() > kMeaningIndent) end_line();
  return out;
}

/// "number [s], 0.05 <= value <= 20"
std::string form_words(const KeyForm& form) {
  std::string out = form_text(form);
  if (!form.range.unit.empty()) out += fmt::format(" [{}]", form.range.unit);
  if (const std::string bounds = bounds_text(form); !bounds.empty()) out += ", " + bounds;
  return out;
}

Json form_json(const KeyForm& form) {
  const Range& range = form.range;
  const auto end = [](double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); };
  return {{"type", form_text(form)},    {"unit", range.unit},      {"low", end(range.low)},
          {"low_open", range.low_open}, {"high", end(range.high)}, {"high_open", range.high_open},
          {"bounds", bounds_text(form)}};
}

}  // namespace

std::string key_list_text(const std::vector<TaskKey>& keys, bool scoped) {
  std::string out;
  for (const TaskKey& key : keys) {
    std::string forms;
    for (const KeyForm& form : key.forms)
      forms += (forms.empty() ? "" : "; or ") + form_words(form);
    out +=
        fmt::format("\n{} = {}\n", key.path, key.example) + indented_lines(key.meaning) +
        indented_lines(fmt::format(
            "Value: {}.{}{}", forms, scoped ? fmt::format(" In: {}.", scope_name(key.scope)) : "",
            key.fallback.empty() ? "" : fmt::format(" Default: {}.", key.fallback)));
  }
  return out;
}

Json key_list_json(const std::vector<TaskKey>& keys) {
  Json out = Json::array();
  for (const TaskKey& key : keys) {
    Json forms = Json::array();
    for (const KeyForm& form : key.forms) forms.push_back(form_json(form));
    out.push_back({{"key", key.path},
                   {"table", key.table()},
                   {"forms", forms},
                   {"in", scope_name(key.scope)},
                   {"default", key.fallback},
                   {"example", key.example},
                   {"meaning", key.meaning}});
  }
  return out;
}

}  // namespace legwright
