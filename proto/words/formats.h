#pragma once

#include <cstdint>

namespace telepalp {

// Versions of telepalp's formats. `--version` of every program prints them.

/// Newest version of the protocol in WIRE.md; two programs speak the newest one that both know.
inline constexpr std::uint8_t kWireProtocolVersion = 2;
/// Oldest version of it that is still spoken, with a peer of the release before this one.
inline constexpr std::uint8_t kOldestWireProtocolVersion = 1;
/// Newest version of a compressed depth packet: the digit after "TPD". Only packets with a window need it; the encoder
/// writes all others as the oldest version, so that earlier releases read them.
inline constexpr std::uint8_t kDepthPacketVersion = 4;
/// Oldest version of a depth packet that is still read.
inline constexpr std::uint8_t kOldestDepthPacketVersion = 3;
/// Version of the MCAP specification for session files: the digit in the file's magic bytes.
inline constexpr std::uint8_t kMcapVersion = 0;

}  // namespace telepalp
