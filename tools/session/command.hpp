// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "tools/files/json_file.hpp"
#include "tools/session/found.hpp"

namespace legwright {

/// What a user does to a session, and what it did by itself: replayed in this order, they lead to
/// the same state, bit by bit. Names and units are those of the robot's parameters.
namespace session {

/// Sets parameters [m, rad].
struct Edit {
  std::map<std::string, double> values;
  bool goes_on = false;  // with the edit before it, as one: a handle that moves on
};
struct Freeze {
  std::vector<std::string> names;
  bool frozen = true;
};
/// Narrower bounds than the robot's, or those again.
struct Bounds {
  std::string name;
  double lower = 0.0, upper = 0.0;
};
/// Other tasks: the text of a task file. Its [design] does not count.
struct Tasks {
  std::string text;
  std::string file = {};  // its name, for messages; empty: that of the session
};
struct Weights {
  std::vector<double> weights;  // of each task
};
/// To the body that was given. Bounds stay; those that leave it out are widened to it.
struct Reset {};
struct Undo {};
struct Redo {};
struct Snapshot {
  std::string name;  // under which the state is kept
};
struct Branch {
  std::string name;  // of the snapshot from which to go on
};
/// One design iteration. Where `found` is there and fits, here and below, a replay takes it over;
/// else it does the work.
struct Step {
  std::optional<Found> found = {};
};
/// The motions were solved.
struct Settled {
  std::optional<Found> found = {};
};
/// A search ran for so many points.
struct Searched {
  int points = 0;
  std::optional<Found> found = {};
};
/// Other designs were worked out: "fewest" changes, or the "front" of several tasks.
struct WorkedOut {
  std::string what;
  std::shared_ptr<const Alternatives> found = {};  // whose problem is not set; null: none
};
/// Takes one of those designs, counted from 0, in the place of the one that stands.
struct Choose {
  std::string what;
  int design = 0;
  bool goes_on = false;  // with the choice before it, as one: a slider that moves on
};

}  // namespace session

using SessionCommand =
    std::variant<session::Edit, session::Freeze, session::Bounds, session::Tasks, session::Weights,
                 session::Reset, session::Undo, session::Redo, session::Snapshot, session::Branch,
                 session::Step, session::Settled, session::Searched, session::WorkedOut,
                 session::Choose>;

/// The same as it was asked for, without what was found: a replay does its work anew.
SessionCommand without_found(SessionCommand command);

/// The command as a line of the journal: {"do": "edit", …}.
Json json_of(const SessionCommand& command);
/// Reads such a line strictly. Throws InputError that names what is wrong.
/// @param file, line for messages
SessionCommand command_of(const Json& json, const std::string& file, int line);

}  // namespace legwright
