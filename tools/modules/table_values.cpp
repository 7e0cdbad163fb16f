// SPDX-License-Identifier: Apache-2.0
#include "tools/modules/table_values.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace legwright {

namespace {
constexpr double kLeastDirection = 1e-6;  // shorter ones have none
}

Eigen::Vector3d vector_of(const std::vector<double>& values) {
  return {values[0], values[1], values[2]};
}

bool is_plain_name(std::string_view name, std::string_view others) {
  const auto plain = [&](char c) {
    return (c >= '0' && c <= '9') || (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') || c == '_' ||
           c == '-' || others.find(c) != std::string_view::npos;
  };
  return !name.empty() && name.find("--") == std::string_view::npos &&
         std::all_of(name.begin(), name.end(), plain);
}

std::optional<Eigen::Vector3d> direction_in(TaskTable& in, std::string_view key,
                                            Problems& problems) {
  const auto values = in.numbers(key);
  if (!values) return std::nullopt;
  const Eigen::Vector3d found = vector_of(*values);
  if (found.norm() > kLeastDirection) return found.normalized();
  problems.add(in.line_of(key), in.full(key), "has no length; expected a direction: [0, 1, 0]");
  return std::nullopt;
}

std::optional<std::array<double, 2>> angle_range_in(TaskTable& in, std::string_view key,
                                                    Problems& problems) {
  const auto range = in.numbers(key);
  if (!range) return std::nullopt;
  if ((*range)[0] < (*range)[1]) return std::array{(*range)[0], (*range)[1]};
  problems.add(
      in.line_of(key), in.full(key),
      fmt::format("is [{}, {}]; expected the lesser angle first", (*range)[0], (*range)[1]));
  return std::nullopt;
}

}  // namespace legwright
