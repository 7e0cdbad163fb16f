// SPDX-License-Identifier: Apache-2.0
#include "optimizer/solve/checkpoint.hpp"

#include <gtest/gtest.h>

#include <map>
#include <mutex>
#include <stdexcept>

#include "optimizer/solve/fewest_changes.hpp"
#include "optimizer/solve/joint_newton.hpp"
#include "optimizer/solve/multistart.hpp"
#include "optimizer/solve/put_back.hpp"
#include "tests/optimizer/solve/toy_cost.hpp"
#include "tests/support/long_tests.hpp"
#include "tests/support/puppy.hpp"

namespace legwright {
namespace {

using Eigen::VectorXd;

struct Killed : std::runtime_error {
  Killed() : std::runtime_error("killed") {}
};

/// Ends the search, as if its process were killed, at the n-th state that it keeps.
class StoreUntil final : public CheckpointStore {
 public:
  using States = std::map<std::string, std::vector<double>>;
  StoreUntil(States earlier, int last) : kept(earlier), earlier_(std::move(earlier)), left_(last) {}

  std::vector<double> find(const std::string& name) override {
    const auto found = earlier_.find(name);
    return found == earlier_.end() ? std::vector<double>() : found->second;
  }
  double seconds_between() const override { return 0.0; }
  void keep(const std::string& name, const std::vector<double>& state) override {
    const std::lock_guard lock(mutex_);
    if (left_-- == 0) throw Killed();
    kept[name] = state;
    ++count;
  }
  States kept;
  int count = 0;

