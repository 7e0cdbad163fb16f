// SPDX-License-Identifier: Apache-2.0
#include "tools/choose/choose_design.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "optimizer/base/parallel.hpp"
#include "optimizer/base/stopwatch.hpp"
#include "tools/choose/candidate_words.hpp"
#include "tools/choose/cheapest_stable.hpp"
#include "tools/choose/finalists.hpp"
#include "tools/choose/kept_play.hpp"
#include "tools/choose/other_designs.hpp"
#include "tools/choose/play_in_turn.hpp"
#include "tools/choose/tightened_search.hpp"
#include "tools/simulate/mujoco_host.hpp"

namespace legwright {
namespace {

constexpr int kRounds = 4;              // of tightened searches, at most
constexpr std::size_t kBeam = 2;        // designs that a round goes on from
constexpr std::size_t kLeversKept = 7;  // from the second round on
constexpr int kSearchIterations = 12;   // of each: it starts from a design that is nearly right
constexpr double kDear = 1.3;  // × F of the optimum: a design that passes with more is not the last
constexpr double kGivenFirst = 2.0;  // × F of the optimum: up to there the given body comes first
constexpr double kGain = 0.99;  // of the distance from passing: a round that gains less is the last

/// Plays candidates and keeps the best of them.
class DesignChooser {
 public:
  DesignChooser(const CodesignProblem& problem, const std::vector<JointTask>& tasks,
                const ChoiceOptions& options)
      : problem_(problem), tasks_(tasks), options_(options) {}

  /// @return what physics says of it
  PlayedCandidate consider(const Candidate& candidate) {
    PlayedCandidate played = play(candidate, options_.threads, next_play());
    note(candidate, played);
    return played;
  }

  /// One pull of each lever on the motion alone of a design that failed, which costs a motion solve
  /// each.
  void tighten_motion(const Candidate& from, const PlayedCandidate& played) {
    set_origin(from);
    const std::vector<PlayedDesign> beam{{from, played, {}}};
    play_by_rising_cost(search_pulls(pulls_on(beam), Searched::motion), 0);
  }

  /// Whether something passes with little more F than a design has that failed.
  bool passes_nearly_as_cheaply(const Candidate& as) const {
    return played_.pass && best_->design.value <= kDear * as.design.value;
  }

  /// Tightened searches of body and motion in rounds, from a candidate that failed, until physics
  /// passes one. Each goes on from the nearest ones of the last.
  void tighten_body(const Candidate& from, const PlayedCandidate& played) {
    set_origin(from);
    std::vector<PlayedDesign> beam{{from, played, {}}};
    double nearest = played.distance;
    for (int round = 0; round < kRounds && !stopped(); ++round) {
      std::vector<PlayedDesign> found = play_by_rising_cost(
          search_pulls(pulls_on(beam), Searched::body), round == 0 ? kLeversKept : kBeam);
      if (found.empty() || found.back().played.pass) return;
      std::stable_sort(found.begin(), found.end(),
                       [](const PlayedDesign& a, const PlayedDesign& b) {
                         return nearer(a.design, a.played, b.design, b.played);
                       });
      const PlayedCandidate& best = found.front().played;
      if (!(best.distance < kGain * nearest)) return;
      if (round == 0) keep_best_levers(found);
      nearest = best.distance;
      // No lever stands for numerics, and any may help: those too that did least before.
      const bool in_numerics_alone = round > 0 && nearest < kMissedLimit;
      if (in_numerics_alone) levers_ = all_levers();
      found.resize(std::min(found.size(), in_numerics_alone ? 1 : kBeam));
      beam = std::move(found);
    }
  }

  /// Both. With a kept body the rounds are of the motion alone, too.
  void tighten(const Candidate& from, const PlayedCandidate& played) {
    if (!options_.codesign.motion_only) tighten_motion(from, played);
    if (!passes_nearly_as_cheaply(from)) tighten_body(from, played);
  }

  /// What else the search came by. Where nothing passes yet, another start's optimum is tightened
  /// as the best one was.
  void consider_others(const MultistartResult& found, const std::vector<DesignIteration>& along) {
    const std::optional<Candidate> other =
        played_.pass ? std::nullopt : other_optimum(found, kDear);
    if (other && !stopped()) {
      const PlayedCandidate played = consider(*other);
      if (!played.pass) tighten(*other, played);
    }
    std::vector<PlayedDesign> further;
    for (Candidate& candidate : further_candidates(found, along))
      if (!other || candidate.name != other->name) further.push_back({std::move(candidate), {}});
    play_by_rising_cost(std::move(further), 0);
  }

