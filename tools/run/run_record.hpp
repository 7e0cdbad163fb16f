// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "tools/run/fewest_changes_record.hpp"
#include "tools/run/played_gait.hpp"
#include "tools/run/put_back_record.hpp"
#include "tools/run/record.hpp"

namespace legwright {

struct SlopeRecord {
  double along = 0.0, across = 0.0;  // [rad]
};
void fields(Fields& f, SlopeRecord& slope);

struct PayloadRecord {
  double mass = 0.0;                         // [kg]
  std::array<double, 3> position{}, size{};  // [m]
};
void fields(Fields& f, PayloadRecord& payload);

// What candidates are called: F's optimum; the given body; and what a tightened search found, from
// the optimum, or from another candidate: "initial, tightened motion: larger margins".
inline constexpr const char* kOptimum = "optimum";
inline constexpr const char* kGivenBody = "initial";
inline constexpr const char* kTightened = "tightened";
// In the folder of such a candidate: the task file whose optimum it is.
inline constexpr const char* kTightenedTask = "tightened.toml";

/// A design that was played before `optimize` chose its result.
struct CandidateRecord {
  std::string name;
  double F = 0.0;  // of the task as the user gave it
  PlayedGait played;
  std::optional<std::string> folder;           // of its files in the run, where they are kept
  std::optional<ByName<std::string>> failing;  // of several tasks: the line of each that fails
  // Of designs that pass, where there are several to choose between: whether the largest Floquet
  // multiplier at the three gains is below 1, and that number, absent where the gait falls.
  std::optional<bool> stable;
  std::optional<double> multiplier;
  std::optional<ByName<PlayedGait>> tasks = {};  // of several tasks: each by itself
};
void fields(Fields& f, CandidateRecord& candidate);

/// Which of its designs `optimize` handed back: the one with the least F that physics passes, but
/// for one with almost as little and a stable cycle.
struct ChoiceRecord {
  std::string chosen;
  bool pass = false;
  int rollouts = 0;
  double seconds = 0.0;
  std::vector<CandidateRecord> candidates;

  /// Why MuJoCo does not pass a candidate; of several tasks, why it does not pass this one. Nothing
  /// where it passes, or was not played.
  std::optional<std::string> complaint(const std::string& candidate, const std::string& task) const;
  /// Whether a design that passes with less F was left for one whose cycle is stable.
  bool by_stability() const;
};
void fields(Fields& f, ChoiceRecord& choice);

struct PhysicsStepRecord {
  ByName<double> scalars;  // factors on what the task says
  double merit = 0.0, predicted_merit = 0.0;
  bool accepted = false;
  std::string line;
};
void fields(Fields& f, PhysicsStepRecord& step);

/// What `optimize --physics-steps` did to the gait of a task.
struct PhysicsStepsRecord {
  PlayedGait before, after;
  ByName<double> scalars;  // factors on what the task says
  std::string factors;     // the same in words
  double period = 0.0, seconds = 0.0;
  bool changed = false;  // whether the gait in result/ is another one than that of F
  int rollouts = 0;
  std::vector<PhysicsStepRecord> steps;
};
void fields(Fields& f, PhysicsStepsRecord& steps);

/// What was asked for; of a joint run also what came of it.
struct TaskRecord {
  std::string name, gait;
  double period = 0.0;  // [s]
  int knots = 0, planted_margin = 0;
  std::array<double, 2> velocity{};    // along x, y of the trunk's frame [m/s]
  double turn_rate = 0.0;              // [rad/s]
  std::optional<std::string> forward;  // where it faces: "+y"; absent: +x
  double floor_friction = 0.0;
  std::optional<SlopeRecord> slope;
  std::optional<PayloadRecord> payload;
  std::optional<double> torque_limit, servo_kp, step_over;  // [N m], [N m/rad], [m]
  std::optional<std::string> dynamics;  // of the torque balance, where it is not the full one
  // Of a task in run.json's "tasks" alone:
  std::optional<double> weight;
  std::optional<std::string> folder;  // tasks/NAME
  std::optional<int> motion_size;
  std::optional<double> initial_F, F, speed_wanted, speed_reached;
  std::optional<bool> feasible;
  std::optional<PhysicsStepsRecord> physics_steps;

