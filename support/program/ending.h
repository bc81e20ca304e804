#pragma once

#include <chrono>
#include <string_view>

namespace telepalp::program {

/// Time limit for a program to end after a signal.
inline constexpr std::chrono::seconds kTimeToEnd{5};

// A terminal sends Ctrl-C to every program of a script, and the script then signals each program again. A second
// signal therefore has no effect: the program ends when its work is done, or at the time limit.

/// Makes the process print `last_words` to stderr and exit with kFailed after `limit`, unless it has ended before. Only
/// the first call has an effect.
void end_within(std::chrono::seconds limit, std::string_view last_words);

/// Installs handlers of SIGINT and SIGTERM that only call end_within(limit, last_words).
void end_within_when_signalled(std::chrono::seconds limit, std::string_view last_words);

/// Cancels the limit; later signals no longer change the exit code. The last thread calls this when all work is done.
void work_is_done();

}  // namespace telepalp::program
