// SPDX-License-Identifier: Apache-2.0
#include "tools/verbs/junit_file.hpp"

#include <utility>

#include "mjcf/text/input_error.hpp"
#include "tools/files/atomic_file.hpp"
#include "tools/files/io_error.hpp"

namespace legwright {

namespace fs = std::filesystem;

JunitFile::JunitFile(fs::path path, std::string suite)
    : path_(std::move(path)), suite_(std::move(suite)) {
  constexpr std::size_t kHead = 400;  // [bytes] within which the root element begins
  if (path_.empty()) return;
  const fs::path folder = path_.parent_path();
  if (!folder.empty() && !fs::is_directory(folder))
    throw IoError("--junit " + path_.string() + ": there is no folder " + folder.string() +
                  "; make it, or name another");
  if (fs::is_directory(path_))
    throw IoError("--junit " + path_.string() + ": is a folder; name a file in it");
  if (fs::exists(path_) && !fs::is_regular_file(path_)) return;  // a pipe gets the verdict alone
  const std::string head = fs::exists(path_) ? read_head(path_, kHead) : "";
  if (!head.empty() && head.find("<testsuite") == std::string::npos)
    throw InputError("--junit " + path_.string() +
                     ": is there and holds something else than JUnit XML; name another file");
  write_file(path_, junit_error_xml(suite_, "the judgement did not come to its end"));
}

void JunitFile::write(const std::vector<JunitSuite>& suites) {
  if (!path_.empty()) write_file(path_, junit_xml(suites));
  has_verdict_ = true;
}

void JunitFile::write_error(const std::string& message) const noexcept {
  if (path_.empty() || has_verdict_) return;
  try {
    write_file(path_, junit_error_xml(suite_, message));
  } catch (const std::exception&) {  // what went wrong is told already
  }
}

}  // namespace legwright
