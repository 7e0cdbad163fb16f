// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "tests/plugin/engine.hpp"

namespace legwright {

/// A robot that mjs_attach puts into a scene.
struct Attached {
  std::string xml;
  std::string prefix, suffix;
};

/// Compiles a world of robots, with the options of the toy walker.
/// @param outer prefix with which that world is itself attached to another; empty: it is not
Loaded attach(const std::vector<Attached>& robots, const std::string& outer = "");

}  // namespace legwright
