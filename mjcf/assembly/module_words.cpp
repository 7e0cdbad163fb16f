// SPDX-License-Identifier: Apache-2.0
#include "mjcf/assembly/module_words.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>

#include "mjcf/read/declared_modules.hpp"
#include "mjcf/text/numbers.hpp"

namespace legwright {
namespace {

constexpr double kGrainsPerMetre = 1e12;  // per m

std::string attachment_words(const Attachment& at, const ModulePlace& place) {
  Eigen::VectorXd numbers(6 + 3 * static_cast<Eigen::Index>(at.holes.size()));
  numbers.head<6>() << place.point(at.position), place.direction(at.normal);
  for (std::size_t k = 0; k < at.holes.size(); ++k)
    numbers.segment<3>(6 + 3 * static_cast<Eigen::Index>(k)) = place.point(at.holes[k]);
  for (double& number : numbers) {
    number = std::round(number * kGrainsPerMetre) / kGrainsPerMetre;
    if (number == 0.0) number = 0.0;  // no negative zero
  }
  return fmt::format(" | {} {}{}: {}", at.on_horn ? "horn" : "body", at.name,
                     at.holes.empty() ? "" : " " + at.screws, rounded_words(numbers));
}

}  // namespace

std::string module_declaration(const Module& module, const ModulePlace& place,
                               std::string_view sort, const std::string& of,
                               const std::string& joint) {
  std::string data = fmt::format("{} {} {} kg | {} {}", module.name, module.kind_name(),
                                 format_number(module.mass), sort, of);
  if (!joint.empty()) data += " | joint " + joint;
  if (module.price) data += " | price " + format_number(*module.price);
  if (!module.cable.empty()) data += fmt::format(" | cable {}", fmt::join(module.cable, " "));
  for (const Attachment& at : module.attachments) data += attachment_words(at, place);
  return fmt::format("<text name=\"{}{}\" data=\"{}\"/>", kModulePrefix, of, data);
}

}  // namespace legwright
