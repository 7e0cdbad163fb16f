// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tools/files/json_file.hpp"
#include "tools/session/alternatives.hpp"

namespace legwright {

/// Designs that may take the place of the one that stands: {what, designs: [{s, weights, task_F,
/// F}]}; of fewest changes also {given_F, fewest, kept, worths: [{name, given, worth}]}, null where
/// a body without a change has no motion.
Json alternatives_json(const Alternatives& all);

}  // namespace legwright
