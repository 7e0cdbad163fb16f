// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "tools/run/judged_sums.hpp"
#include "tools/run/record.hpp"

namespace legwright {

/// A joint, foot or body that a value is of.
struct WorstPart {
  std::string kind, name;            // "joint", "foot" or "body"
  std::optional<double> value = {};  // of it alone, in the unit of the row
  std::optional<double> time = {};   // when it was so first, or most [s]
};

/// A value against its limit: a row of the verdict.
struct LimitRow {
  std::string name, what, unit;
  std::optional<double> low, high;  // what passes
  std::optional<double> value;      // the worst; absent where it could not be measured
  std::string where;                // "half gains", where that is
  bool pass = false;
  bool strict = false;                // the upper bound itself does not pass
  std::vector<WorstPart> worst = {};  // whose value it is, the worst first
};

/// What was judged of one design. It passes when all limits are kept.
struct DesignVerdict {
  bool pass = false;
  std::string line;                  // "PASS  trot forward at 0.100 m/s: …"
  std::vector<std::string> reasons;  // why it fails, first cause first
  std::vector<LimitRow> limits;      // in the order in which they were judged
};

/// Two geoms of the designed body that meet in its home pose and did not before.
struct HomeTouchRecord {
  std::string first, second;
  double depth = 0.0;  // [m]
};
struct HomeTouchesRecord {
  std::string line;
  std::vector<HomeTouchRecord> pairs;
};

/// Links of the designed body that MuJoCo lets pass through the others, as none of their shapes
/// collide: whether they touch is asked of none of them.
struct NeverTouchRecord {
  std::string line;
  std::vector<std::string> links;
};

/// What the scene sets otherwise than the <option> of the robot's file.
struct OverriddenRecord {
  struct Option {
    std::string name, file, scene;  // as both are written in MJCF
  };
  std::string line;
  std::vector<Option> options;
};

/// Limits of the file by which nothing was judged: of a straight way those on turning, say.
struct NotJudgedRecord {
  std::string line;
  std::vector<std::string> limits;
};

/// result/verdict.json.
struct VerdictRecord {
  static constexpr RecordKind kKind{"legwright/verdict", 1, "validate"};
  DesignVerdict initial, result;
  bool pass = false;  // of the result
  std::optional<HomeTouchesRecord> home_touches;
  std::optional<NeverTouchRecord> never_touch = {};  // absent where all links may touch
  std::optional<OverriddenRecord> overridden = {};   // absent where the file sets nothing otherwise
  std::optional<NotJudgedRecord> not_judged = {};    // absent where each limit of the file judges
  std::optional<std::string> run_status = {};        // of a search that did not come to its end
  std::optional<JudgedSums> of = {};                 // what was judged; absent in older files
  std::optional<JudgedSums> with = {};  // SHA-256 of the other files of the judgement, by name
};

void fields(Fields& f, WorstPart& part);
void fields(Fields& f, DesignVerdict& verdict);
void fields(Fields& f, NeverTouchRecord& never_touch);
void fields(Fields& f, OverriddenRecord& overridden);
void fields(Fields& f, NotJudgedRecord& not_judged);
void fields(Fields& f, VerdictRecord& verdict);

}  // namespace legwright
