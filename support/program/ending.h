#pragma once

#include <chrono>
#include <string_view>

namespace telepalp::program {

/// How long a program that was asked to end may take.
inline constexpr std::chrono::seconds kTimeToEnd{5};

// A terminal sends Ctrl-C to every program of a script, and the script then asks each again: the second signal means
// the same as the first. So what bounds the ending is time, and not the number of signals.

/// The process exits with kFailed `limit` from now, unless it has ended by itself. Of several calls the first counts.
void end_within(std::chrono::seconds limit, std::string_view last_words);

/// From now on SIGINT and SIGTERM call end_within(limit, last_words), and do nothing else.
void end_within_when_signalled(std::chrono::seconds limit, std::string_view last_words);

/// All work is done: the limit is lifted, and no signal changes the exit code any more. For the last thread.
void work_is_done();

}  // namespace telepalp::program
