// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <stdexcept>

namespace legwright {

/// A file or folder that cannot be used as asked, told so that it can be mended. Exit code 3.
class IoError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace legwright
