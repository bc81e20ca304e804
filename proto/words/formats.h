#pragma once

#include <cstdint>

namespace telepalp {

// Versions of telepalp's formats. `--version` of every program prints them.

/// Version of the protocol in WIRE.md; sent in every network frame and in msg.Hello.
inline constexpr std::uint8_t kWireProtocolVersion = 1;
/// Version of a compressed depth packet: the digit after "TPD".
inline constexpr std::uint8_t kDepthPacketVersion = 3;
/// Version of the MCAP specification for session files: the digit in the file's magic bytes.
inline constexpr std::uint8_t kMcapVersion = 0;

}  // namespace telepalp
