// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>

namespace legwright {

/// A robot's label with what tells sessions of one robot apart: "puppy, sideways trot" of a task
/// file, "puppy, run found" of a run.
std::string session_name(const std::string& label, const std::filesystem::path& origin);

/// "2026-03-01 14:05", now and here.
std::string clock_words();

}  // namespace legwright
