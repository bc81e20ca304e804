#pragma once

#include <cstddef>
#include <vector>

#include "proto/words/time.h"

namespace telepalp::impaired {

/// The impairments of one direction of a link.
struct Impairment {
  Nanoseconds delay{0};        ///< propagation, one way
  Nanoseconds jitter{0};       ///< the delay varies uniformly by -jitter to jitter, and is never negative
  double loss = 0.0;           ///< share of packets that are lost, 0 to 1
  double burst_packets = 1.0;  ///< mean number of packets in a loss burst; 1: independent losses
  double reorder = 0.0;        ///< share of packets that arrive later by `reorder_by`
  Nanoseconds reorder_by = std::chrono::milliseconds(10);
  double duplicate = 0.0;         ///< share of packets that arrive twice
  double corrupt = 0.0;           ///< share of packets that arrive with one bit inverted
  double rate_B_per_s = 0.0;      ///< rate of the bottleneck; 0: unlimited
  std::size_t queue_B = 262'144;  ///< size of the bottleneck's queue; a packet that does not fit is dropped
  Nanoseconds outage_every{0};    ///< period of outages; 0: no outage
  Nanoseconds outage_for{0};      ///< each period ends with an outage of this duration
};

/// One row of a trace: delay, jitter, loss and rate of a measured path, valid from `at`, counted from the trace's
/// beginning, until the next row.
struct TraceRow {
  Nanoseconds at{0};
  Nanoseconds delay{0};
  Nanoseconds jitter{0};
  double loss = 0.0;
  double rate_B_per_s = 0.0;  ///< 0: outage
};
/// Rows in order of time, the first at 0. The last row only marks the end, from which the first row is valid again.
using Trace = std::vector<TraceRow>;

}  // namespace telepalp::impaired
