// SPDX-License-Identifier: Apache-2.0
#include "tools/run/engine_record.hpp"

namespace legwright {

void fields(Fields& f, EngineRecord& record) {
  f("engine", record.engine);
  f("engine_version", record.version);
  f("task", record.task);
  f("cycles", record.cycles, "of each roll-out");
  f("timestep_s", record.timestep, "between moments that are measured");
  f("limits", record.limits, "what passes");
  f("versions", record.versions, "of the program that measured and judged");
  f("passes", record.passes, "by servo gains: the verdict on that roll-out alone");
  f("verdict", record.verdict, "on all gains together");
  f("result", record.result, "what was measured, by servo gains");
  of_field(f, record.of);
}

std::string engine_file(const std::string& engine) { return "validation_" + engine + ".json"; }

}  // namespace legwright
