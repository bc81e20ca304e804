#pragma once

#include <cstdint>

namespace telepalp {

// Versions of the formats that telepalp speaks. `--version` of every program prints them.

/// Of WIRE.md: in every frame on the network, and in msg.Hello.
inline constexpr std::uint8_t kWireProtocolVersion = 1;
/// Of a compressed depth packet: the digit after "TPD".
inline constexpr std::uint8_t kDepthPacketVersion = 3;
/// Of the MCAP specification that session files follow: the digit in the file's magic.
inline constexpr std::uint8_t kMcapVersion = 0;

}  // namespace telepalp
