// SPDX-License-Identifier: Apache-2.0
// A host as people write them, built against one release of MuJoCo: loads the plugin by path, then
// compiles a model, steps it and prints where its arm is. Usage: version_host PLUGIN MODEL
#include <mujoco/mujoco.h>

#include <cstdio>
#include <cstdlib>

namespace {

constexpr int kSteps = 250;

void print_and_end(const mjLogMessage* message) {
  if (message->level == mjLOG_WARNING) std::printf("warning: %s\n", message->subject);
  if (message->level != mjLOG_ERROR) return;
  std::printf("error: %s\n", message->subject);
  std::exit(1);
}

}  // namespace

int main(int count, char** arguments) {
  if (count != 3) return std::printf("usage: version_host PLUGIN MODEL\n"), 2;
  std::printf("MuJoCo %s\n", mj_versionString());
  if (mj_version() != mjVERSION_HEADER) return std::printf("headers of another MuJoCo\n"), 3;
  mju_setLogHandler(print_and_end);
  mj_loadPluginLibrary(arguments[1]);
  char error[1000] = "";
  mjModel* const model = mj_loadXML(arguments[2], nullptr, error, sizeof error);
  if (model == nullptr) return std::printf("model: %s\n", error), 1;
  mjData* const data = mj_makeData(model);
  for (int step = 0; step < kSteps; ++step) mj_step(model, data);
  std::printf("elbow %.4f after %.3f s\n", data->qpos[0], data->time);
  mj_deleteData(data);
  mj_deleteModel(model);
  return 0;
}
