// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <atomic>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "mjcf/read/read_robot.hpp"
#include "tools/drawables/drawn_design.hpp"
#include "tools/session/session.hpp"
#include "tools/studio/event_hub.hpp"
#include "tools/studio/handles.hpp"
#include "tools/studio/physics_player.hpp"

namespace legwright {

/// What a workspace opens.
struct WorkspaceBegin {
  RobotModel robot;
  std::string text;                      // of the task file
  std::filesystem::path file;            // its name, for messages
  std::filesystem::path journal;         // to be written as it goes; or none
  std::vector<SessionCommand> commands;  // to be obeyed first
};

/// A robot on the bench: its session, and a thread that tells the hub of everything that changes,
/// as a page draws it. Any thread may call.
class Workspace {
 public:
  /// Throws as Session does. @param hub must live longer
  Workspace(WorkspaceBegin begin, EventHub& hub, MeshStore& meshes);
  ~Workspace();
  /// Ends session, physics and follower; when it returns, nothing more is told to the hub. Who
  /// still asks the session gets SessionClosed. By one thread at a time.
  void close();
  Workspace(const Workspace&) = delete;
  Workspace& operator=(const Workspace&) = delete;

  Session& session() { return *session_; }
  PhysicsPlayer& physics() { return *physics_; }
  const RobotModel& robot() const { return robot_; }
  /// document_json() of what is there now.
  Json document();
  /// Drawables of a state of the session, with the places of handles.
  Json design(const SessionState& state);
  /// Drawables of another body of the robot. Throws InputError for values outside of the robot's
  /// bounds.
  Json design_at(const Eigen::VectorXd& s);
  /// Of a task of a state. Throws InputError where there is no such task.
  Json motion(const SessionState& state, int task);
  /// The bodies at both bounds of a parameter of the present design, which moves as it does:
  /// {lower, upper: {value, design, motion}}. Throws InputError where there is no such parameter or
  /// task.
  Json at_bounds(const std::string& name, int task);
  /// What was kept under a name; the present under none. Throws InputError where there is none.
  StatePointer find(const std::string& name) const;

 private:
  void check_task(const SessionState& state, int task) const;
  void follow();
  void show(const SessionSnapshot& snapshot);
  void gather(const SessionSnapshot& snapshot, std::vector<ToldEvent>& told);
  void tell(const SessionEvent& event);
  ToldEvent told_design(std::uint64_t revision, bool with_handles);
  void tell_alternatives(const SessionSnapshot& snapshot);
  /// Those of the given body: what they sit on does not depend on the design.
  const std::vector<Handle>& handles();

  RobotModel robot_;
  EventHub& hub_;
  MeshStore& meshes_;
  std::unique_ptr<Session> session_;
  std::unique_ptr<PhysicsPlayer> physics_;
  std::once_flag handles_once_;
  std::vector<Handle> handles_;
  std::atomic<bool> closing_ = false;
  std::atomic<int> document_ = 0;  // counts problems

  // The thread's own.
  std::shared_ptr<const CodesignProblem> problem_;
  std::shared_ptr<const DesignPoint> shown_;
  StatePointer last_point_;
  Eigen::VectorXd shown_s_;
  ModelPointer model_;
  std::size_t motions_ = 0;
  std::vector<AlternativesPointer> told_;  // alternatives
  std::thread follower_;
};

}  // namespace legwright
