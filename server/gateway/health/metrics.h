#pragma once

#include <string>

#include "server/access/access.h"
#include "server/hub/server_stats.h"

namespace telepalp::gateway {

inline constexpr std::string_view kMetricsTarget = "/metrics";
inline constexpr std::string_view kHealthTarget = "/health";

/// The server's counts as Prometheus text, without names and addresses. `browsers`: open connections to the gateway.
[[nodiscard]] std::string metrics_text(const hub::Hub& hub, const access::Access::Counts& access,
                                       const hub::DatagramCounts& datagrams, std::size_t browsers, bool touch_is_held);

}  // namespace telepalp::gateway
