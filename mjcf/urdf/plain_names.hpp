// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <fmt/format.h>

#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "mjcf/read/tree_checks.hpp"
#include "mjcf/text/unused_name.hpp"

namespace legwright {

/// Names without the signs that trajectories cannot name, each its own: "Revolute 12" becomes
/// "Revolute_12". Those without such signs stay.
class PlainNames {
 public:
  explicit PlainNames(const std::vector<std::string>& all) {
    for (const std::string& name : all)
      if (is_plain(name)) taken_.insert(name);
  }
  std::string operator()(const std::string& name) {
    if (is_plain(name)) return name;
    const auto known = plain_.find(name);
    if (known != plain_.end()) return known->second;
    std::string stem = name;
    for (char& c : stem)
      if (std::string_view(kNoNameSigns).find(c) != std::string_view::npos) c = '_';
    const std::string out =
        unused_name(stem, [this](const std::string& each) { return !taken_.insert(each).second; });
    if (renamed_.empty()) renamed_ = fmt::format("'{}' as '{}'", name, out);
    return plain_[name] = out;
  }
  /// The first one that was changed, in words; empty: none was.
  const std::string& renamed() const { return renamed_; }

 private:
  static bool is_plain(const std::string& name) {
    return name.find_first_of(kNoNameSigns) == std::string::npos;
  }

  std::map<std::string, std::string> plain_;
  std::set<std::string> taken_;
  std::string renamed_;
};

}  // namespace legwright
