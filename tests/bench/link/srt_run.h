#pragma once

#include "tests/bench/link/link_scenario.h"

namespace telepalp::bench::link {

/// SRT in live mode between two sockets, through telepalp-link's proxy, in real time. Encryption and retransmission are
/// on. Its latency is what remains of the deadline after encoding and the path's delay. Its threads and the proxy's
/// have real-time priority where it is permitted: on a busy machine, SRT would otherwise miss its deadlines by the load
/// alone.
[[nodiscard]] Outcome run_srt(const Scenario& scenario);

}  // namespace telepalp::bench::link
