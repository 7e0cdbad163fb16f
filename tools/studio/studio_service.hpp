// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "tools/run/result_folder.hpp"
#include "tools/session/session.hpp"
#include "tools/studio/allowed_paths.hpp"
#include "tools/studio/assembly_bench.hpp"
#include "tools/studio/carried_design.hpp"
#include "tools/studio/event_hub.hpp"
#include "tools/studio/job_runner.hpp"
#include "tools/studio/kept_sessions.hpp"
#include "tools/studio/opening.hpp"
#include "tools/studio/workspace.hpp"

namespace legwright {

/// What a session that is saved was opened from.
struct SavedFrom {
  std::filesystem::path origin, robot;  // what the user named, and the file of its robot
};

struct StudioOptions {
  std::vector<std::filesystem::path> roots;  // what pages may read and write
  std::filesystem::path state;               // of the user, where sessions are kept
  std::filesystem::path examples;            // empty: none
  std::filesystem::path program;  // `legwright`, for what is done in a process of its own
  /// Writes where a session stands as a run folder; true: in the place of one that is there.
  std::function<void(const SessionRecord&, const std::filesystem::path&, bool, const SavedFrom&)>
      save;
  std::vector<std::string> modules{};  // folders of the user's own, beside those installed
};

/// What stands, and what it is of, for work that goes on when something else is open.
struct WhatStands {
  SessionRecord record;
  SavedFrom from;
  std::string label;  // what its robot is called
};

/// A request to the studio, whoever sent it.
struct StudioRequest {
  std::string method, path;                  // "POST", "/api/command"
  std::map<std::string, std::string> query;  // each key once
  Json body = nullptr;
};

struct StudioReply {
  int status = 200;
  std::string json;
};

/// The studio without its server: what is open, and an answer to each request. Any thread may call.
class StudioService {
 public:
  /// Throws IoError where a root or the state folder cannot be used.
  explicit StudioService(StudioOptions options);
  ~StudioService();
  StudioService(const StudioService&) = delete;
  StudioService& operator=(const StudioService&) = delete;

  /// Opens a robot, a task file, a run or a kept session in the place of what is open. Throws as
  /// open_path().
  void open(const std::string& path);
  /// Every error is a reply.
  StudioReply answer(const StudioRequest& request);
  EventHub& hub() { return hub_; }
  const MeshStore& meshes() const { return meshes_; }
  /// What is open. Throws InputError where nothing is.
  std::shared_ptr<Workspace> workspace() const;

 private:
  using Answer = Json (StudioService::*)(const StudioRequest&);
  static const std::map<std::string, Answer>& answers();

  Json get_start(const StudioRequest& request);
  Json get_free(const StudioRequest& request);
  Json get_document(const StudioRequest& request);
  Json get_design(const StudioRequest& request);
  Json get_bounds(const StudioRequest& request);
  Json get_motion(const StudioRequest& request);
  Json get_compare(const StudioRequest& request);
  Json post_open(const StudioRequest& request);
  Json post_command(const StudioRequest& request);
  Json post_tasks(const StudioRequest& request);
  Json post_save(const StudioRequest& request);
  Json get_shown(const StudioRequest& request);
  Json get_example(const StudioRequest& request);
  Json get_proposal(const StudioRequest& request);
  Json post_proposal(const StudioRequest& request);
  Json post_task(const StudioRequest& request);
  Json post_physics(const StudioRequest& request);
  Json post_judge(const StudioRequest& request);
  Json delete_judge(const StudioRequest& request);
  Json delete_job(const StudioRequest& request);
  Json post_optimize(const StudioRequest& request);
  Json post_report(const StudioRequest& request);
  Json post_export(const StudioRequest& request);
  Json get_modules(const StudioRequest& request);
  Json get_module(const StudioRequest& request);
  Json post_assembly(const StudioRequest& request);
  Json post_assembly_save(const StudioRequest& request);
  Json post_build(const StudioRequest& request);
  Json post_bench(const StudioRequest& request);

  /// Tells the verdict that stands in a run whose design has just been opened.
  void tell_verdict_of(const std::filesystem::path& run);
  /// Remembers what a verdict says of a state, and what was said of one: null where nobody judged.
  void note_verdict(const SessionState& state, const std::string& word);
  Json verdict_on(const SessionState& state) const;
  /// Pauses a search for it. Throws InputError where nothing is open.
  WhatStands standing() const;

  void take(Opening opening);
  std::shared_ptr<Workspace> make_workspace(RobotModel robot, const SessionFolder& folder,
                                            Opening& opening);
  void take_assembly(Opening opening);
  /// A trunk alone, to which modules are put.
  void open_new_assembly();
  const ModuleLibrary& library();
  /// What is assembled. Throws InputError where nothing is.
  std::shared_ptr<AssemblyBench> bench() const;
  /// The robot for which parameters are proposed. Throws InputError where there is none.
  std::filesystem::path proposing() const;
  /// Whether the run in a folder is what stands: saved from here, and nothing changed since.
  bool stands_in(const std::filesystem::path& run) const;
  void save(const WhatStands& what, const std::filesystem::path& run, bool force) const;
  void play(JobRunner& job, const std::filesystem::path& run) const;
  void play_if_it_goes(JobRunner& job, const std::filesystem::path& run);
  void tell_opened();
  bool is_untouched(const SessionSnapshot& last) const;
  /// Closes what is open, and ends the judge of it. A session whose state was saved, or in which
  /// nothing was done, need not be kept.
  void leave();
  /// By mutex_: nothing is on the bench any more.
  void close_bench();

  StudioOptions options_;
  AllowedPaths paths_;
  KeptSessions kept_;
  EventHub hub_;
  MeshStore meshes_;
  std::mutex opening_;  // one at a time
  mutable std::mutex mutex_;
  std::shared_ptr<Workspace> workspace_;  // by mutex_, with what follows
  std::unique_ptr<SessionFolder> folder_;
  std::unique_ptr<ModuleLibrary> library_;  // once it was asked for
  std::shared_ptr<AssemblyBench> bench_;    // also while a robot is open that was built of it
  Opening opened_;
  std::optional<CarriedDesign> carried_;  // of the robot that was built of the bench last
  std::string first_text_;                // of the tasks by the size of that robot
  /// A verdict, as long as its tasks are kept anywhere.
  struct Judged {
    Eigen::VectorXd s;
    std::weak_ptr<const CodesignProblem> problem;
    std::string word;
  };
  std::vector<Judged> judged_;
  StatePointer saved_;              // what was saved last
  StatePointer began_;              // with which the robot was opened
  std::filesystem::path saved_at_;  // the run that holds it
  JobRunner judge_{hub_, "judge"}, jobs_{hub_, "job"};
};

}  // namespace legwright
