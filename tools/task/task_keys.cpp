// SPDX-License-Identifier: Apache-2.0
#include "tools/task/task_keys.hpp"

#include "mjcf/text/input_error.hpp"

namespace legwright {
namespace {

int line_in(const std::map<std::string, int>& lines, const std::string& key) {
  const auto found = lines.find(key);
  if (found != lines.end()) return found->second;
  const auto section =
      lines.find(key.substr(0, key.find('.')));  // the table's line, where the key is absent
  return section != lines.end() ? section->second : 0;
}

}  // namespace

int TaskFile::line(const std::string& key) const { return line_in(lines, key); }

int TaskSet::line(const std::string& key) const { return line_in(lines, key); }

InputError TaskFile::refusal(const std::string& key, const std::string& message) const {
  return InputError(file.string(), line(key), key, message);
}

void TaskFile::refuse(const std::string& key, const std::string& message) const {
  throw refusal(key, message);
}

}  // namespace legwright
