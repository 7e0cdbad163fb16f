// SPDX-License-Identifier: Apache-2.0
#include "mjcf/urdf/urdf_meshes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <string_view>
#include <system_error>
#include <vector>

#include "mjcf/text/listed.hpp"

namespace legwright {
namespace {

namespace fs = std::filesystem;

constexpr int kFoldersAbove = 8;  // the URDF in which a package is looked for

bool is_file(const fs::path& path) {
  std::error_code error;
  return fs::is_regular_file(path, error);
}

/// What stands behind a scheme; nothing for a text without it.
std::optional<std::string> behind(std::string_view scheme, const std::string& name) {
  if (!name.starts_with(scheme)) return std::nullopt;
  return name.substr(scheme.size());
}

/// Between folders CAD programs of Windows write backslashes.
std::string with_slashes(std::string name) {
  std::replace(name.begin(), name.end(), '\\', '/');
  return name;
}

/// The URDF's folder and those above it, in which packages are looked for.
std::vector<fs::path> folders_of_packages(const fs::path& folder) {
  std::vector<fs::path> out;
  fs::path above = fs::absolute(folder).lexically_normal();
  if (!above.has_filename()) above = above.parent_path();
  for (int k = 0; k < kFoldersAbove && above.has_relative_path(); ++k) {
    out.push_back(above);
    above = above.parent_path();
  }
  return out;
}

/// Where a file of a package can be, the likeliest first.
std::vector<fs::path> places_in_package(const std::string& in_package, const fs::path& folder) {
  const std::size_t slash = in_package.find('/');
  if (slash == std::string::npos) return {folder / in_package};  // a file without its package
  const std::string package = in_package.substr(0, slash);
  const fs::path rest = in_package.substr(slash + 1);
  std::vector<fs::path> named, beside, loose;
  for (const fs::path& above : folders_of_packages(folder)) {
    if (above.filename() == package) named.push_back(above / rest);
    beside.push_back(above / package / rest);
    loose.push_back(above / rest);
  }
  named.insert(named.end(), beside.begin(), beside.end());
  named.insert(named.end(), loose.begin(), loose.end());
  return named;
}

/// PACKAGE/REST of a path in a package; nothing for others.
std::optional<std::string> path_in_package(const std::string& name) {
  if (auto in_package = behind_find_of_xacro(name)) return in_package;
  for (const char* scheme : {"package://", "model://"})
    if (auto in_package = behind(scheme, name)) return in_package;
  return std::nullopt;
}

std::vector<fs::path> places_of(const std::string& name, const fs::path& folder,
                                const std::string& mesh_folder) {
  if (const auto in_package = path_in_package(name)) return places_in_package(*in_package, folder);
  const std::string plain_name = behind("file://", name).value_or(name);
  const fs::path plain = plain_name;
  std::vector<fs::path> out{folder / mesh_folder / plain, folder / plain,
                            folder / mesh_folder / plain.filename()};
  // An expanded $(find PKG) is a path of the machine that it was expanded on.
  constexpr std::string_view kShare = "/share/";
  const std::size_t share = plain_name.rfind(kShare);
  if (plain.is_absolute() && share != std::string::npos) {
    const auto more = places_in_package(plain_name.substr(share + kShare.size()), folder);
    out.insert(out.end(), more.begin(), more.end());
  }
  return out;
}

/// In small letters.
std::string ending_of(const fs::path& file) {
  std::string ending = file.extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return ending;
}

bool is_read_by_mujoco(const fs::path& file) {
  const std::string ending = ending_of(file);
  return ending == ".stl" || ending == ".obj" || ending == ".msh";
}

/// From the folder where it lies below, else as it is.
std::string seen_from(const fs::path& folder, const fs::path& file) {
  if (!file.is_absolute()) return file.lexically_relative(folder).generic_string();
  const fs::path home = fs::absolute(folder).lexically_normal();
  return file.lexically_relative(home).generic_string();
}

bool differ_in_case_alone(std::string_view a, std::string_view b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](unsigned char x, unsigned char y) {
    return std::tolower(x) == std::tolower(y);
  });
}