  bool has_result() const { return best_.has_value(); }
  bool stopped() const { return options_.stop && options_.stop(); }
  /// Whether a candidate with this F could still become the result.
  bool worth_playing(double value) const { return !played_.pass || value < best_->design.value; }

  /// Where nothing passes: plays the nearest, the optimum and the given body to the end, for what
  /// failed early was played for a few cycles only, and keeps the one that is nearest then.
  void play_finalists() {
    if (played_.pass || stopped()) return;
    while (const Finalist* each = failed_.unknown()) {
      const PlayedCandidate played = play(each->design, options_.threads, next_play());
      write_again(each->place, played);
      failed_.tell(played);
    }
    const std::vector<Finalist> finalists = failed_.in_order();
    std::vector<PlayedCandidate> played(finalists.size());
    const Checkpoint checkpoint = next_play();
    parallel_for(static_cast<int>(finalists.size()), options_.threads, [&](int k) {
      const auto i = static_cast<std::size_t>(k);
      played[i] = play(finalists[i].design, 1, checkpoint.in(k), PlayLength::whole);
    });
    best_.reset();
    for (std::size_t i = 0; i < finalists.size(); ++i) {
      write_again(finalists[i].place, played[i]);
      take_if_nearer(finalists[i].design, played[i]);
    }
  }

  /// Takes the cheapest design with a stable cycle, where several pass with about as much F.
  void prefer_stable() {
    if (!played_.pass || stopped()) return;
    std::vector<PlayedCost> costs;
    for (const auto& [place, candidate] : kept_)
      costs.push_back({record_.candidates[place].played.pass, candidate.design.value});
    const auto found = cheapest_stable(costs, best_->design.value,
                                       [&](std::size_t k) { return told_multiplier(kept_[k]); });
    if (found) best_ = kept_[*found].second;
  }

  ChosenDesign result(double seconds) {
    record_.chosen = best_->name;
    record_.pass = played_.pass;
    record_.seconds = seconds;
    const auto chosen = [&](const auto& kept) {
      return record_.candidates[kept.first].name == record_.chosen;
    };
    if (std::none_of(kept_.begin(), kept_.end(), chosen))
      for (std::size_t i = 0; i < record_.candidates.size(); ++i)
        if (record_.candidates[i].name == record_.chosen) kept_.emplace_back(i, *best_);
    return {std::move(*best_), std::move(record_), std::move(kept_)};
  }

 private:
  /// The largest Floquet multiplier of a design, which goes into the record.
  double told_multiplier(const std::pair<std::size_t, Candidate>& kept) {
    const Candidate& candidate = kept.second;
    const double multiplier = kept_play(next_play(), options_.stop, [&] {
      return largest_multiplier(problem_, candidate, options_.threads, options_.stop);
    });
    CandidateRecord& record = record_.candidates[kept.first];
    record.stable = multiplier < 1.0;
    if (std::isfinite(multiplier)) record.multiplier = multiplier;
    if (options_.tell)
      options_.tell(fmt::format("physics, {} (F {:.5g}): largest Floquet multiplier {:.2f}",
                                candidate.name, candidate.design.value, multiplier));
    return multiplier;
  }

  struct PlayedDesign {
    Candidate design;
    PlayedCandidate played;
    std::optional<Lever> lever = {};        // the last that was pulled
    const PlayedCandidate* like = nullptr;  // what it comes from, as it was played
  };
  enum class Searched { motion, body };
  struct LeverPull {
    const PlayedDesign* from;
    Lever lever;
    std::vector<Tightening> tightening;
  };

  PlayedCandidate play(const Candidate& candidate, int threads, const Checkpoint& checkpoint,
                       PlayLength length = PlayLength::until_failure) const {
    return kept_play(checkpoint, options_.stop, [&] {
      return play_candidate(problem_, candidate, threads, length, options_.stop);
    });
  }
  Checkpoint next_play() { return options_.codesign.checkpoint.in("plays").in(plays_++); }

  /// Where tightened searches set out from; all levers again.
  void set_origin(const Candidate& from) {
    origin_ = from.name == kOptimum ? "" : from.name + ", ";
    levers_ = all_levers();
  }

