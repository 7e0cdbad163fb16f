// SPDX-License-Identifier: Apache-2.0
#include "tools/run/verdict_record.hpp"

namespace legwright {

void fields(Fields& f, WorstPart& part) {
  f("kind", part.kind, "\"joint\", \"foot\" or \"body\"");
  f("name", part.name);
  f("value", part.value, "of it alone, in the unit of the row");
  f("time_s", part.time, "when it was so first, or most");
}

void fields(Fields& f, LimitRow& row) {
  f("name", row.name);
  f("what", row.what);
  f("unit", row.unit);
  f.nullable("low", row.low, "least that passes");
  f.nullable("high", row.high, "most that passes");
  f.nullable("value", row.value, "the worst; null where it could not be measured");
  f("where", row.where, "where that was; may be empty");
  f("pass", row.pass);
  std::optional<bool> strict;
  if (row.strict) strict = true;
  f("strict", strict, "the upper bound itself does not pass");
  std::optional<std::vector<WorstPart>> worst;
  if (!row.worst.empty()) worst = row.worst;
  f("worst", worst,
    "joints or feet whose value it is, the worst first; of touches the bodies of the hardest");
  if (f.reads()) {
    row.strict = strict.value_or(false);
    row.worst = worst.value_or(std::vector<WorstPart>{});
  }
}

void fields(Fields& f, DesignVerdict& verdict) {
  f("pass", verdict.pass);
  f("line", verdict.line);
  f("reasons", verdict.reasons, "why it fails, first cause first");
  f("limits", verdict.limits);
}

void fields(Fields& f, HomeTouchRecord& touch) {
  f("first", touch.first);
  f("second", touch.second);
  f("depth_m", touch.depth);
}

void fields(Fields& f, HomeTouchesRecord& touches) {
  f("line", touches.line);
  f("pairs", touches.pairs);
}

void fields(Fields& f, OverriddenRecord::Option& option) {
  f("name", option.name);
  f("file", option.file, "in the robot's file");
  f("scene", option.scene, "in the scene, which was judged");
}

void fields(Fields& f, NeverTouchRecord& never_touch) {
  f("line", never_touch.line);
  f("links", never_touch.links);
}

void fields(Fields& f, OverriddenRecord& overridden) {
  f("line", overridden.line);
  f("options", overridden.options);
}

void fields(Fields& f, NotJudgedRecord& not_judged) {
  f("line", not_judged.line);
  f("limits", not_judged.limits, "as the limits file names them");
}

void fields(Fields& f, VerdictRecord& verdict) {
  f("initial", verdict.initial);
  f("result", verdict.result);
  f("pass", verdict.pass, "of the result");
  f.nullable("home_touches", verdict.home_touches,
             "what of the designed body touches itself in the home pose and did not before");
  f("never_touch", verdict.never_touch,
    "links of the designed body that may pass through others, as none of their shapes collide");
  f("overridden", verdict.overridden,
    "what scenes set otherwise than the robot's file does, of steps, solvers and flags");
  f("not_judged", verdict.not_judged,
    "limits of the file that judge nothing of this task, as those on turning where it goes "
    "straight");
  f("run_status", verdict.run_status,
    "only of a search that did not come to its end: \"interrupted\", \"running\", \"failed\"");
  of_field(f, verdict.of);
  f("with", verdict.with,
    "SHA-256 sums of the other files of this judgement, which stand beside this one");
}

}  // namespace legwright
