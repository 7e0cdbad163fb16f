// SPDX-License-Identifier: Apache-2.0
#include "tools/session/search.hpp"

#include <algorithm>
#include <utility>

namespace legwright {
namespace {

using Eigen::VectorXd;

JointPoint point_of(const DesignIteration& iteration) {
  JointPoint point{iteration.s, {}, iteration.value};
  for (const TaskIterate& task : iteration.tasks) point.motions.push_back(task.m);
  return point;
}

/// Algorithm 1 from a body whose motions are nearly solved; where J is, it counts at once.
CodesignOptions bilevel_rules(const std::vector<WeightedCost>& tasks, const SearchRules& rules) {
  CodesignOptions options;
  options.method = DesignMethod::newton;
  options.near_optimum =
      std::any_of(tasks.begin(), tasks.end(), [](const WeightedCost& task) { return task.outer; });
  options.threads = rules.threads;
  options.go_on = options.newton.go_on = [stop = rules.stop] { return !stop(); };
  return options;
}

class Search {
 public:
  Search(const std::vector<WeightedCost>& tasks, const DesignSpace& space, const SearchRules& rules)
      : tasks_(tasks), space_(space), rules_(rules) {}

  SearchEnd run(VectorXd s) {
    search_jointly(s);
    if (!over()) search_by_steps(s);
    if (over()) end_.status = SolveStatus::stopped;
    return end_;
  }

 private:
  bool over() const { return rules_.stop() || (rules_.most > 0 && end_.points >= rules_.most); }
  void tell(const JointPoint& point) {
    if (over()) return;
    ++end_.points;
    rules_.tell(point);
  }

  /// @param s design, and the best afterwards
  void search_jointly(VectorXd& s) {
    JointNewtonOptions options;
    options.threads = rules_.threads;
    options.go_on = [this] { return !over(); };
    options.on_step = [this](const JointPoint& point) { tell(point); };
    std::vector<VectorXd> motions;
    for (const WeightedCost& task : tasks_) motions.push_back(task.initial_motion);
    const JointNewtonResult found = joint_newton(
        tasks_, {space_.lower(), space_.upper(), space_.scale()}, s, {motions}, options);
    end_.status = found.status;
    if (found.path.empty()) return;  // F is not finite
    s = found.best().s;
    for (std::size_t k = 0; k < tasks_.size(); ++k)
      tasks_[k].initial_motion = found.best().motions[k];
  }

  void search_by_steps(const VectorXd& s) {
    CodesignOptions options = bilevel_rules(tasks_, rules_);
    options.on_iteration = [this](const DesignIteration& iteration) {
      tell(point_of(iteration));
      return !over();
    };
    const CodesignResult found = codesign(tasks_, space_, s, options);
    end_.status = found.status;
    if (!over() && !found.best.tasks.empty()) tell(point_of(found.best));  // to the last digit
  }

  std::vector<WeightedCost> tasks_;
  const DesignSpace& space_;
  const SearchRules& rules_;
  SearchEnd end_;
};

}  // namespace

SearchEnd search_on(const std::vector<WeightedCost>& tasks, const DesignSpace& space,
                    const VectorXd& s, const SearchRules& rules) {
  return Search(tasks, space, rules).run(s);
}

JointPoint step_on(const std::vector<WeightedCost>& tasks, const DesignSpace& space,
                   const VectorXd& s, const SearchRules& rules) {
  CodesignOptions options = bilevel_rules(tasks, rules);
  options.max_iterations = 1;
  const CodesignResult found = codesign(tasks, space, s, options);
  if (rules.stop() || found.design_iterations == 0) return {};
  return point_of(found.best);
}

}  // namespace legwright
