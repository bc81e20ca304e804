#pragma once

#include "messages/station.pb.h"
#include "proto/words/time.h"
#include "server/hub/datagrams/datagram_counts.h"
#include "server/hub/hub.h"

namespace telepalp::hub {

/// The message of /server/stats with the hub's counts.
[[nodiscard]] msg::ServerStats server_stats(const Hub& hub, const DatagramCounts& datagrams, SessionTime now);

}  // namespace telepalp::hub
