// SPDX-License-Identifier: Apache-2.0
#include "tools/run/schemas.hpp"

#include "tools/files/json_file.hpp"
#include "tools/run/certificate_record.hpp"
#include "tools/run/iteration_record.hpp"
#include "tools/run/matrix_record.hpp"
#include "tools/run/run_record.hpp"

namespace legwright {

std::vector<std::pair<std::string, Json>> record_schemas() {
  return {{"run", schema_of<RunRecord>()},
          {"event_start", schema_of<StartEvent>()},
          {"event_iteration", schema_of<IterationEvent>()},
          {"event_joint_iteration", schema_of<JointIterationEvent>()},
          {"event_end", schema_of<EndEvent>()},
          {"iteration", schema_of<IterationMetrics>()},
          {"certificate", schema_of<CertificateRecord>()},
          {"matrix", schema_of<MatrixRecord>()},
          {"front", schema_of<FrontRecord>()}};
}

}  // namespace legwright
