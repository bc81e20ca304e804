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

/// For a program that SIGINT, SIGTERM or SIGHUP ends at once: the handlers write `sentence` to stderr, and the signal
/// then ends the process as it would without them, so that a shell sees exit code 128 + signal. The sentence says what
/// was kept; a later call replaces it, when more is kept. Call it from one thread. `sentence` is cut after 399 bytes.
void say_when_stopped(std::string_view sentence);

/// Cancels the limit; later signals no longer change the exit code. The last thread calls this when all work is done.
void work_is_done();

}  // namespace telepalp::program
