#pragma once

#include <string>

#include "server/access/access.h"
#include "server/hub/server_stats.h"

namespace telepalp::gateway {

inline constexpr std::string_view kMetricsTarget = "/metrics";
inline constexpr std::string_view kHealthTarget = "/health";

/// What metrics_text() tells besides the counts of the hub, of access and of datagrams.
struct ServerFacts {
  std::size_t browsers = 0;    ///< open connections to the gateway
  bool touch_is_held = false;  ///< by a doctor's station
  bool is_healthy = true;      ///< /health says `ok`
};

/// The server's counts as Prometheus text, without names and addresses.
[[nodiscard]] std::string metrics_text(const hub::Hub& hub, const access::Access::Counts& access,
                                       const hub::DatagramCounts& datagrams, const ServerFacts& facts);

}  // namespace telepalp::gateway
