// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "tools/validate/junit.hpp"

namespace legwright {

/// The file that --junit names. It is there whatever comes of the judgement: one of an earlier run
/// that stays would be published as this one's.
class JunitFile {
 public:
  /// Nothing is written where no path was given. Throws InputError, before anything is played,
  /// where the folder is missing or the file that is there is no JUnit XML: it is somebody's.
  explicit JunitFile(std::filesystem::path path);
  void write(const std::vector<JunitSuite>& suites) const;
  /// An error in the place of the verdict; what cannot be written is passed over.
  void write_error(const std::string& suite, const std::string& message) const noexcept;

 private:
  std::filesystem::path path_;
};

}  // namespace legwright