  /// What did least in the first round, each lever by itself, is left alone from then on, unless
  /// numerics alone fail.
  void keep_best_levers(const std::vector<PlayedDesign>& sorted) {
    levers_.clear();
    for (const PlayedDesign& design : sorted)
      if (levers_.size() < kLeversKept) levers_.push_back(*design.lever);
    std::sort(levers_.begin(), levers_.end());
  }

  /// One more pull of each lever on each design, but those that were pulled alike.
  std::vector<LeverPull> pulls_on(const std::vector<PlayedDesign>& beam) const {
    std::vector<LeverPull> out;
    for (const PlayedDesign& from : beam)
      for (const Lever lever : levers_) {
        LeverPull pull{&from, lever, pulled(from.design, from.played, lever)};
        const auto same = [&](const LeverPull& other) {
          return alike(other.tightening, pull.tightening);
        };
        if (std::none_of(out.begin(), out.end(), same)) out.push_back(std::move(pull));
      }
    return out;
  }

  /// Plays designs, up to the first that passes: those after it cannot become the result.
  /// @param nearest so many of those that fail shall be known in full, if none passes
  /// @return what was played
  std::vector<PlayedDesign> play_by_rising_cost(std::vector<PlayedDesign> found,
                                                std::size_t nearest) {
    std::stable_sort(found.begin(), found.end(), [](const PlayedDesign& a, const PlayedDesign& b) {
      return a.design.design.value < b.design.design.value;
    });
    std::erase_if(
        found, [&](const PlayedDesign& each) { return !worth_playing(each.design.design.value); });
    if (stopped()) found.clear();
    std::vector<CandidateInTurn> turns;
    turns.reserve(found.size());
    for (const PlayedDesign& each : found) turns.push_back({&each.design, each.like});
    bool stopped_meanwhile = false;
    std::vector<PlayedCandidate> played = kept_play(next_play(), options_.stop, [&] {
      PlayedInTurn out = play_in_turn(problem_, turns, nearest, options_.threads, options_.stop);
      stopped_meanwhile = out.stopped;
      return std::move(out.played);
    });
    found.resize(played.size());
    for (std::size_t i = 0; i < found.size(); ++i) {
      found[i].played = std::move(played[i]);
      note(found[i].design, found[i].played);
    }
    if (stopped_meanwhile) throw RolloutStopped();
    return found;
  }

  /// One design for each pull that has any; not played yet.
  std::vector<PlayedDesign> search_pulls(const std::vector<LeverPull>& pulls, Searched what) {
    std::vector<std::optional<PlayedDesign>> slots(pulls.size());
    CodesignOptions search = options_.codesign;
    const Checkpoint checkpoint = search.checkpoint.in(rounds_++);
    search.near_optimum = true;
    search.threads = 1;  // the levers run side by side
    const bool motion = search.motion_only || what == Searched::motion;
    search.motion_only = motion;
    search.max_iterations = std::min(search.max_iterations, kSearchIterations);
    parallel_for(static_cast<int>(pulls.size()), options_.threads, [&](int k) {
      const auto i = static_cast<std::size_t>(k);
      const LeverPull& pull = pulls[i];
      const bool of_use = !motion || pull.lever != Lever::near_given_body;
      if (stopped() || !of_use) return;
      CodesignOptions own = search;
      own.checkpoint = checkpoint.in(k);
      auto design = search_tightened(problem_, tasks_, pull.from->design, pull.tightening,
                                     options_.space.value_or(problem_.robot.space), own);
      if (!design) return;
      design->name = origin_ + kTightened + (motion ? " motion: " : ": ") +
                     words_of(problem_, pull.tightening);
      slots[i] = {std::move(*design), {}, pull.lever, &pull.from->played};
    });
    std::vector<PlayedDesign> out;
    for (auto& slot : slots)
      if (slot) out.push_back(std::move(*slot));
    return out;
  }

  /// The order of what a run hands back.
  static bool nearer(const Candidate& a, const PlayedCandidate& played_a, const Candidate& b,
                     const PlayedCandidate& played_b) {
    if (played_a.pass != played_b.pass) return played_a.pass;
    return played_a.pass ? a.design.value < b.design.value : played_a.distance < played_b.distance;
  }

  void count_rollouts(const PlayedCandidate& played) {
    for (const GaitTrial& trial : played.trials) record_.rollouts += trial.rollouts;
  }

