// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "optimizer/solve/attribution.hpp"
#include "optimizer/solve/put_back.hpp"
#include "tools/run/run_record.hpp"

namespace legwright {

/// run.json's "put_back" of one task, by its own F and J.
/// @param terms of its F
std::vector<PutBackRecord> put_back_records(const std::vector<PutBack>& rows,
                                            const DesignSpace& space,
                                            const std::vector<WeightedCost>& tasks, int task);

/// The same of a joint run: weighted sums, and F of each task by name.
std::vector<PutBackRecord> joint_put_back_records(const std::vector<PutBack>& rows,
                                                  const DesignSpace& space,
                                                  const std::vector<WeightedCost>& tasks,
                                                  const std::vector<std::string>& names);

/// Such records read, largest shares first; none where the run has none.
/// @param task that the shares are labelled with; may be empty @param weight of the shares
std::vector<Attribution> attributions_of(const std::optional<std::vector<PutBackRecord>>& records,
                                         const std::string& task = {}, double weight = 1.0);

}  // namespace legwright
