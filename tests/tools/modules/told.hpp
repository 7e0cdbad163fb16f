// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <string>

namespace legwright::test {

/// Expects a part in what was told.
inline void expect_told(const std::string& told, const std::string& part) {
  EXPECT_NE(told.find(part), std::string::npos) << part << " in\n" << told;
}

}  // namespace legwright::test
