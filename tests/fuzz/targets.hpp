// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

namespace legwright::test {

// Each takes any bytes and tells whether the reader accepts them, not only refuses. What breaks a
// promise leaves as an exception, or ends the process.

/// Numbers of robots and of trajectories: refused, or the same bits when written and read again.
bool fuzz_numbers(std::string_view text);
/// A task file: an InputError at the file, or tasks whose text can be changed and read again.
bool fuzz_toml(std::string_view text);
/// A document: discarded, or the same when written and read again.
bool fuzz_json(std::string_view text);
/// Lines of a run's events and of a session: an InputError at the file, or commands that are the
/// same when written and read again. Lines get their checksum, but for those that begin with `!`.
bool fuzz_journal(std::string_view text);
/// A trajectory, perhaps behind a line `!PERIOD X Y Z TURN`: a TrajectoryError, or the same bits
/// when written and read again.
bool fuzz_trajectory(std::string_view text);
/// A robot's MJCF: an InputError at the file, or a robot whose file can be rewritten.
bool fuzz_robot(std::string_view text);
/// A Collada file: an InputError at the file, or finite triangles that can be drawn, the same each
/// time.
bool fuzz_collada(std::string_view text);
/// A URDF: an InputError at the file, or an MJCF that is read or refused likewise.
bool fuzz_urdf(std::string_view text);

}  // namespace legwright::test
