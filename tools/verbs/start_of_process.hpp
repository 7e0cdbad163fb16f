// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace legwright {

/// What the program needs before it opens a file: descriptors 0 to 2 are taken, so that no result
/// gets the number of a stream; SIGPIPE and SIGXFSZ are errors of the write instead of ends of the
/// process; and messages that nobody can read any more are dropped, for they must not end a run.
void start_of_process();

/// Writes out what stdout still holds. @return false where not all of it could be written
bool flush_stdout();

}  // namespace legwright
