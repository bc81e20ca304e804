#pragma once

#include "proto/words/result.h"
#include "tests/bench/report.h"

namespace telepalp::bench {

/// Rows of speech over an impaired link: from the mouth, through a hub, its sockets and telepalp-link's proxy, to the
/// ear of a client with a jitter buffer. In real time.
[[nodiscard]] Result<void> add_voice_rows(Report& report);

}  // namespace telepalp::bench
