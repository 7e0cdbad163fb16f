// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>

namespace legwright {

/// Draws a robot that stands in its keyframe `home` (else its first, else the reference pose), from
/// the front left and above, 960 by 720 pixels. Throws GlError where nothing can be drawn,
/// InputError where MuJoCo refuses the scene, std::system_error for files.
/// @param origin a text that the file carries (image/picture_origin)
void draw_portrait(const std::filesystem::path& scene, const std::filesystem::path& png,
                   const std::string& origin = {});

}  // namespace legwright