  /// The unit vector of `forward`.
  Eigen::Vector2d facing() const;
};
void fields(Fields& f, TaskRecord& task);

struct ParameterRecord {
  std::string name, unit, kind, sentence;
  double initial = 0.0, lower = 0.0, upper = 0.0, final = 0.0;  // SI
  int tied_count = 0;
};
void fields(Fields& f, ParameterRecord& parameter);

/// What MuJoCo measured of an outer objective's quantity, by servo gains; without those at which
/// the robot fell.
struct OuterMeasured {
  ByName<double> initial, result;
};
void fields(Fields& f, OuterMeasured& measured);

/// J = weight · v/v₀ of a quantity v in `unit`.
struct OuterRecord {
  std::string objective;
  std::optional<std::string> source;  // where it comes from, if it is no term
  double weight = 0.0;
  std::optional<std::string> unit;                 // "N m", "J" or "m^3"
  std::optional<double> reference;                 // v₀
  std::optional<double> plan_initial, plan_final;  // v of the initial body's plan and the result's
  std::optional<OuterMeasured> measured;           // once the run is validated
};
void fields(Fields& f, OuterRecord& outer);

/// One of the searches of a run.
struct StartRecord {
  std::string start;  // "initial", the task whose best body it set out from, "perturbed-1", …
  std::vector<std::string> tasks;
  std::string status;
  double start_F = 0.0, F = 0.0;
  ByName<double> start_F_of_tasks, F_of_tasks;
  int design_iterations = 0, newton_iterations = 0;
  double seconds = 0.0;
  ByName<double> s;  // of the body at the end
};
void fields(Fields& f, StartRecord& start);

struct EngineWarningRecord {
  std::string task, warning;
  int count = 0;
  double first = 0.0;  // [s]
};
void fields(Fields& f, EngineWarningRecord& warning);

struct BodyRecord {
  double mass = 0.0;                     // of the robot alone [kg]
  std::optional<double> printed_volume;  // [m³]
};
void fields(Fields& f, BodyRecord& body);

struct BodiesRecord {
  BodyRecord initial, final;
};
void fields(Fields& f, BodiesRecord& bodies);

/// What run.json says of result/certificate.json.
struct CertificateNote {
  double worst_gradient_error = 0.0;
  std::size_t active_bounds = 0;
  double seconds = 0.0;
};
void fields(Fields& f, CertificateNote& note);

/// A point of the trade-off between two tasks.
struct FrontPointRecord {
  double weight = 0.0;  // of the first task
  double F = 0.0;
  ByName<double> F_of_tasks;
  std::string status;
  ByName<double> s;
};
void fields(Fields& f, FrontPointRecord& point);

/// run.json. What is std::optional is of a run that has ended, or of one of one task alone (`task`)
/// or of several (`tasks`).
struct RunRecord {
  static constexpr RecordKind kKind{"legwright/run", 1, "optimize"};
  std::string status;  // "running", "failed", or how the search ended
  std::string robot;
  std::optional<OuterRecord> outer;
  std::optional<std::string> name;  // of the task file of a joint run
  std::optional<std::vector<TaskRecord>> tasks;
  std::optional<TaskRecord> task;
  int design_size = 0, motion_size = 0;
  std::vector<ParameterRecord> parameters;
  std::vector<std::string> argv;
  ByName<std::string> versions;
  std::string factorisation;
  ByName<std::string> files, sha256;
  std::optional<ByName<std::string>> scenes;  // sums of those that the run wrote, by their way
  std::optional<std::string> joint_run;       // of a task of one: the way to it
  bool motion_only = false;
  std::optional<std::string> start;  // of a task of a joint run: from which its best one set out
  std::optional<std::vector<EngineWarningRecord>> engine_warnings;
  std::optional<std::vector<PutBackRecord>> put_back;
  std::optional<FewestChangesRecord> fewest_changes;
  std::optional<bool> feasible;
  std::optional<std::vector<std::string>> reasons;  // why it is not feasible
  std::optional<double> motion_only_F;
  std::optional<std::vector<double>> motion_only_trace;  // F by Newton step
  std::optional<double> final_F, final_J;
  std::optional<ByName<double>> final_terms;  // of final_F
  std::optional<std::string> best_start;
  std::optional<std::vector<StartRecord>> starts, alone;
  std::optional<std::vector<double>> history;  // F by iteration
  std::optional<int> design_iterations, newton_iterations, factorisations;
  std::optional<ByName<double>> seconds;  // by what took them
  std::optional<double> peak_rss_mib, projected_gradient_norm;
  std::optional<std::string> motion_status;
  std::optional<double> speed_wanted, speed_reached;  // [m/s]; on the spot [rad/s]
  std::optional<double> heading_error, ground_error, slide_share, root_residual;
  std::optional<BodiesRecord> body;
  std::optional<CertificateNote> certificate;
  std::optional<ChoiceRecord> choice;
  std::optional<std::string> picked;  // which design the user made the result
  std::optional<PhysicsStepsRecord> physics_steps;
  std::optional<std::vector<FrontPointRecord>> front;
  std::optional<std::string> failure;  // why the status is "failed"

  bool joint() const { return tasks.has_value(); }
  /// Whether the search has handed back the given body. Nothing is known of it before the end.
  bool body_kept() const;
  /// Whether a tightened search found the result: `put_back` and `fewest_changes` tell its F.
  bool tightened() const;
  /// What the design is called that is the result: chosen, or picked since. Needs `choice`.
  const std::string& result_name() const { return picked ? *picked : choice->chosen; }
  /// The folder of the candidate that the result is, in the run; empty where it is none.
  std::string result_candidate() const;
  /// Whether the search came to an end, be it by a signal.
  bool ended() const { return status != "running" && status != "failed"; }
  /// Whether what is there is only the best so far.
  bool stopped_early() const { return !ended() || status == "interrupted"; }
  /// motion_only_F − final_F, where it has both.
  std::optional<double> fall_of_cost() const;
};
void fields(Fields& f, RunRecord& run);

}  // namespace legwright
