#pragma once

#include "messages/station.pb.h"
#include "proto/words/time.h"
#include "server/hub/hub.h"

namespace telepalp::hub {

/// The message of /server/stats with the hub's counts.
[[nodiscard]] msg::ServerStats server_stats(const Hub& hub, SessionTime now);

}  // namespace telepalp::hub
