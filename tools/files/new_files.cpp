// SPDX-License-Identifier: Apache-2.0
#include "tools/files/new_files.hpp"

#include <system_error>

#include "tools/files/atomic_file.hpp"
#include "tools/files/io_error.hpp"

namespace legwright {
namespace {

namespace fs = std::filesystem;

/// What has been made, taken away again unless it is kept.
class MadeFiles {
 public:
  MadeFiles() = default;
  MadeFiles(const MadeFiles&) = delete;
  MadeFiles& operator=(const MadeFiles&) = delete;
  ~MadeFiles() {
    std::error_code ignored;  // a folder in which something else stands by now stays
    for (auto path = made_.rbegin(); path != made_.rend(); ++path) fs::remove(*path, ignored);
  }

  void folders(const fs::path& folder) {
    if (folder.empty() || fs::is_directory(folder)) return;
    folders(folder.parent_path());
    if (fs::create_directory(folder)) made_.push_back(folder);
  }

  void file(const NewFile& file) {
    write_file(file.path, file.text);
    made_.push_back(file.path);
  }

  void keep() { made_.clear(); }

 private:
  std::vector<fs::path> made_;
};

}  // namespace

bool same_place(const fs::path& a, const fs::path& b) {
  return fs::weakly_canonical(fs::absolute(a)) == fs::weakly_canonical(fs::absolute(b));
}

void refuse_existing(const fs::path& path) {
  if (fs::exists(fs::symlink_status(path)))
    throw IoError(path.string() + ": exists already; name a new file, or remove it");
}

void write_new_files(const std::vector<NewFile>& files, const std::function<void()>& and_then) {
  for (const NewFile& file : files) refuse_existing(file.path);
  MadeFiles made;
  for (const NewFile& file : files) {
    made.folders(fs::absolute(file.path).lexically_normal().parent_path());
    made.file(file);
  }
  and_then();
  made.keep();
}

}  // namespace legwright
