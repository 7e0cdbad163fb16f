// SPDX-License-Identifier: Apache-2.0
#include "benchmarks/cases.hpp"

#include <algorithm>

namespace legwright::bench {
namespace {

constexpr double kSmallStep = 20.0, kLargeStep = 60.0;  // [ms]

}  // namespace

std::vector<Case> cases(const std::filesystem::path& examples,
                        const std::filesystem::path& robots) {
  std::vector<Case> out{
      {"puppy, sideways", examples / "puppy/sideways.toml", PaperRow{614, 6207, 32, 107.66}, 1.0,
       kSmallStep},
      {"hexapod, tripod", examples / "hexapod/tripod_0.4.toml", PaperRow{1044, 5013, 53, 97.47},
       1.0, kLargeStep},
      {"quadruped, pace and sideways", examples / "quadruped/both.toml",
       PaperRow{1050, 14873, 100, 124.47}, 3.0, kSmallStep},
  };
  if (robots.empty()) return out;
  const std::size_t given = out.size();
  for (const auto& folder : std::filesystem::directory_iterator(robots))
    if (exists(folder.path() / "task.toml"))
      out.push_back({folder.path().filename().string(), folder.path() / "task.toml", std::nullopt,
                     1.5, kLargeStep});
  std::sort(out.begin() + static_cast<std::ptrdiff_t>(given), out.end(),
            [](const Case& a, const Case& b) { return a.label < b.label; });
  return out;
}

}  // namespace legwright::bench
