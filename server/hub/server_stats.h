#pragma once

#include "messages/station.pb.h"
#include "proto/words/time.h"
#include "server/hub/hub.h"

namespace telepalp::server {

/// The hub's counts as /server/stats carries them.
[[nodiscard]] msg::ServerStats server_stats(const Hub& hub, SessionTime now);

}  // namespace telepalp::server
