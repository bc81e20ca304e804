#pragma once

#include <chrono>
#include <cstdint>
#include <string>
#include <string_view>

namespace telepalp::ice {

/// The way that datagrams take, the best first.
enum class PathKind : std::uint8_t {
  Direct,        ///< from address to address: one network, or public addresses
  Punched,       ///< through the routers of both ends, which both ends have opened from inside
  RelayedByUdp,  ///< over a relay
  RelayedByTcp,  ///< over a relay that at least one end reaches by TCP only
};

[[nodiscard]] constexpr bool is_relayed(PathKind kind) noexcept { return kind >= PathKind::RelayedByUdp; }

[[nodiscard]] constexpr std::string_view in_words(PathKind kind) noexcept {
  switch (kind) {
    case PathKind::Direct:
      return "directly from computer to computer";
    case PathKind::Punched:
      return "directly, through the routers of both sites";
    case PathKind::RelayedByUdp:
      return "over a relay (UDP)";
    case PathKind::RelayedByTcp:
      return "over a relay (TCP)";
  }
  return "?";
}

/// The way and its price: "over a relay (UDP), round trip 43 ms".
[[nodiscard]] inline std::string in_words(PathKind kind, std::chrono::nanoseconds round_trip) {
  const auto ms = std::chrono::round<std::chrono::milliseconds>(round_trip).count();
  return std::string(in_words(kind)) + ", round trip " + (ms < 1 ? "below 1" : std::to_string(ms)) + " ms";
}

}  // namespace telepalp::ice
