// SPDX-License-Identifier: Apache-2.0
#include "tools/choose/planned_objective.hpp"

#include <utility>

namespace legwright {

PlannedObjective::PlannedObjective(Morphology morphology, const DesignSpace& space, Task task)
    : morphology_(std::move(morphology)), space_(space), task_(std::move(task)) {}

std::shared_ptr<const Objective> PlannedObjective::get() const {
  const std::lock_guard lock(mutex_);
  std::shared_ptr<const Objective> objective = built_.lock();
  if (!objective) {
    objective = std::make_shared<const Objective>(morphology_, space_, task_);
    built_ = objective;
  }
  return objective;
}

}  // namespace legwright
