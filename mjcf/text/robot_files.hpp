// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "mjcf/text/file_reach.hpp"
#include "mjcf/text/input_error.hpp"
#include "mjcf/text/robot_parts.hpp"

namespace legwright {

/// The files that a robot consists of, and their one text: the main file with the elements of the
/// included files in the place of the <include> elements, as MuJoCo understands it. All that reads
/// or changes a robot works on that text; here its lines are led back to their files, and a changed
/// text is taken apart into files again.
///
/// Paths start in the folder of the main file, else beside the included file that has them, which
/// text() and includes() then name from the main one. They may lead out of it (find_file()) as far
/// as the reach goes; gathered() brings all files below it. Each file may be included once.
class RobotFiles {
 public:
  RobotFiles() = default;
  /// Throws InputError at the element that names a file which cannot be read, or at a fault in the
  /// XML of one of the files; std::system_error where the disk fails.
  static RobotFiles read(const std::filesystem::path& file, const FileReach& reach = {});
  /// The same from text that is not yet in the main file `file`.
  static RobotFiles from_text(std::string text, const std::filesystem::path& file,
                              const FileReach& reach = {});
  /// The same robot with another text in its main file; all else is read again, as far as before.
  RobotFiles with_main(std::string text) const { return from_text(std::move(text), file_, reach_); }

  const std::filesystem::path& file() const { return file_; }
  /// Of the main file; empty: the current folder.
  std::filesystem::path folder() const { return file_.parent_path(); }
  const std::string& text() const { return text_; }
  const std::string& main_text() const { return parts_.front().text; }
  /// In the order in which they stand in the text; no file twice.
  std::vector<IncludedFile> includes() const { return {parts_.begin() + 1, parts_.end()}; }
  /// By path; no file twice.
  const std::vector<AssetFile>& assets() const { return assets_; }

  /// The files with a changed text: the same elements in the same order, other attributes, and new
  /// mesh assets behind elements (mesh_copies.hpp). Bytes between start tags must be as they are.
  /// Throws std::logic_error where that is not so.
  RobotFiles with_text(const std::string& text) const;
  /// The files as copies have them: each below the folder of the main file, named by its path from
  /// there. Files that lie there already keep their names but where runs have a file of that name
  /// (scene.xml becomes robot_scene.xml), and a robot of such only is as it was.
  /// The model is the same: so are the names that assets get from their files.
  RobotFiles gathered() const;
  /// The gathered files where they were copied to, as `file` and beside it, by somebody who will
  /// not change them: assets may be linked from there.
  RobotFiles moved_to(const std::filesystem::path& file) const;

  /// An error that names a line of text(), told with the file and the line where that stands.
  InputError located(const InputError& error) const;
  /// Does some work on text(); its errors are located.
  template <class Work>
  auto at_their_lines(Work&& work) const {
    try {
      return work();
    } catch (const InputError& error) {
      throw located(error);
    }
  }

 private:
  using PathMap = std::map<std::filesystem::path, std::filesystem::path>;
  struct Place {
    std::filesystem::path file;
    int line = 0;
  };
  Place place_of(int line) const;                             // of a line of text()
  RobotFiles with_attributes(const std::string& text) const;  // with_text without new elements
  void sort_assets();                                         // and leaves each path once
  std::string text_of_gathered(const PathMap& names) const;
  void rename_includes(const PathMap& names);

  std::filesystem::path file_;
  std::vector<IncludedFile> parts_{1};  // the main file first
  std::string text_;
  std::vector<TextSegment> segments_;
  std::vector<AssetFile> assets_;
  std::vector<FileMention> mentions_;  // of each file but the main one, includes first
  FileReach reach_;
  bool gathered_ = true;
};

}  // namespace legwright
