// SPDX-License-Identifier: Apache-2.0
#include "python/core/iteration.hpp"

namespace legwright {

PythonIteration python_iteration(const CodesignProblem& problem, const RunLabel& label,
                                 const DesignIteration& iteration) {
  PythonIteration out;
  out.index = iteration.index;
  out.start = label.start;
  out.value = iteration.value;
  out.s = iteration.s;
  out.projected_gradient_norm = iteration.projected_gradient_norm;
  out.seconds = iteration.seconds;
  for (std::size_t k = 0; k < label.tasks.size(); ++k) {
    const TaskFile& task = problem.task(label.tasks[k]);
    const double weight = label.tasks.size() > 1 ? task.weight : 1.0;  // alone it counts by itself
    out.tasks.push_back(task.name);
    for (const TermValue& term : iteration.tasks[k].terms)
      out.terms[std::string(term.name)] += weight * term.value;
  }
  return out;
}

}  // namespace legwright
