// SPDX-License-Identifier: Apache-2.0
#include "tools/run/schemas.hpp"

#include "tools/files/json_file.hpp"
#include "tools/run/certificate_record.hpp"
#include "tools/run/checkpoint_file.hpp"
#include "tools/run/comparison_record.hpp"
#include "tools/run/engine_record.hpp"
#include "tools/run/iteration_record.hpp"
#include "tools/run/matrix_record.hpp"
#include "tools/run/metrics_record.hpp"
#include "tools/run/numerics_record.hpp"
#include "tools/run/picture_diff_record.hpp"
#include "tools/run/robustness_record.hpp"
#include "tools/run/run_record.hpp"
#include "tools/run/strength_record.hpp"
#include "tools/run/verdict_record.hpp"

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
          {"front", schema_of<FrontRecord>()},
          {"validation", schema_of<MetricsRecord>()},
          {"verdict", schema_of<VerdictRecord>()},
          {"comparison", schema_of<ComparisonRecord>()},
          {"numerics", schema_of<NumericsRecord>()},
          {"robustness", schema_of<RobustnessRecord>()},
          {"strength", schema_of<StrengthRecord>()},
          {"engine_validation", schema_of<EngineRecord>()},
          {"checkpoint", schema_of<CheckpointBegin>()},
          {"picture_diff", schema_of<PictureDiffRecord>()}};
}

}  // namespace legwright
