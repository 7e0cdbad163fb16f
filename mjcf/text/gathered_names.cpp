// SPDX-License-Identifier: Apache-2.0
#include "mjcf/text/gathered_names.hpp"

#include <fmt/format.h>

#include <iterator>
#include <set>
#include <string>
#include <system_error>

#include "mjcf/text/names_of_runs.hpp"
#include "mjcf/text/safe_path.hpp"

namespace legwright {
namespace {

namespace fs = std::filesystem;

/// Letters of both cases are one, as some file systems have it.
std::string without_case(const fs::path& path) {
  std::string out = path.generic_string();
  for (char& c : out)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return out;
}

/// The files and folders that a copy of the robot has.
class TakenNames {
 public:
  void take(const fs::path& file) {
    files_.insert(without_case(file));
    for (fs::path above = file.parent_path(); !above.empty(); above = above.parent_path())
      folders_.insert(without_case(above));
  }
  /// Whether files may lie in a folder of this name; empty: that of the main file.
  bool may_be_folder(const fs::path& folder) const {
    if (folder.empty()) return true;
    if (is_name_of_runs(folder.begin()->string())) return false;
    for (fs::path own = folder; !own.empty(); own = own.parent_path())
      if (files_.count(without_case(own)) > 0) return false;
    return true;
  }
  bool may_be_file(const fs::path& file) const {
    return !is_name_of_runs(file.begin()->string()) && files_.count(without_case(file)) == 0 &&
           folders_.count(without_case(file)) == 0;
  }

 private:
  std::set<std::string> files_, folders_;
};

/// The path with another first step.
fs::path replaced(const fs::path& path, const fs::path& first) {
  fs::path out = first;
  for (auto step = std::next(path.begin()); step != path.end(); ++step) out /= *step;
  return out;
}

/// The name that is asked for first.
fs::path wished_name(const fs::path& path, bool included) {
  const fs::path own = included ? "parts" : "assets";
  if (path.is_absolute()) return own / path.filename();
  fs::path out;
  for (const fs::path& step : path)
    if (step != "..") out /= step;
  const std::string first = out.begin()->string();  // no name of runs begins like this
  return is_name_of_runs(first) ? replaced(out, "robot_" + first) : out;
}

fs::path first_free(const fs::path& wished, const TakenNames& taken) {
  const fs::path first = *wished.begin(), last = wished.filename();
  fs::path folder = wished.parent_path();
  for (int k = 2; !taken.may_be_folder(folder); ++k)
    folder = replaced(wished, fmt::format("{}-{}", first.string(), k)).parent_path();
  fs::path out = folder / last;
  for (int k = 2; !taken.may_be_file(out); ++k)
    out = folder / fmt::format("{}-{}{}", last.stem().string(), k, last.extension().string());
  return out;
}

}  // namespace

bool needed_by_runs(const fs::path& path) { return is_name_of_runs(path.begin()->string()); }

std::map<fs::path, fs::path> gathered_names(const std::vector<FileMention>& mentions,
                                            std::size_t includes) {
  std::map<fs::path, fs::path> names, of_assets;  // by path, by the file behind links
  TakenNames taken;
  for (const FileMention& mention : mentions) {
    if (path_below(mention.path).empty() || needed_by_runs(mention.path)) continue;
    names.emplace(mention.path, mention.path);
    taken.take(mention.path);
  }
  for (std::size_t k = 0; k < mentions.size(); ++k) {
    const FileMention& mention = mentions[k];
    if (names.count(mention.path) > 0) continue;
    std::error_code gone;  // since it was read: then its own path tells it from others
    const fs::path target = fs::weakly_canonical(mention.source, gone);
    const bool included = k < includes;
    if (const auto known = of_assets.find(target); !included && known != of_assets.end()) {
      names.emplace(mention.path, known->second);
      continue;
    }
    const fs::path name = first_free(wished_name(mention.path, included), taken);
    taken.take(name);
    names.emplace(mention.path, name);
    if (!included) of_assets.emplace(target, name);
  }
  return names;
}

}  // namespace legwright