  void note(const Candidate& candidate, const PlayedCandidate& played) {
    count_rollouts(played);
    if (options_.tell)
      options_.tell(fmt::format("physics, {} (F {:.5g}): {}", candidate.name,
                                candidate.design.value, brief_words(problem_, played)));
    record_.candidates.push_back({candidate.name,
                                  candidate.design.value,
                                  played.record(),
                                  {},
                                  failing_tasks(problem_, played),
                                  {},
                                  {},
                                  played_tasks(problem_, played)});
    if (played.pass || record_.candidates.size() == 1)
      kept_.emplace_back(record_.candidates.size() - 1, candidate);
    failed_.add(candidate, record_.candidates.size() - 1, played);
    take_if_nearer(candidate, played);
  }

  void take_if_nearer(const Candidate& candidate, const PlayedCandidate& played) {
    if (best_ && (!played.to_the_end || !nearer(candidate, played, *best_, played_))) return;
    best_ = candidate;
    played_ = played;
  }

  /// What is known of a candidate now that it was played for longer.
  void write_again(std::size_t place, const PlayedCandidate& played) {
    record_.candidates[place].played = played.record();
    record_.candidates[place].failing = failing_tasks(problem_, played);
    record_.candidates[place].tasks = played_tasks(problem_, played);
    count_rollouts(played);
  }

  const CodesignProblem& problem_;
  const std::vector<JointTask>& tasks_;
  const ChoiceOptions& options_;
  std::vector<Lever> levers_ = all_levers();
  std::string origin_;          // how names of designs from there begin
  int rounds_ = 0, plays_ = 0;  // so far: the names of their checkpoints
  ChoiceRecord record_;
  std::vector<std::pair<std::size_t, Candidate>> kept_;
  Finalists failed_;
  std::optional<Candidate> best_;
  PlayedCandidate played_;  // of best_
};

/// What stands in for an optimum that fails.
void tighten_optimum(DesignChooser& chooser, const Candidate& optimum,
                     const PlayedCandidate& played, const MultistartResult& found,
                     const std::vector<DesignIteration>& along, const ChoiceOptions& options) {
  const DesignIteration& initial = found.joint.front().result.initial;
  const Candidate given{kGivenBody, initial, {}, {}};
  const bool kept_body = options.codesign.motion_only;
  std::optional<PlayedCandidate> given_failed;
  if (!initial.tasks.empty() && !kept_body) {
    const PlayedCandidate played_given = chooser.consider(given);
    if (!played_given.pass) given_failed = played_given;
  }
  // What the co-designed body gets, once: its gait may fail by as little.
  const auto tighten_given = [&] {
    if (given_failed && !chooser.stopped() && chooser.worth_playing(initial.value))
      chooser.tighten_motion(given, *given_failed);
    given_failed.reset();
  };
  if (!kept_body) chooser.tighten_motion(optimum, played);
  // Ten motion solves cost less than a round, and rounds play only what is cheaper then.
  const bool not_hopeless = initial.value <= kGivenFirst * optimum.design.value;
  if (not_hopeless && !chooser.passes_nearly_as_cheaply(optimum)) tighten_given();
  if (!chooser.passes_nearly_as_cheaply(optimum)) chooser.tighten_body(optimum, played);
  tighten_given();
  if (!options.space) chooser.consider_others(found, along);
}

/// All that choose_design() tries, in its order.
void try_designs(DesignChooser& chooser, const MultistartResult& found,
                 const std::vector<DesignIteration>& along, const ChoiceOptions& options) {
  const Candidate optimum{kOptimum, found.winner().best, {}, {}};
  const PlayedCandidate played = chooser.consider(optimum);
  if (!played.pass) tighten_optimum(chooser, optimum, played, found, along, options);
  chooser.play_finalists();
  chooser.prefer_stable();
}

}  // namespace

ChosenDesign choose_design(const CodesignProblem& problem, const std::vector<JointTask>& tasks,
                           const MultistartResult& found, const std::vector<DesignIteration>& along,
                           const ChoiceOptions& options) {
  const Stopwatch watch;
  load_gait_plugin();
  DesignChooser chooser(problem, tasks, options);
  try {
    try_designs(chooser, found, along, options);
  } catch (const RolloutStopped&) {  // the best of those that were played
    if (!chooser.has_result()) throw;
  }
  return chooser.result(watch.seconds());
}

}  // namespace legwright
