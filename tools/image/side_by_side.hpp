// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tools/image/image.hpp"

namespace legwright {

/// Before | after | difference: what differs is red on a pale copy. Of pictures of other sizes
/// before | after, with grey around the smaller one.
Image side_by_side(const Image& before, const Image& after);

}  // namespace legwright
