#pragma once

#include "proto/words/result.h"

namespace telepalp::bench {

/// What a direct path adds to a datagram's time from one end to the other, against plain UDP sockets on loopback in the
/// same thread.
struct PathDelay {
  double plain_p99_ms = 0.0;
  double path_p99_ms = 0.0;
};

/// Sends 4000 datagrams of 1200 B by each way, in turn, one each 0.5 ms. Takes about 5 s.
/// Error: no path was found, or datagrams are missing.
[[nodiscard]] Result<PathDelay> measure_path_delay();

}  // namespace telepalp::bench
