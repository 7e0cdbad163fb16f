// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <mutex>

#include "optimizer/objective/objective.hpp"

namespace legwright {

/// F of a task that a search tightened. It is built when it is asked for and lives as long as
/// somebody holds it: a search comes by up to a hundred of them. The same each time.
class PlannedObjective {
 public:
  /// @param morphology of the robot as it is in the task
  PlannedObjective(Morphology morphology, const DesignSpace& space, Task task);

  const Task& task() const { return task_; }
  std::shared_ptr<const Objective> get() const;

 private:
  Morphology morphology_;
  DesignSpace space_;
  Task task_;
  mutable std::mutex mutex_;
  mutable std::weak_ptr<const Objective> built_;
};

}  // namespace legwright
