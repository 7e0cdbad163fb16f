// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace legwright {

/// A Python that has MuJoCo's viewer.
struct ViewerPython {
  std::string command;         // the interpreter
  std::string mujoco_version;  // of its mujoco package
};

/// The first of $LEGWRIGHT_PYTHON, python3 and python that can import mujoco.viewer.
std::optional<ViewerPython> find_viewer_python();

/// What a shell is told to get such a Python with the MuJoCo of this program.
std::string viewer_python_cure();

/// The command that opens a scene in MuJoCo's viewer with the plugin loaded, word by word.
std::vector<std::string> viewer_command(const std::string& python,
                                        const std::filesystem::path& plugin,
                                        const std::filesystem::path& scene);

// Programs with a window, in the folder of `legwright` where GLFW was there to build them.
inline constexpr const char* kViewerProgram = "legwright-viewer";
inline constexpr const char* kSimulateProgram = "simulate";

/// The program of that name in the folder of the running one, or nothing.
std::optional<std::filesystem::path> find_beside(const std::string& program);

/// Whether this program is that of the Python package, whose users have no build tree.
bool is_packaged();
/// What to do where they are missing: build them, or what stands in the way of building them; of a
/// packaged program, which viewer there is instead.
std::string viewer_cure();

/// Runs a command without a shell and waits for it. With `output` it reads nothing, what it prints
/// is appended there and its messages are thrown away; without, it has this program's own stdin,
/// stdout and stderr. @return exit status, −1 where it cannot run
int run_command(const std::vector<std::string>& words, std::string* output = nullptr);

}  // namespace legwright
