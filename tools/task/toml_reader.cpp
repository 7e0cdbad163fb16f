// SPDX-License-Identifier: Apache-2.0
#include "tools/task/toml_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "mjcf/text/input_error.hpp"
#include "mjcf/text/nearest_word.hpp"

namespace legwright {
namespace {

std::string type_name(const toml::node& node) {
  switch (node.type()) {
    case toml::node_type::table:
      return "a table";
    case toml::node_type::array:
      return "an array";
    case toml::node_type::string:
      return "a text";
    case toml::node_type::integer:
      return "an integer";
    case toml::node_type::floating_point:
      return "a number";
    case toml::node_type::boolean:
      return "true or false";
    default:
      return "a date or time";
  }
}

bool inside(double value, const Range& range) {
  return (range.low_open ? value > range.low : value >= range.low) &&
         (range.high_open ? value < range.high : value <= range.high);
}

constexpr double kSomeCentimetres = 30.0;  // above, lengths are rather given in millimetres

/// Of a number outside of its range that would be within in the unit that is probably meant:
/// degrees, millimetres, grams.
std::string other_unit_text(double value, const Range& range) {
  const bool angle = range.unit.starts_with("rad"), length = range.unit == "m";
  if ((!angle && !length && range.unit != "kg") || !std::isfinite(value)) return "";
  const double meant = angle ? value * std::numbers::pi / 180.0 : 1e-3 * value;
  if (!inside(meant, range)) return "";
  const std::string unit =
      angle ? fmt::format("degrees{}", range.unit.substr(3)) : (length ? "mm" : "g");
  const bool maybe_cm = length && std::abs(value) < kSomeCentimetres && inside(10.0 * meant, range);
  return fmt::format("; {}{} {} are {:.4g} {}",
                     maybe_cm ? fmt::format("{} cm are {:.4g} m, ", value, 10.0 * meant) : "",
                     value, unit, meant, range.unit);
}

int line(const toml::node& node) { return static_cast<int>(node.source().begin.line); }

}  // namespace

std::string range_text(const Range& range, std::string_view what) {
  const std::string unit = range.unit.empty() ? "" : fmt::format(" {}", range.unit);
  const bool from = std::isfinite(range.low), to = std::isfinite(range.high);
  if (!from && !to) return "a finite number";
  const std::string low = from ? fmt::format("{} {} ", range.low, range.low_open ? "<" : "<=") : "";
  const std::string high =
      to ? fmt::format(" {} {}", range.high_open ? "<" : "<=", range.high) : "";
  return fmt::format("{}{}{}{}", low, what, high, unit);
}

void Problems::add(int line_number, const std::string& key, const std::string& message) {
  by_line_.emplace(line_number, InputError(file_, line_number, key, message));
}

void Problems::add_missing(int line_number, const std::string& key, const std::string& message) {
  missing_.emplace(line_number, InputError(file_, line_number, key, message));
}

void Problems::throw_if_any() const {
  if (by_line_.empty() && missing_.empty()) return;
  std::string text;
  for (const InputError& problem : all()) text.append(text.empty() ? "" : "\n") += problem.what();
  throw InputError(reference_.empty() ? text : fmt::format("{} ({})", text, reference_));
}

std::vector<InputError> Problems::all() const {
  std::vector<InputError> out;
  for (const auto* list : {&by_line_, &missing_})
    for (const auto& [line, problem] : *list) out.push_back(problem);
  return out;
}

TableReader::TableReader(const toml::table* table, std::string prefix, Problems& problems,
                         std::map<std::string, int>& lines)
    : table_(table), prefix_(std::move(prefix)), problems_(problems), lines_(lines) {}

std::string TableReader::full(std::string_view key) const {
  return prefix_.empty() ? std::string(key) : fmt::format("{}.{}", prefix_, key);
}

const toml::node* TableReader::node(std::string_view key) {
  if (std::find(known_.begin(), known_.end(), key) == known_.end()) known_.emplace_back(key);
  const toml::node* found = table_ ? table_->get(key) : nullptr;
  if (found) lines_[full(key)] = line(*found);
  return found;
}

bool TableReader::has(std::string_view key) { return node(key) != nullptr; }

int TableReader::line_of(std::string_view key) {
  const toml::node* found = node(key);
  if (found) return line(*found);
  return table_ ? line(*table_) : 0;
}

std::optional<double> TableReader::checked(const toml::node& found, const std::string& name,
                                           const Range& range) {
  const std::string expected = range_text(range, name.substr(name.rfind('.') + 1));
  const auto value = found.is_number() ? found.value<double>() : std::nullopt;
  if (!value) {
    problems_.add(line(found), name,
                  fmt::format("is {}; expected a number: {}", type_name(found), expected));
    return std::nullopt;
  }
  if (!std::isfinite(*value) || !inside(*value, range)) {
    problems_.add(
        line(found), name,
        fmt::format("is {}; expected {}{}", *value, expected, other_unit_text(*value, range)));
    return std::nullopt;
  }
  return value;
}

std::optional<double> TableReader::number(std::string_view key, const Range& range) {
  const toml::node* found = node(key);
  return found ? checked(*found, full(key), range) : std::nullopt;
}

std::optional<int> TableReader::integer(std::string_view key, int low, int high) {
  const toml::node* found = node(key);
  if (!found) return std::nullopt;
  const auto expected = fmt::format("{} <= {} <= {}", low, key, high);
  if (!found->is_integer()) {
    problems_.add(line(*found), full(key),
                  fmt::format("is {}; expected a whole number: {}", type_name(*found), expected));
    return std::nullopt;
  }
  const std::int64_t value = found->as_integer()->get();
  if (value < low || value > high) {
    problems_.add(line(*found), full(key), fmt::format("is {}; expected {}", value, expected));
    return std::nullopt;
  }
  return static_cast<int>(value);
}

std::optional<std::string> TableReader::text(std::string_view key) {
  const toml::node* found = node(key);
  if (!found) return std::nullopt;
  if (!found->is_string() || found->as_string()->get().empty()) {
    problems_.add(line(*found), full(key),
                  fmt::format("is {}; expected a text in quotes",
                              found->is_string() ? "empty" : type_name(*found)));
    return std::nullopt;
  }
  return found->as_string()->get();
}

std::optional<std::vector<double>> TableReader::numbers(std::string_view key, const Range& range,
                                                        std::size_t count) {
  const toml::node* found = node(key);
  if (!found) return std::nullopt;
  const toml::array* array = found->as_array();
  if (!array || array->empty() || (count > 0 && array->size() != count)) {
    const auto wanted =
        count > 0 ? fmt::format("an array of {} numbers", count) : "an array of numbers";
    const auto got = array ? fmt::format("an array of {}", array->size()) : type_name(*found);
    const bool more = array && count > 0 && array->size() > count;
    problems_.add(line(*found), full(key),
                  fmt::format("is {}; expected {}{}", got, wanted,
                              more ? " (a comma parts two numbers: 0.4, not 0,4)" : ""));
    return std::nullopt;
  }
  std::vector<double> values;
  for (const toml::node& entry : *array)
    if (const auto value = checked(entry, full(key), range)) values.push_back(*value);
  if (values.size() != array->size()) return std::nullopt;
  return values;
}

std::optional<std::vector<std::vector<double>>> TableReader::pairs(std::string_view key,
                                                                   const Range& range) {
  const toml::node* found = node(key);
  if (!found) return std::nullopt;
  std::vector<std::vector<double>> rows;
  const toml::array* array = found->as_array();
  for (std::size_t i = 0; array && i < array->size(); ++i) {
    const toml::array* row = array->get(i)->as_array();
    if (!row || row->size() != 2) break;
    std::vector<double> values;
    for (const toml::node& entry : *row)
      if (const auto value = checked(entry, full(key), range)) values.push_back(*value);
    if (values.size() != 2) return std::nullopt;
    rows.push_back(values);
  }
  if (!array || array->empty() || rows.size() != array->size()) {
    problems_.add(line(*found), full(key),
                  "expected an array of pairs of numbers: [[forward, left], ...]");
    return std::nullopt;
  }
  return rows;
}

std::optional<std::vector<std::string>> TableReader::names(std::string_view key) {
  const toml::node* found = node(key);
  if (!found) return std::nullopt;
  std::vector<std::string> words;
  const toml::array* array = found->as_array();
  for (std::size_t i = 0; array && i < array->size(); ++i)
    if (const auto word = array->get(i)->value<std::string>(); word && !word->empty())
      words.push_back(*word);
  if (!array || array->empty() || words.size() != array->size()) {
    problems_.add(line(*found), full(key),
                  fmt::format("is {}; expected an array of texts in quotes: [\"a\", \"b\"]",
                              type_name(*found)));
    return std::nullopt;
  }
  return words;
}

std::map<std::string, std::vector<double>> TableReader::numbers_of_names(std::string_view key,
                                                                         const Range& range,
                                                                         std::size_t count) {
  std::map<std::string, std::vector<double>> values;
  const toml::table* found = table(key);
  if (!found) return values;
  TableReader inner(found, full(key), problems_, lines_);
  for (const auto& [name, entry] : *found)
    if (const auto row = inner.numbers(name.str(), range, count))
      values[std::string(name.str())] = *row;
  return values;
}

std::map<std::string, double> TableReader::numbers_by_name(std::string_view key,
                                                           const Range& range) {
  std::map<std::string, double> values;
  const toml::table* found = table(key);
  if (!found) return values;
  for (const auto& [name, entry] : *found) {
    const std::string path = fmt::format("{}.{}", full(key), name.str());
    lines_[path] = line(entry);
    if (const auto value = checked(entry, path, range)) values[std::string(name.str())] = *value;
  }
  return values;
}

std::map<std::string, std::vector<std::vector<double>>> TableReader::pairs_by_name(
    std::string_view key, const Range& range) {
  std::map<std::string, std::vector<std::vector<double>>> values;
  const toml::table* found = table(key);
  if (!found) return values;
  TableReader within(found, full(key), problems_, lines_);
  for (const auto& [name, entry] : *found)
    if (auto rows = within.pairs(name.str(), range)) values[std::string(name.str())] = *rows;
  return values;
}

std::optional<CycleTarget> TableReader::timed_target(const toml::array& rows,
                                                     const std::string& name, const Range& range) {
  CycleTarget target;
  for (const toml::node& entry : rows) {
    const toml::array* row = entry.as_array();
    if (!row || row->size() != 2) {
      problems_.add(line(entry), name,
                    "expected pairs of phase and value: [[0.0, 0.01], [0.6, 0.05], ...]");
      return std::nullopt;
    }
    const auto phase = checked(*row->get(0), name + ".phase", {0.0, 1.0, false, true, ""});
    const auto value = checked(*row->get(1), name, range);
    if (!phase || !value) return std::nullopt;
    if (!target.phases.empty() && *phase <= target.phases.back()) {
      problems_.add(line(entry), name,
                    fmt::format("phase {} comes after phase {}; give the pairs with rising phases, "
                                "from 0 to below 1",
                                *phase, target.phases.back()));
      return std::nullopt;
    }
    target.phases.push_back(*phase);
    target.values.push_back(*value);
  }
  return target;
}

std::optional<CycleTarget> TableReader::target(std::string_view key, const Range& range) {
  const toml::node* found = node(key);
  if (!found) return std::nullopt;
  const toml::array* array = found->as_array();
  if (array && !array->empty() && array->get(0)->is_array())
    return timed_target(*array, full(key), range);
  if (!array || array->empty()) {
    problems_.add(
        line(*found), full(key),
        fmt::format("is {}; expected values over the cycle: evenly spaced ones, [0.02], or "
                    "pairs of phase and value, [[0.0, 0.01], [0.6, 0.05]]",
                    array ? "an empty array" : type_name(*found)));
    return std::nullopt;
  }
  if (const auto values = numbers(key, range, 0)) return CycleTarget{{}, *values, 1.0};
  return std::nullopt;
}

std::map<std::string, CycleTarget> TableReader::targets_by_name(std::string_view key,
                                                                const Range& range,
                                                                const Range& weight_range) {
  std::map<std::string, CycleTarget> targets;
  const toml::table* found = table(key);
  if (!found) return targets;
  TableReader within(found, full(key), problems_, lines_);
  for (const auto& [name, entry] : *found) {
    const toml::table* own = entry.as_table();
    if (own == nullptr) {
      if (auto target = within.target(name.str(), range))
        targets[std::string(name.str())] = *target;
      continue;
    }
    TableReader row(within.table(name.str()), within.full(name.str()), problems_, lines_);
    auto target = row.target("over_cycle", range);
    row.require(target.has_value(), "over_cycle", "over_cycle = [0.0, 0.05]");
    const auto weight = row.number("weight", weight_range);
    row.finish();
    if (!target) continue;
    target->weight = weight.value_or(1.0);
    targets[std::string(name.str())] = *target;
  }
  return targets;
}

const toml::table* TableReader::table(std::string_view key) {
  const toml::node* found = node(key);
  if (!found) return nullptr;
  if (!found->is_table())
    problems_.add(
        line(*found), full(key),
        fmt::format("is {}; expected a table that starts with [{}]", type_name(*found), full(key)));
  return found->as_table();
}

std::vector<const toml::table*> TableReader::tables(std::string_view key) {
  std::vector<const toml::table*> result;
  const toml::node* found = node(key);
  if (!found) return result;
  if (const toml::array* array = found->as_array())
    for (const toml::node& entry : *array)
      if (entry.is_table()) result.push_back(entry.as_table());
  if (!found->is_array() || found->as_array()->empty() ||
      result.size() != found->as_array()->size()) {
    const toml::array* array = found->as_array();
    const std::string name = full(key);
    problems_.add(
        line(*found), name,
        array && array->empty()
            ? fmt::format("is empty; expected one table at least: [[{}]], or {} = [{{…}}]", name,
                          key)
            : fmt::format(
                  "is {}; expected tables that start with [[{}]] each",
                  array ? "an array that holds something else than tables" : type_name(*found),
                  name));
    result.clear();
  }
  return result;
}

void TableReader::require(bool present, std::string_view key, const std::string& example) {
  // A key that is there but wrong has been reported already.
  if (!present && !has(key))
    problems_.add_missing(line_of(key), full(key),
                          fmt::format("is missing; add for instance: {}", example));
}

void TableReader::finish() {
  if (!table_) return;
  for (const auto& [key, entry] : *table_) {
    const std::string name(key.str());
    if (std::find(known_.begin(), known_.end(), name) != known_.end()) continue;
    const std::string guess = nearest(name, known_);
    const std::string fix = guess.empty() ? fmt::format("known here: {}", fmt::join(known_, ", "))
                                          : fmt::format("did you mean '{}'?", full(guess));
    problems_.add(static_cast<int>(key.source().begin.line), full(name),
                  fmt::format("unknown key; {}", fix));
  }
}

}  // namespace legwright
