// SPDX-License-Identifier: Apache-2.0
#include "tools/run/robustness_record.hpp"

namespace legwright {

void fields(Fields& f, RobustnessFactor& factor) {
  f("name", factor.name);
  f("label", factor.label);
  f("unit", factor.unit);
  f("nominal", factor.nominal);
  f.nullable("low", factor.low, "last value that walks; null: walks at all that was tested");
  f.nullable("high", factor.high);
  f.nullable("low_fails", factor.low_fails, "first value that does not walk");
  f.nullable("high_fails", factor.high_fails);
  f("tested_low", factor.tested_low);
  f("tested_high", factor.tested_high);
  f.nullable("low_cause", factor.low_cause, "why it fails");
  f.nullable("high_cause", factor.high_cause);
  f("rollouts", factor.rollouts);
}

void fields(Fields& f, FailedDraw& draw) {
  f("sample", draw.sample);
  f("cause", draw.cause);
  f("time_s", draw.seconds, "simulated until then");
  f("values", draw.values, "of the factors");
}

void fields(Fields& f, MonteCarlo& drawn) {
  f("samples", drawn.samples);
  f("survived", drawn.survived);
  f("share", drawn.share);
  f("share_low", drawn.share_low, "95 % interval of the share by Wilson");
  f("share_high", drawn.share_high);
  f("spread", drawn.spread, "from which each factor was drawn");
  f("causes", drawn.causes, "of failing, and how many walks each");
  f("worst", drawn.worst, "walks that failed first");
}

void fields(Fields& f, RobustnessRecord& robustness) {
  f("cycles", robustness.cycles, "of each roll-out");
  f("seed", robustness.seed);
  f.nullable("seconds", robustness.seconds, "null, so that equal runs are equal bytes");
  f.nullable("undisturbed_cause", robustness.undisturbed_cause,
             "where it fails undisturbed; then the rest is empty");
  f("factors", robustness.factors, "one varied at a time");
  f("monte_carlo", robustness.monte_carlo, "all drawn at once");
  of_field(f, robustness.of);
}

}  // namespace legwright
