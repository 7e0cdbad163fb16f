// SPDX-License-Identifier: Apache-2.0
#include "tools/choose/play_in_turn.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <memory>
#include <optional>
#include <utility>

#include "optimizer/base/parallel.hpp"
#include "tools/choose/candidate_on_trial.hpp"
#include "tools/simulate/rollout.hpp"

namespace legwright {
namespace {

/// A candidate played by and by: first until it fails or passes, from then on one roll-out at a
/// time.
class PlayByPlay {
 public:
  PlayByPlay(const CodesignProblem& problem, const CandidateInTurn& turn,
             const std::function<bool()>& stop)
      : on_trial_(problem, *turn.design, 1, stop),
        runs_(static_cast<std::size_t>(problem.task_count())) {
    for (std::size_t task = 0; task < runs_.size(); ++task)
      for (std::size_t gain = 0; gain < kTrialGains.size(); ++gain) order_.push_back({task, gain});
    if (turn.like == nullptr) return;
    const auto far = [&](const Place& at) {
      const GaitTrial& trial = turn.like->trials[at.task];
      return at.gain < trial.at_gains.size() ? trial.at_gains[at.gain] : trial.distance;
    };
    std::stable_sort(order_.begin(), order_.end(),
                     [&](const Place& a, const Place& b) { return far(a) > far(b); });
  }

  bool failed() const { return failed_; }
  bool ended() const { return ended_; }
  bool passes() const { return ended_ && !failed_; }
  /// The distance of what was played; all of it once it ended.
  double at_least() const { return at_least_; }

  /// Plays what the next go_on() is about, for others to wait less.
  void look_ahead() {
    if (!ended_ && ahead_.empty()) play_ahead();
  }
  void go_on() {
    look_ahead();
    for (const Run& run : ahead_) take(run);
    ahead_.clear();
    if (!failed_ && next_ == order_.size()) {
      failed_ = !whole_->pass;
      ended_ = true;
      at_least_ = whole_->distance;
    } else if (next_ == order_.size() || !(at_least_ < kInfinite)) {
      ended_ = true;
    }
  }
  PlayedCandidate played() const {
    if (whole_ && ended_) return *whole_;
    PlayedCandidate out = played_tasks(trials());
    out.to_the_end = ended_;
    return out;
  }

 private:
  struct Place {
    std::size_t task, gain;
  };
  struct Run {
    Place at;
    std::optional<FirstCycles> first;  // nothing: cannot be played
  };
  static constexpr double kInfinite = std::numeric_limits<double>::infinity();

  void play_ahead() {
    bool fails = failed_;
    std::vector<Run> runs;
    do {
      const Place at = order_[next_ + runs.size()];
      runs.push_back({at, on_trial_.play_first(at.task, at.gain, !fails)});
      fails = fails || !runs.back().first || runs.back().first->distance > 0.0;
    } while (!fails && next_ + runs.size() < order_.size());
    if (!fails) {
      if (on_trial_.play(PlayedCycles::all)) on_trial_.ask_other_numerics();
      whole_ = played_tasks(on_trial_.trials());
    }
    ahead_ = std::move(runs);
  }
  void take(const Run& run) {
    ++next_;
    if (!run.first) {
      broken_ = failed_ = true;
      at_least_ = kInfinite;
      return;
    }
    runs_[run.at.task][run.at.gain] = run.first;
    failed_ = failed_ || run.first->distance > 0.0;
    if (broken_) return;
    at_least_ = 0.0;  // summed in the order of a whole trial, whose bits it has in the end
    for (const auto& of_task : runs_) {
      double sum = 0.0;
      for (const auto& each : of_task)
        if (each) sum += each->distance;
      at_least_ += sum;
    }
  }
  std::vector<GaitTrial> trials() const {
    std::vector<GaitTrial> out;
    for (std::size_t task = 0; task < runs_.size(); ++task) {
      std::vector<FirstCycles> played;
      for (const auto& each : runs_[task])
        if (each) played.push_back(*each);
      out.push_back(on_trial_.trial_of_first(task, played));
    }
    return out;
  }

  CandidateOnTrial on_trial_;
  std::vector<Place> order_;  // of what is played
  std::vector<std::array<std::optional<FirstCycles>, kTrialGains.size()>> runs_;  // by task
  std::size_t next_ = 0;                                                          // in order_
  std::vector<Run> ahead_;  // played, and not counted yet
  std::optional<PlayedCandidate> whole_;
  bool failed_ = false, ended_ = false, broken_ = false;
  double at_least_ = 0.0;
};

class Turns {
 public:
  Turns(const CodesignProblem& problem, const std::vector<CandidateInTurn>& candidates, int threads,
        const std::function<bool()>& stop)
      : threads_(static_cast<std::size_t>(std::max(1, threads))) {
    for (const CandidateInTurn& turn : candidates)
      plays_.push_back(std::make_unique<PlayByPlay>(problem, turn, stop));
  }

  PlayedInTurn play(std::size_t nearest) {
    PlayedInTurn out;
    std::size_t count = 0;
    try {
      bool passed = false;
      for (; count < plays_.size() && !passed; ++count) {
        look_ahead(in_order(count));
        plays_[count]->go_on();
        passed = plays_[count]->passes();
      }
      while (!passed) {
        const std::vector<std::size_t> open = open_ones(nearest);
        if (open.empty()) break;
        look_ahead(open);
        plays_[open.front()]->go_on();
      }
    } catch (const RolloutStopped&) {
      out.stopped = true;
    }
    for (std::size_t i = 0; i < count; ++i) out.played.push_back(plays_[i]->played());
    return out;
  }

 private:
  std::vector<std::size_t> in_order(std::size_t first) const {
    std::vector<std::size_t> out;
    for (std::size_t i = first; i < plays_.size(); ++i) out.push_back(i);
    return out;
  }

  /// Those that may be among the nearest for all that is known, the nearest first.
  std::vector<std::size_t> open_ones(std::size_t nearest) const {
    const auto before = [&](std::size_t a, std::size_t b) {
      const double of_a = plays_[a]->at_least(), of_b = plays_[b]->at_least();
      return of_a != of_b ? of_a < of_b : a < b;
    };
    std::vector<std::size_t> sorted = in_order(0), out;
    std::sort(sorted.begin(), sorted.end(), before);
    std::size_t known = 0;
    for (const std::size_t i : sorted) {
      if (known == nearest) break;
      if (plays_[i]->ended())
        ++known;
      else
        out.push_back(i);
    }
    return out;
  }

  void look_ahead(const std::vector<std::size_t>& next) {
    if (threads_ == 1) return;
    parallel_for(static_cast<int>(std::min(threads_, next.size())), static_cast<int>(threads_),
                 [&](int k) {
                   try {
                     plays_[next[static_cast<std::size_t>(k)]]->look_ahead();
                   } catch (const RolloutStopped&) {  // whoever needs it finds out
                   }
                 });
  }

  std::size_t threads_;
  std::vector<std::unique_ptr<PlayByPlay>> plays_;
};

}  // namespace

PlayedInTurn play_in_turn(const CodesignProblem& problem,
                          const std::vector<CandidateInTurn>& candidates, std::size_t nearest,
                          int threads, const std::function<bool()>& stop) {
  return Turns(problem, candidates, threads, stop).play(nearest);
}

}  // namespace legwright
