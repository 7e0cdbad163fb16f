// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "optimizer/base/stopwatch.hpp"

namespace legwright {

/// Where solves keep how far they are, each under a name, for a process that takes the place of one
/// that was killed. Called from several threads at once.
class CheckpointStore {
 public:
  virtual ~CheckpointStore() = default;
  /// What was kept last under a name; empty where nothing was.
  virtual std::vector<double> find(const std::string& name) = 0;
  /// How long a solve works before it keeps its state again.
  virtual double seconds_between() const { return 0.5; }
  /// May throw what a full disk throws.
  virtual void keep(const std::string& name, const std::vector<double>& state) = 0;
};

/// The state of a solve as numbers. One function that passes all members, in one order, both writes
/// and reads them.
class SolveState {
 public:
  /// To write.
  SolveState() = default;
  /// To read. Throws std::out_of_range where a member is asked for that is not there.
  explicit SolveState(std::vector<double> numbers) : numbers_(std::move(numbers)), is_read_(true) {}

  void operator()(double& member);
  void operator()(int& member);
  void operator()(bool& member);
  void operator()(Eigen::VectorXd& member);
  void operator()(std::vector<double>& member);
  void operator()(std::string& member);
  template <class Enum>
  requires std::is_enum_v<Enum>
  void operator()(Enum& member) {
    int value = static_cast<int>(member);
    (*this)(value);
    member = static_cast<Enum>(value);
  }
  /// The length of a list, whose members are passed one by one then.
  template <class Member>
  void size_of(std::vector<Member>& list) {
    int size = static_cast<int>(list.size());
    (*this)(size);
    if (is_read_) list.resize(static_cast<std::size_t>(size));
  }
  const std::vector<double>& numbers() const { return numbers_; }

 private:
  std::vector<double> numbers_;
  std::size_t next_ = 0;
  bool is_read_ = false;
};

/// The place of a solve in a run, by name. The same solve has the same name in every run of the
/// same problem, whatever thread comes by when: so a run that is taken up finds there what the one
/// before it had come to, and goes on bit for bit. By default nothing is kept.
class Checkpoint {
 public:
  Checkpoint() = default;
  Checkpoint(CheckpointStore* store, std::string name) : store_(store), name_(std::move(name)) {}

  /// A place within this one.
  Checkpoint in(std::string_view name) const;
  Checkpoint in(int number) const { return in(std::to_string(number)); }
  explicit operator bool() const { return store_ != nullptr; }
  /// Reads the members that `pass` passes to a SolveState from what was kept here. @param origin
  /// tells where the solve sets out from: what one from elsewhere kept is of no use to it.
  /// @return whether there was anything
  template <class Pass>
  bool take_up(const Pass& pass, double origin = 0.0) const {
    std::vector<double> numbers = find();
    if (numbers.empty()) return false;
    SolveState state(std::move(numbers));
    double of_kept = origin;
    state(of_kept);
    if (of_kept != origin) return false;
    pass(state);
    return true;
  }
  /// Keeps the same members.
  template <class Pass>
  void keep(const Pass& pass, double origin = 0.0) {
    if (store_ == nullptr) return;
    SolveState state;
    state(origin);
    pass(state);
    keep_numbers(state.numbers());
  }
  /// Whether the last keep() is long enough ago that the next is worth its time.
  bool due() const;

 private:
  std::vector<double> find() const;
  void keep_numbers(const std::vector<double>& numbers);

  CheckpointStore* store_ = nullptr;
  std::string name_;
  Stopwatch since_kept_;
};

}  // namespace legwright
