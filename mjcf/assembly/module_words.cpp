// SPDX-License-Identifier: Apache-2.0
#include "mjcf/assembly/module_words.hpp"

#include <fmt/format.h>

#include "mjcf/text/numbers.hpp"

namespace legwright {
namespace {

std::string attachment_words(const Attachment& at, const ModulePlace& place) {
  Eigen::Matrix<double, 6, 1> numbers;
  numbers << place.point(at.position), place.direction(at.normal);
  for (double& number : numbers)
    if (number == 0.0) number = 0.0;  // no negative zero
  return fmt::format(" | {} {}: {}", at.on_horn ? "horn" : "body", at.name, rounded_words(numbers));
}

}  // namespace

std::string module_declaration(const Module& module, const ModulePlace& place,
                               std::string_view sort, const std::string& of,
                               const std::string& joint) {
  std::string data = fmt::format("{} {} {} kg | {} {}", module.name, module.kind_name(),
                                 format_number(module.mass), sort, of);
  if (!joint.empty()) data += " | joint " + joint;
  for (const Attachment& at : module.attachments) data += attachment_words(at, place);
  return fmt::format("<text name=\"{}{}\" data=\"{}\"/>", kModulePrefix, of, data);
}

}  // namespace legwright
