// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "tools/validate/junit.hpp"

namespace legwright {

/// The file that --junit names. From the first moment on it says that there is no verdict, until
/// there is one: that of an earlier run would be published as this one's, however this one ends.
class JunitFile {
 public:
  /// Nothing is written where no path was given. Throws, before anything is played, IoError where
  /// there is no folder to write into, InputError where the file that is there is no JUnit XML: it
  /// is somebody's.
  /// @param suite what a run is called in the file
  JunitFile(std::filesystem::path path, std::string suite);
  void write(const std::vector<JunitSuite>& suites);
  /// Why there is no verdict, unless there is one; what cannot be written is passed over.
  void write_error(const std::string& message) const noexcept;
  const std::string& suite() const { return suite_; }

 private:
  std::filesystem::path path_;
  std::string suite_;
  bool has_verdict_ = false;
};

}  // namespace legwright
