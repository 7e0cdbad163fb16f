// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "tools/run/record.hpp"

namespace legwright {

struct RunRecord;

/// What a judgement is of: SHA-256 sums of the files that it rests on, by their paths in the run's
/// folder, and under kLimitsSum that of the limits in force.
using JudgedSums = ByName<std::string>;
inline constexpr const char* kLimitsSum = "limits";

/// Of a run of one task: inputs, and of the initial body and of the result the scene, the motion
/// and the robot with all its files. What is not there has no sum, what cannot be read has the word
/// "unreadable" in its place.
JudgedSums sums_of_run(const std::filesystem::path& run);
/// The same without the initial body.
JudgedSums sums_of_result(const std::filesystem::path& run);
/// Of the scene in a design's folder alone, by its name there.
JudgedSums sum_of_scene(const std::filesystem::path& folder);
/// Of a joint run: those of its tasks and of each task's body alone in all of them.
JudgedSums sums_of_joint_run(const std::filesystem::path& root, const RunRecord& run);
/// Of either.
JudgedSums sums_of(const std::filesystem::path& root, const RunRecord& run);

/// How a judgement stands to the result beside it.
enum class Standing {
  of_this,
  of_another,    // the run was replaced, or the file comes from elsewhere
  without_sums,  // an older Legwright wrote it: nobody knows
};
/// @param of what the judgement says of itself @param here sums of what stands in the folder
Standing standing_of(const std::optional<JudgedSums>& of, const JudgedSums& here);

/// What is said in the place of a judgement that is of another result.
inline constexpr const char* kOfAnother = "not of this result: judge again";
/// What is said beside one without sums.
inline constexpr const char* kWithoutSums =
    "without sums: an older Legwright judged, and whether it was this result is not known";

/// What a picture carries (image/picture_origin) of what it shows: JSON as key "of" of judgements.
std::string origin_text(const JudgedSums& of);
/// How a picture stands to what is beside it. @param origin what it carries @param here sums of
/// what stands in the folder, by their paths there; of files that these leave out bytes are read
Standing standing_of_picture(const std::string& origin, const std::filesystem::path& folder,
                             const JudgedSums& here);
/// What is said in the place of a picture of another.
inline constexpr const char* kPictureOfAnother = "not of this result: render again";

/// Whether `with` has the sum of a file's bytes under a name.
bool names_bytes(const JudgedSums& with, const std::string& name,
                 const std::filesystem::path& file);

/// Throws IoError where what stands in a run is not what was loaded from it.
/// @param before its sums when that was @param now its sums now @param what is to be done again
void check_unchanged(const std::filesystem::path& root, const JudgedSums& before,
                     const JudgedSums& now, const char* what = "judge");

/// Key "of" of the files that a judgement consists of.
void of_field(Fields& f, std::optional<JudgedSums>& of);

}  // namespace legwright
