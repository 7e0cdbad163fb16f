// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <random>
#include <string>

namespace legwright::test {

/// A robot that somebody changed carelessly: one to three changes of attributes, names, elements or
/// declarations, well-formed XML again. The same text and the same state of `random` give the same.
std::string mutated_robot(const std::string& xml, std::mt19937& random);

}  // namespace legwright::test
