// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tools/image/image.hpp"

namespace legwright {

/// Before | after | difference: what differs is red on a pale copy. Both are of one size.
Image side_by_side(const Image& before, const Image& after);

}  // namespace legwright
