// SPDX-License-Identifier: Apache-2.0
#include "tools/verbs/matrix_table.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace legwright {
namespace {

constexpr std::size_t kCell = 18;  // of F, its sign and exponent, and the verdict

}  // namespace

std::string matrix_table(const MatrixRecord& matrix) {
  const std::string title = "F and verdict at three gains";
  std::size_t names = title.size();
  for (const MatrixDesignRecord& design : matrix.designs)
    names = std::max(names, std::string("  body ").size() + design.name.size());
  std::string text = fmt::format("{:{}}", title, names);
  for (const auto& [task, cells] : matrix.cells)
    text += fmt::format("  {:>{}}", task, std::max(kCell, task.size()));
  text += '\n';
  for (std::size_t k = 0; k < matrix.designs.size(); ++k) {
    text += fmt::format("{:{}}", "  body " + matrix.designs[k].name, names);
    for (const auto& [task, cells] : matrix.cells) {
      const std::string cell =
          fmt::format("{:.4g} {:>6}", cells[k].F, cells[k].pass ? "PASS" : "FAIL");
      text += fmt::format("  {:>{}}", cell, std::max(kCell, task.size()));
    }
    text += '\n';
  }
  return text;
}

}  // namespace legwright
