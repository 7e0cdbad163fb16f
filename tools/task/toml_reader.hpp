// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <toml++/toml.h>

#include "mjcf/text/input_error.hpp"
#include "optimizer/motion/cycle_target.hpp"

namespace legwright {

/// Everything that is wrong with one file, gathered so that it can be told at once.
class Problems {
 public:
  /// @param reference where to read on, told behind the last problem; may be empty
  explicit Problems(std::string file, std::string reference = "")
      : file_(std::move(file)), reference_(std::move(reference)) {}
  /// @param message what is wrong; how to fix it
  void add(int line, const std::string& key, const std::string& message);
  /// The same of a key that is not there.
  void add_missing(int line, const std::string& key, const std::string& message);
  /// Throws InputError with one line per problem, in the order of the file, if there is any. Keys
  /// that are missing come last: one that was misspelt is told before the one that it was to be.
  void throw_if_any() const;
  /// The same, each by itself.
  std::vector<InputError> all() const;

 private:
  std::string file_, reference_;
  std::multimap<int, InputError> by_line_, missing_;
};

/// The numbers that a key accepts, and how to say so.
struct Range {
  double low, high;
  bool low_open = false;  // low itself is not accepted
  bool high_open = false;
  std::string_view unit;  // "s", "m/s", … or empty
};

/// "0.05 <= period <= 20 s". @param what is in that range
std::string range_text(const Range& range, std::string_view what);

/// Reads one table strictly: every key must be asked for, have the right type and lie in range.
/// What is wrong goes to `problems`; the value is then absent.
class TableReader {
 public:
  /// @param prefix path of the table, "" for the root, for messages. @param table may be null: all
  /// keys absent.
  TableReader(const toml::table* table, std::string prefix, Problems& problems,
              std::map<std::string, int>& lines);

  bool has(std::string_view key);
  std::optional<double> number(std::string_view key, const Range& range);
  std::optional<int> integer(std::string_view key, int low, int high);
  std::optional<std::string> text(std::string_view key);
  /// An array of numbers. @param count how many; 0 for any number but none.
  std::optional<std::vector<double>> numbers(std::string_view key, const Range& range,
                                             std::size_t count);
  /// An array of arrays of two numbers.
  std::optional<std::vector<std::vector<double>>> pairs(std::string_view key, const Range& range);
  /// An array of texts, none of them empty.
  std::optional<std::vector<std::string>> names(std::string_view key);
  /// A table of names and numbers; the names are free.
  std::map<std::string, double> numbers_by_name(std::string_view key, const Range& range);
  /// A table of names and arrays of pairs; the names are free.
  std::map<std::string, std::vector<std::vector<double>>> pairs_by_name(std::string_view key,
                                                                        const Range& range);
  /// A table of names and targets over the cycle, each a list of evenly spaced values, a list of
  /// [phase, value], or a table {over_cycle = either list, weight = …}; the names are free.
  std::map<std::string, CycleTarget> targets_by_name(std::string_view key, const Range& range,
                                                     const Range& weight_range);
  /// A table of names and arrays of `count` numbers; the names are free.
  std::map<std::string, std::vector<double>> numbers_of_names(std::string_view key,
                                                              const Range& range,
                                                              std::size_t count);
  /// A table within; null if absent or no table.
  const toml::table* table(std::string_view key);
  const toml::node* node(std::string_view key);
  /// The tables of an array [[key]]; empty if absent.
  std::vector<const toml::table*> tables(std::string_view key);

  /// Reports a key that must be there. @param example a line that would do
  void require(bool present, std::string_view key, const std::string& example);
  /// Reports every key that nobody asked for, with the nearest that exists.
  void finish();

  std::string full(std::string_view key) const;
  int line_of(std::string_view key);

 private:
  std::optional<CycleTarget> target(std::string_view key, const Range& range);
  std::optional<CycleTarget> timed_target(const toml::array& rows, const std::string& name,
                                          const Range& range);
  std::optional<double> checked(const toml::node& node, const std::string& name,
                                const Range& range);

  const toml::table* table_;
  std::string prefix_;
  Problems& problems_;
  std::map<std::string, int>& lines_;
  std::vector<std::string> known_;
};

}  // namespace legwright