 private:
  std::mutex mutex_;
  const States earlier_;
  int left_;
};

constexpr int kNever = -1;

/// The states that a search has kept when it is killed at the n-th of them.
template <class Search>
StoreUntil::States states_at(int n, const StoreUntil::States& earlier, const Search& search) {
  StoreUntil store(earlier, n);
  EXPECT_THROW(search(Checkpoint(&store, "run")), Killed);
  return store.kept;
}

/// Kills a search at `kills` moments, each time one that goes on from the last, and expects that
/// the one that is left to its end finds the same; then at so many more, each once.
template <class Search>
void expect_same_after_kills(int kills, int samples, const Search& search) {
  StoreUntil whole({}, kNever);
  const auto expected = search(Checkpoint(&whole, "run"));
  ASSERT_GT(whole.count, kills) << "else the kills are not within it";
  EXPECT_EQ(expected, search(Checkpoint())) << "to keep states changes nothing";
  StoreUntil::States states;
  for (int k = 0; k < kills; ++k) states = states_at(whole.count / (kills + 1), states, search);
  StoreUntil last(states, kNever);
  EXPECT_EQ(expected, search(Checkpoint(&last, "run")));
  EXPECT_LT(last.count, whole.count) << "nothing was gone on from";
  for (int n = 1; n < whole.count; n += 1 + whole.count / samples) {
    StoreUntil once(states_at(n, {}, search), kNever);
    EXPECT_EQ(expected, search(Checkpoint(&once, "run"))) << "killed at state " << n;
  }
}

/// Everything of a result that has no time in it.
std::vector<double> numbers_of(const DesignIteration& design) {
  std::vector<double> out{design.value, design.projected_gradient_norm, design.design_step,
                          static_cast<double>(design.index),
                          static_cast<double>(design.newton_iterations)};
  const auto add = [&](const VectorXd& values) {
    out.insert(out.end(), values.begin(), values.end());
  };
  add(design.s);
  add(design.design_gradient);
  for (const TaskIterate& task : design.tasks) {
    add(task.m);
    out.push_back(task.adjoint_residual);
    out.push_back(static_cast<double>(task.motion_status));
  }
  return out;
}

std::vector<double> numbers_of(const CodesignResult& result) {
  std::vector<double> out = numbers_of(result.best);
  const std::vector<double> initial = numbers_of(result.initial);
  out.insert(out.end(), initial.begin(), initial.end());
  for (const int count :
       {result.design_iterations, result.newton_iterations, result.factorisations,
        result.evaluations, result.rejected_trials, static_cast<int>(result.status)})
    out.push_back(count);
  return out;
}

TEST(SolveState, ReadsWhatItWroteAndNoMore) {
  VectorXd vector = VectorXd::LinSpaced(3, -1.0, 1.0);
  std::vector<double> list{0.1, 0.2};
  std::string words = "größer";
  double number = 1e-300;
  int count = -7;
  bool flag = true;
  SolveStatus status = SolveStatus::stalled;
  SolveState written;
  const auto pass = [&](SolveState& state) {
    state(vector);
    state(list);
    state(words);
    state(number);
    state(count);
    state(flag);
    state(status);
  };
  pass(written);
  const VectorXd before = vector;
  vector.setZero(1);
  list.clear();
  words = "none";
  number = count = 0;
  flag = false;
  status = SolveStatus::converged;
  SolveState read(written.numbers());
  pass(read);
  EXPECT_EQ(vector, before);
  EXPECT_EQ(list, (std::vector<double>{0.1, 0.2}));
  EXPECT_EQ(words, "größer");
  EXPECT_EQ(number, 1e-300);
  EXPECT_EQ(count, -7);
  EXPECT_TRUE(flag);
  EXPECT_EQ(status, SolveStatus::stalled);
  EXPECT_THROW(read(number), std::out_of_range);
}

TEST(Checkpoint, WithoutAStoreKeepsNothing) {
  Checkpoint none;
  EXPECT_FALSE(none.in("a").in(3));
  EXPECT_FALSE(none.due());
  double number = 1.0;
  const auto pass = [&](SolveState& state) { state(number); };
  none.keep(pass);
  EXPECT_FALSE(none.take_up(pass));
}

TEST(Checkpoint, AStateOfAnotherStartIsOfNoUse) {
  toy::CoupledCost cost(toy::kMotionSize, toy::kDesignSize, 7);
  const VectorXd s = toy::box(1.0).initial();
  const auto solve = [&](double first, CheckpointStore* store) {
    NewtonWorkspace workspace;
    NewtonOptions options;
    options.checkpoint = Checkpoint(store, "solve");
    VectorXd m = VectorXd::Constant(toy::kMotionSize, first);
    const SolveReport report = newton(cost, s, m, options, workspace);
    return std::pair(m, report.iterations);
  };
  StoreUntil store({}, kNever);
  (void)solve(0.0, &store);
  StoreUntil other(store.kept, kNever);
  EXPECT_EQ(solve(0.5, &other), solve(0.5, nullptr));
}

/// Several tasks and starts on toys: all ways through multistart, joint search and Algorithm 1.
class Kills : public testing::TestWithParam<DesignMethod> {};

TEST_P(Kills, LeaveASearchFromSeveralStartsAsItWas) {
  toy::CoupledCost first(toy::kMotionSize, toy::kDesignSize, 7),
      second(toy::kMotionSize, toy::kDesignSize, 11);
  const DesignSpace space = toy::box(2.0);
  expect_same_after_kills(3, 12, [&](const Checkpoint& checkpoint) {
    std::vector<JointTask> tasks(2);
    tasks[0] = {"first", &first, nullptr, 0.3, {}};
    tasks[1] = {"second", &second, nullptr, 0.7, {}};
    for (JointTask& task : tasks)
      task.guess = [](const VectorXd&) { return VectorXd::Zero(toy::kMotionSize); };
    MultistartOptions options;
    options.codesign.method = GetParam();
    options.codesign.threads = 2;
    options.codesign.checkpoint = checkpoint;
    options.perturbations = 1;
    const MultistartResult found = codesign_from_starts(tasks, space, options);
    std::vector<double> out;
    for (const auto* runs : {&found.alone, &found.joint})
      for (const StartedRun& run : *runs) {
        const std::vector<double> numbers = numbers_of(run.result);
        out.insert(out.end(), numbers.begin(), numbers.end());
      }
    CodesignOptions rules = options.codesign;
    rules.checkpoint = checkpoint.in("front");
    for (const FrontPoint& point : trade_off_front(tasks, space, found, 2, rules)) {
      const std::vector<double> numbers = numbers_of(point.best);
      out.insert(out.end(), numbers.begin(), numbers.end());
    }
    return out;
  });
}

INSTANTIATE_TEST_SUITE_P(Methods, Kills,
                         testing::Values(DesignMethod::joint, DesignMethod::newton,
                                         DesignMethod::lbfgs));

/// A robot whose steps are damped, bent and cut on the way.
class KillsOfARobot : public testing::Test {
 protected:
  static Objective make_objective() {
    const test::Puppy puppy = test::make_puppy(true);
    return {puppy.morphology, puppy.space, test::make_sideways_task(true, 12)};
  }
  const Objective objective = make_objective();
  const DesignSpace& space = objective.space();
  const VectorXd guess = initial_guess(objective, space.initial());
  ObjectiveCost cost{objective}, of_other_thread{objective};
};

TEST_F(KillsOfARobot, LeaveDampedNewtonStepsAsTheyWere) {
  int shifted = 0;
  expect_same_after_kills(3, 40, [&](const Checkpoint& checkpoint) {
    NewtonWorkspace workspace;
    NewtonOptions options;
    options.checkpoint = checkpoint;
    VectorXd m = guess;
    const SolveReport report = newton(cost, space.initial(), m, options, workspace);
    shifted = report.shifted_steps;
    std::vector<double> out(m.begin(), m.end());
    out.insert(out.end(), report.history.begin(), report.history.end());
    VectorXd solved;
    EXPECT_EQ(workspace.factor.solve(m, solved), report.exact_factor) << "callers go on with it";
    out.insert(out.end(), solved.begin(), solved.end());
    for (const double number :
         {report.value, report.stationarity, report.shift, 1.0 * report.iterations,
          1.0 * report.factorisations, 1.0 * report.evaluations, 1.0 * report.shifted_steps,
          static_cast<double>(report.status)})
      out.push_back(number);
    return out;
  });
  EXPECT_GT(shifted, 3) << "else damping is not told apart";
}

TEST_F(KillsOfARobot, LeaveStepsOfBodyAndMotionAsTheyWere) {
  expect_same_after_kills(2, 8, [&](const Checkpoint& checkpoint) {
    WeightedCost task;
    task.cost = &cost;
    JointNewtonOptions options;
    options.max_iterations = 30;
    options.scout_iterations = 5;
    options.checkpoint = checkpoint;
    const VectorXd other = guess.array() + 0.01;
    const JointNewtonResult found =
        joint_newton({task}, {space.lower(), space.upper(), space.scale()}, space.initial(),
                     {{guess}, {other}}, options);
    std::vector<double> out{1.0 * found.iterations, 1.0 * found.factorisations,
                            1.0 * found.evaluations, static_cast<double>(found.status)};
    for (const JointPoint& point : found.path) {
      out.push_back(point.value);
      out.insert(out.end(), point.s.begin(), point.s.end());
      out.insert(out.end(), point.motions[0].begin(), point.motions[0].end());
    }
    return out;
  });
}

TEST_F(KillsOfARobot, LeaveItsReasonsAsTheyWere) {
  LEGWRIGHT_LONG_TEST();
  expect_same_after_kills(2, 2, [&](const Checkpoint& checkpoint) {
    WeightedCost task;
    task.cost = &cost;
    task.initial_motion = guess;
    CodesignOptions options;
    options.max_iterations = 4;
    options.checkpoint = checkpoint.in("search");
    const CodesignResult found = codesign({task}, space, space.initial(), options);
    std::vector<double> out = numbers_of(found);
    WeightedCost other = task;
    other.cost = &of_other_thread;
    const std::vector<std::vector<WeightedCost>> threads{{task}, {other}};
    PutBackOptions rules;
    rules.limits.checkpoint = checkpoint.in("rows");
    const auto rows = put_back(threads, space.initial(), found.best, rules);
    for (const PutBack& row : rows) out.push_back(row.decrease.at(0));
    FewestChangesOptions few;
    few.codesign.checkpoint = checkpoint.in("fewest");
    for (const FewerChanges& each : fewest_changes(threads, space, space.initial(),
                                                   found.initial.value, found.best, rows, few)) {
      const std::vector<double> numbers = numbers_of(each.design);
      out.insert(out.end(), numbers.begin(), numbers.end());
    }
    return out;
  });
}

// What is solved after a stop is asked for is not what a whole run solves under the same name.
TEST(Stops, KeepNothingOfWhatComesAfterThem) {
  toy::CoupledCost cost(toy::kMotionSize, toy::kDesignSize, 7);
  const DesignSpace space = toy::box(2.0);
  const auto search = [&](CheckpointStore* store, int calls) {
    WeightedCost task;
    task.cost = &cost;
    task.initial_motion = VectorXd::Zero(toy::kMotionSize);
    CodesignOptions options;
    options.checkpoint = Checkpoint(store, "run");
    int asked = 0;
    options.go_on =
        options.newton.go_on = [&asked, calls] { return calls == kNever || asked++ < calls; };
    return codesign({task}, space, space.initial(), options);
  };
  const std::vector<double> expected = numbers_of(search(nullptr, kNever));
  bool stopped = false;
  for (int calls = 1; calls < 40; ++calls) {
    StoreUntil store({}, kNever);
    stopped = search(&store, calls).status == SolveStatus::stopped || stopped;
    StoreUntil again(store.kept, kNever);
    EXPECT_EQ(numbers_of(search(&again, kNever)), expected) << "stopped at question " << calls;
  }
  EXPECT_TRUE(stopped);
}

}  // namespace
}  // namespace legwright
