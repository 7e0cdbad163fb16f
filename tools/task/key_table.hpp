// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "tools/task/toml_reader.hpp"

namespace legwright {

/// What a key's value may look like.
enum class KeyKind {
  text,
  number,
  integer,
  numbers,     // a list of `count` numbers; 0 for any number but none
  pairs,       // a list of lists of two numbers
  target,      // values over the cycle: evenly spaced, or pairs of phase and value
  names,       // a list of texts
  name_pairs,  // a list of lists of two texts
  tables,      // an array of tables
};

struct KeyForm {
  KeyKind kind;
  Range range;  // of each number, with its unit
  std::size_t count = 0;
};

/// Where a key may stand in a file of several tasks.
enum class KeyScope {
  file,    // once, outside [[task]]
  shared,  // outside [[task]], for all tasks that do not say otherwise, or within one
  task,    // within each [[task]]
  both,    // outside and within, each for itself
};

/// One key of a task file, or of another file that is read by a table of keys: what the reader
/// takes for it, and what the reference says of it.
struct TaskKey {
  /// Path with dots. A last word in capitals stands for a name of the user's: "weights.TERM".
  std::string_view path;
  std::vector<KeyForm> forms;
  KeyScope scope;
  std::string_view fallback;  // what holds without it; starts with "needed" where nothing does
  std::string_view example;   // its value, as TOML
  std::string_view meaning;

  /// The table that it stands in: "gait", "style.foot_heights.FOOT", or empty.
  std::string_view table() const;
};

/// Every key of a task file, in the order of the reference. The reader takes its ranges from here
/// and reads no key that is not in it.
const std::vector<TaskKey>& task_keys();

/// The row of a key among `keys`, of a table given by its own path there; null where there is none.
/// A name of the user's is found by the row whose last word is in capitals.
const TaskKey* find_key(const std::vector<TaskKey>& keys, std::string_view table,
                        std::string_view key);
/// The same of a task file.
const TaskKey* find_task_key(std::string_view table, std::string_view key);

/// Whether keys stand below this path: "style.foot_heights".
bool has_keys(const std::vector<TaskKey>& keys, std::string_view table);

/// "number", "list of 2 numbers", …
std::string form_text(const KeyForm& form);
/// "0.05 <= value <= 20", or empty where every finite number will do.
std::string bounds_text(const KeyForm& form);

}  // namespace legwright
