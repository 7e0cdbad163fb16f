// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace legwright::test {

/// A quadruped built as robots come out of CAD: few meshes in millimetres (a class scales them),
/// each shown by several legs, turned as their part was drawn; thighs mirrored by a negative scale,
/// shanks oblique to every axis, paws that are meshes and collide, shown a second time as a
/// picture. Front and hind legs have lengths of their own; the trunk has one, too.
std::string mesh_quadruped();

}  // namespace legwright::test
