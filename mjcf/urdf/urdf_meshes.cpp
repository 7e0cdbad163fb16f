// SPDX-License-Identifier: Apache-2.0
#include "mjcf/urdf/urdf_meshes.hpp"

#include <algorithm>
#include <cctype>
#include <string_view>
#include <system_error>
#include <vector>

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

/// Where a file of a package can be, the likeliest first.
std::vector<fs::path> places_in_package(const std::string& in_package, const fs::path& folder) {
  const std::size_t slash = in_package.find('/');
  if (slash == std::string::npos) return {folder / in_package};  // a file without its package
  const std::string package = in_package.substr(0, slash);
  const fs::path rest = in_package.substr(slash + 1);
  std::vector<fs::path> named, beside, loose;
  fs::path above = fs::absolute(folder).lexically_normal();
  if (!above.has_filename()) above = above.parent_path();
  for (int k = 0; k < kFoldersAbove && above.has_relative_path(); ++k) {
    if (above.filename() == package) named.push_back(above / rest);
    beside.push_back(above / package / rest);
    loose.push_back(above / rest);
    above = above.parent_path();
  }
  named.insert(named.end(), beside.begin(), beside.end());
  named.insert(named.end(), loose.begin(), loose.end());
  return named;
}

std::vector<fs::path> places_of(const std::string& name, const fs::path& folder,
                                const std::string& mesh_folder) {
  if (const auto in_package = behind_find_of_xacro(name))
    return places_in_package(*in_package, folder);
  for (const char* scheme : {"package://", "model://"})
    if (const auto in_package = behind(scheme, name)) return places_in_package(*in_package, folder);
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

}  // namespace legwright
