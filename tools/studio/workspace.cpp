// SPDX-License-Identifier: Apache-2.0
#include "tools/studio/workspace.hpp"

#include <fmt/format.h>

#include <utility>

#include "mjcf/text/input_error.hpp"
#include "tools/studio/alternatives_json.hpp"
#include "tools/studio/document.hpp"
#include "tools/studio/shown_motion.hpp"
#include "tools/studio/state_json.hpp"

namespace legwright {

using namespace std::chrono_literals;

Workspace::Workspace(WorkspaceBegin begin, EventHub& hub, MeshStore& meshes)
    : robot_(begin.robot), hub_(hub), meshes_(meshes) {
  Session::Options options;
  options.journal = std::move(begin.journal);
  options.commands = std::move(begin.commands);
  session_ = std::make_unique<Session>(begin.robot, begin.text, begin.file, options);
  physics_ = std::make_unique<PhysicsPlayer>(robot_, hub_);
  follower_ = std::thread([this] { follow(); });
}

Workspace::~Workspace() { close(); }

void Workspace::close() {
  session_->close();
  closing_ = true;
  if (follower_.joinable()) follower_.join();
  physics_->close();
}

const std::vector<Handle>& Workspace::handles() {
  std::call_once(handles_once_,
                 [this] { handles_ = find_handles(robot_, robot_.space.initial()); });
  return handles_;
}

Json Workspace::document() {
  const int number = document_;  // first: what follows may be newer, then the page asks once more
  const StatePointer state = session_->snapshot()->state;
  const ModelPointer model = drawn_model(robot_, state->s());
  Json out = document_json(*state, handles(), *model);
  out["document"] = number;
  return out;
}

Json Workspace::design(const SessionState& state) { return design_at(state.s()); }

Json Workspace::design_at(const Eigen::VectorXd& s) {
  for (int i = 0; i < robot_.space.size(); ++i) {
    const DesignParameter& one = robot_.space.parameters[static_cast<std::size_t>(i)];
    if (!(s[i] >= one.lower && s[i] <= one.upper))
      throw InputError(robot_.file.string(), 0, one.name,
                       fmt::format("is to be {}; expected {} to {} {}, its bounds", s[i], one.lower,
                                   one.upper, one.unit));
  }
  const ModelPointer model = drawn_model(robot_, s);
  Json out = drawables_json(*model, meshes_);
  out["handles"] = places_json(handles(), *model);
  return out;
}

void Workspace::check_task(const SessionState& state, int task) const {
  if (task < 0 || task >= state.problem->task_count())
    throw InputError(fmt::format("task {}: expected 0 to {}, the tasks that there are", task,
                                 state.problem->task_count() - 1));
}

Json Workspace::at_bounds(const std::string& name, int task) {
  const StatePointer state = session_->snapshot()->state;
  check_task(*state, task);
  const int i = robot_.space.find(name);
  if (i < 0) throw InputError(fmt::format("'{}' is no design parameter", name));
  const auto at = [&](double value) -> Json {
    Eigen::VectorXd s = state->s();
    s[i] = value;
    const ModelPointer model = drawn_model(robot_, s);
    return {{"value", value},
            {"design", drawables_json(*model, meshes_)},
            {"motion", motion_on_body(*state, task, *model)}};
  };
  return {{"lower", at(state->lower[i])}, {"upper", at(state->upper[i])}};
}

Json Workspace::motion(const SessionState& state, int task) {
  check_task(state, task);
  const ModelPointer model = drawn_model(robot_, state.s());
  return motion_json(state, task, *model);
}

StatePointer Workspace::find(const std::string& name) const {
  const SnapshotPointer snapshot = session_->snapshot();
  if (name.empty()) return snapshot->state;
  const auto found = snapshot->kept.find(name);
  if (found == snapshot->kept.end())
    throw InputError(fmt::format("'{}' is no snapshot; there are {}", name,
                                 snapshot->names.empty()
                                     ? std::string("none yet")
                                     : fmt::format("{}", fmt::join(snapshot->names, ", "))));
  return found->second;
}

void Workspace::follow() {
  std::uint64_t revision = 0, number = 0;
  while (!closing_) {
    const SnapshotPointer snapshot = session_->next_snapshot(revision, 100ms);
    for (const SessionEvent& event : session_->events(number, 0ms)) {
      number = event.number;
      tell(event);
    }
    if (snapshot->revision == revision) continue;
    revision = snapshot->revision;
    try {
      show(*snapshot);
    } catch (const std::exception& error) {  // a body that MuJoCo refuses: the page must know why
      hub_.notice("error", error.what());
    }
  }
}

void Workspace::tell(const SessionEvent& event) {
  using Kind = SessionEvent::Kind;
  if (event.kind == Kind::failed || event.kind == Kind::unsolved) hub_.notice("error", event.words);
  if (event.kind == Kind::worked_out && !event.words.empty())
    hub_.notice("info", "No other designs were worked out: " + event.words);
  if (event.kind == Kind::ended) hub_.notice("info", "Search " + event.words + ".");
  if (event.kind == Kind::point) {
    const StatePointer& now = event.snapshot->state;
    if (last_point_ && last_point_->problem == now->problem)
      hub_.publish("point", to_line(point_json(*last_point_, *now)));
  }
  last_point_ = event.snapshot->state;
}

/// What belongs together goes out together: who follows draws it as one picture. Where a part
/// cannot be told, the parts before it are.
void Workspace::show(const SessionSnapshot& snapshot) {
  const bool first = !model_;
  std::vector<ToldEvent> told;
  try {
    gather(snapshot, told);
  } catch (const std::exception&) {
    hub_.publish(std::move(told));
    throw;
  }
  hub_.publish(std::move(told));
  if (first)  // looking for handles takes a while
    hub_.publish({told_design(snapshot.revision, true)});
}

void Workspace::gather(const SessionSnapshot& snapshot, std::vector<ToldEvent>& told) {
  const SessionState& state = *snapshot.state;
  if (state.problem != problem_) {
    problem_ = state.problem;
    ++document_;
    if (static_cast<std::size_t>(state.problem->task_count()) < motions_) hub_.forget("motion");
  }
  const bool first = !model_;
  if (first || shown_s_ != state.s()) {
    model_ = drawn_model(robot_, state.s());
    shown_s_ = state.s();
    told.push_back(told_design(snapshot.revision, !first));
  }
  physics_->show(snapshot.state);
  if (shown_ != state.now) {
    shown_ = state.now;
    motions_ = static_cast<std::size_t>(state.problem->task_count());
    for (int k = 0; k < state.problem->task_count(); ++k) {
      Json motion = motion_json(state, k, *model_);
      motion["revision"] = snapshot.revision;
      told.push_back({"motion", to_line(motion), fmt::format("motion:{}", k)});
    }
  }
  tell_alternatives(snapshot);
  told.push_back({"state", to_line(state_json(snapshot, document_))});
}

void Workspace::tell_alternatives(const SessionSnapshot& snapshot) {
  if (told_ == snapshot.alternatives) return;
  told_ = snapshot.alternatives;
  for (const AlternativesPointer& each : told_)
    hub_.publish("alternatives", to_line(alternatives_json(*each)),
                 fmt::format("alternatives:{}", to_string(each->kind)));
}

ToldEvent Workspace::told_design(std::uint64_t revision, bool with_handles) {
  Json design = drawables_json(*model_, meshes_);
  design["handles"] = with_handles ? places_json(handles(), *model_) : Json::array();
  design["revision"] = revision;
  return {"design", to_line(design)};
}

}  // namespace legwright