/// A path that is there, of folders and a file that are called so but for capitals; empty: none.
fs::path path_in_other_case(const fs::path& wanted) {
  constexpr int kMostEntries = 10000;  // of a folder, which may be any
  fs::path found;
  for (const fs::path& part : wanted) {
    std::error_code error;
    if (found.empty() || fs::exists(found / part, error)) {
      found /= part;
      continue;
    }
    fs::path next;
    int looked_at = 0;
    for (fs::directory_iterator each(found, error), end; !error && each != end;
         each.increment(error)) {
      if (++looked_at > kMostEntries) break;
      const fs::path name = each->path().filename();
      if (differ_in_case_alone(name.string(), part.string()) && (next.empty() || name < next))
        next = name;
    }
    if (next.empty()) return {};
    found /= next;
  }
  return is_file(found) ? found : fs::path();
}

}  // namespace

std::optional<std::string> behind_find_of_xacro(const std::string& name) {
  const std::string path = with_slashes(name);
  const auto begun = behind("$(find ", behind("file://", path).value_or(path));
  if (!begun) return std::nullopt;
  const std::size_t end = begun->find(")/");
  if (end == std::string::npos) return std::nullopt;
  return begun->substr(0, end) + begun->substr(end + 1);
}

bool is_collada(const std::string& name) { return ending_of(name) == ".dae"; }

UrdfMeshFile find_urdf_mesh(const std::string& name, const fs::path& folder,
                            const std::string& mesh_folder) {
  const fs::path base = folder.empty() ? "." : folder;
  const std::vector<fs::path> places = places_of(with_slashes(name), base, mesh_folder);
  for (const fs::path& place : places) {
    if (is_read_by_mujoco(place)) {
      if (is_file(place)) return {UrdfMeshKind::found, seen_from(base, place)};
      continue;
    }
    for (const char* ending : {".stl", ".obj", ".STL", ".OBJ"})
      if (const fs::path other = fs::path(place).replace_extension(ending); is_file(other))
        return {UrdfMeshKind::other_format, seen_from(base, other)};
  }
  if (is_collada(name))
    for (const fs::path& place : places)
      if (is_file(place)) return {UrdfMeshKind::collada, seen_from(base, place)};
  return {is_read_by_mujoco(name) || is_collada(name) ? UrdfMeshKind::missing
                                                      : UrdfMeshKind::unreadable,
          seen_from(base, places.front())};
}

std::string where_mesh_was_sought(const std::string& name, const fs::path& folder,
                                  const std::string& mesh_folder) {
  const fs::path base = folder.empty() ? "." : folder;
  const std::string path = with_slashes(name);
  const auto in_package = path_in_package(path);
  const std::size_t slash = in_package ? in_package->find('/') : std::string::npos;
  if (slash != std::string::npos) {
    const std::vector<fs::path> folders = folders_of_packages(base);
    const std::string package = in_package->substr(0, slash);
    std::string above;
    if (folders.size() > 1)
      above = fmt::format(" and the {} above it",
                          folders.size() == 2 ? std::string("folder")
                                              : fmt::format("{} folders", folders.size() - 1));
    return fmt::format(
        "package {0} was looked for in the folder {1}{2}: as {0}/REST, and as REST alone", package,
        folders.empty() ? base.string() : folders.front().string(), above);
  }
  std::vector<std::string> folders;
  for (const fs::path& place : places_of(path, base, mesh_folder)) {
    const std::string each = fs::absolute(place).lexically_normal().parent_path().string();
    if (std::find(folders.begin(), folders.end(), each) == folders.end()) folders.push_back(each);
  }
  return fmt::format("its file was looked for in {}", listed(folders, 3));
}

std::string mesh_in_other_case(const std::string& name, const fs::path& folder,
                               const std::string& mesh_folder) {
  const fs::path base = folder.empty() ? "." : folder;
  for (const fs::path& place : places_of(with_slashes(name), base, mesh_folder))
    if (const fs::path found = path_in_other_case(place.lexically_normal()); !found.empty())
      return seen_from(base, found);
  return "";
}

}  // namespace legwright
