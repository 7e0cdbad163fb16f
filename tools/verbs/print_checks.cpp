// SPDX-License-Identifier: Apache-2.0
#include "tools/verbs/print_checks.hpp"

#include <fmt/format.h>
#include <stdlib.h>

#include <algorithm>
#include <system_error>
#include <utility>
#include <vector>

#include "mjcf/assembly/assembly_names.hpp"
#include "mjcf/text/input_error.hpp"
#include "tools/files/atomic_file.hpp"
#include "tools/files/io_error.hpp"
#include "tools/files/json_file.hpp"
#include "tools/verbs/python_module.hpp"
#include "tools/verbs/viewer_programs.hpp"

namespace legwright {
namespace {

namespace fs = std::filesystem;

/// A folder of its own, gone with this.
class PassingFolder {
 public:
  PassingFolder() {
    std::string name = (fs::temp_directory_path() / "legwright-XXXXXX").string();
    if (!::mkdtemp(name.data())) throw IoError("cannot make a folder " + name);
    path_ = name;
  }
  ~PassingFolder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  PassingFolder(const PassingFolder&) = delete;
  PassingFolder& operator=(const PassingFolder&) = delete;

  const fs::path& path() const { return path_; }

 private:
  fs::path path_;
};

/// Checks of mirror images and copies that fail alike.
struct AlikeChecks {
  int line = 0;
  std::string key, name, words;
  std::size_t count = 0;
};

/// Where of the assembly a check is mended: the table of its link, of what rides on the trunk, or
/// of the trunk.
std::pair<int, std::string> place_of(const Assembly& assembly, const std::string& part,
                                     const std::string& check) {
  for (std::size_t k = 0; k < assembly.parts.size(); ++k)
    if (check.ends_with(" " + part_name(assembly.parts[k], k)))
      return {assembly.parts[k].line, "part.module"};
  for (const PlacedLimb& limb : placed_limbs(assembly))
    for (const AssemblyJoint& joint : limb.of->joints)
      if (part == link_name(limb, joint)) return {joint.line, "limb.joint"};
  if (part == "trunk") return {assembly.trunk_line, "trunk"};
  return {0, "print"};
}

/// What is checked, of whichever limb: "edge of holes, FL_hip_servo horn" is "edge of holes".
std::string sort_of(const std::string& check) {
  const auto end = check.find_first_of(',');
  if (end != std::string::npos) return check.substr(0, end);
  for (const char* const head : {"reaches the horn", "reaches", "range", "axis", "middle"})
    if (check.starts_with(head)) return head;
  return check;
}

std::string words_of_check(const Json& check) {
  std::string out = check["part"].get<std::string>();
  if (!out.empty()) out += ": ";
  out += check["name"].get<std::string>();
  if (check["figure"].is_number())
    out +=
        fmt::format(": {:.3g} {}", check["figure"].get<double>(), check["unit"].get<std::string>());
  out += fmt::format(", expected {}", check["limit"].get<std::string>());
  const std::string where = check["where"].get<std::string>();
  if (!where.empty()) out += fmt::format(" ({})", where);
  return out + "; " + check["remedy"].get<std::string>();
}

std::vector<AlikeChecks> alike_checks(const Assembly& assembly, const Json& failed) {
  std::vector<AlikeChecks> out;
  for (const Json& check : failed) {
    const std::string name = check["name"].get<std::string>(), sort = sort_of(name);
    if (sort == "size on the bed") continue;
    const auto [line, key] = place_of(assembly, check["part"].get<std::string>(), name);
    const auto is_alike = [&, at = line](const AlikeChecks& each) {
      return each.line == at && each.name == sort;
    };
    auto found = std::find_if(out.begin(), out.end(), is_alike);
    if (found == out.end())
      found = out.insert(out.end(), {line, key, sort, words_of_check(check), 0});
    ++found->count;
  }
  return out;
}

}  // namespace

std::string refuse_unprintable(const Assembly& assembly, const std::string& xml,
                               const fs::path& file) {
  if (!assembly.print) return "";
  const PythonFound python = look_for_python(parts_part());
  if (python.python.empty())
    return fmt::format(
        "whether walls, holes and what parts hold pass the checks of `legwright parts` is not "
        "looked at, as {}: {}",
        python.lacks, python_cure(parts_part()));
  const PassingFolder folder;
  const fs::path robot = folder.path() / "robot.xml";
  write_file(robot, xml);
  std::string told;
  run_command({python.python, "-P", "-m", parts_part().module, "--failed", robot.string()}, &told);
  const Json failed = Json::parse(told, nullptr, false);
  if (!failed.is_array())
    return "`legwright parts` could not look at its parts as drawn: run it on the robot";
  std::vector<InputError> reasons;
  for (const AlikeChecks& each : alike_checks(assembly, failed))
    reasons.emplace_back(
        file.string(), each.line, each.key,
        fmt::format("with [print] `legwright parts` would refuse it as drawn: {}{}", each.words,
                    each.count > 1 ? fmt::format(" ({} such parts)", each.count) : ""));
  if (!reasons.empty()) throw InputError(std::move(reasons));
  return "";
}

}  // namespace legwright
