// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "tools/session/state.hpp"

namespace legwright {

/// What a session can work out beside the design that stands.
enum class AlternativeKind {
  fewest,  // designs with ever fewer changes of the given body
  front,   // the trade-off between tasks: the best design of each of several weightings
};
std::string_view to_string(AlternativeKind kind);

/// A design that may take the place of the one that stands.
struct Alternative {
  Eigen::VectorXd s;
  std::vector<Eigen::VectorXd> motions;  // of each task, m*(s) or close to it
  std::vector<double> weights;           // of each task, under which it is the best
  std::vector<double> values;            // Fᵢ + Jᵢ of each task
  std::vector<int> changed;              // parameters that are not as given

  /// Σ wᵢ (Fᵢ + Jᵢ)
  double value() const;
};

/// What one parameter of the design that stood does for F: what putting it back alone would cost.
struct ChangeWorth {
  int parameter = 0;
  double given = 0.0;  // its value then [unit of the parameter]
  double worth = 0.0;  // Σ wᵢ (Fᵢ + Jᵢ); infinite where no motion is found
};

/// Designs to choose from. Never changed once they are made.
struct Alternatives {
  AlternativeKind kind = AlternativeKind::fewest;
  std::shared_ptr<const CodesignProblem> problem;  // whose tasks they do
  std::vector<Alternative> designs;  // of `fewest`: from all changes to few; of `front`: by weight
  // Of `fewest` alone.
  double given_value = 0.0;         // Σ wᵢ (Fᵢ + Jᵢ) of the given body with its best motions
  std::size_t fewest = 0;           // the last design that keeps kKept of the fall from there
  std::vector<ChangeWorth> worths;  // of the changes of the design that stood, largest first

  static constexpr double kKept = 0.95;  // of the fall of F
};
using AlternativesPointer = std::shared_ptr<const Alternatives>;

struct AlternativeRules {
  int threads = 1;                                    // results do not depend on it
  std::function<bool()> stop = [] { return false; };  // asked before each Newton iteration
  std::function<void()> tell = [] {};                 // called after each design iteration
};

/// Throws InputError where nothing is to be worked out: no parameter that may move has changed,
/// or tasks are neither two nor three.
void check_workable(AlternativeKind kind, const SessionState& state);
/// Works them out from a state whose motions are solved: within its bounds, what is frozen stays.
/// Deterministic. @return null where `stop` said so
/// Throws InputError as check_workable(), and where motions are not solved.
AlternativesPointer work_out(AlternativeKind kind, const SessionState& state,
                             const AlternativeRules& rules);

}  // namespace legwright
