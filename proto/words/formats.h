#pragma once

#include <cstdint>

namespace telepalp {

// Versions of telepalp's formats. `--version` of every program prints them.

/// Newest version of the protocol in WIRE.md; two programs speak the newest one that both know.
inline constexpr std::uint8_t kWireProtocolVersion = 2;
/// Oldest version of it that is still spoken, with a peer of the release before this one.
inline constexpr std::uint8_t kOldestWireProtocolVersion = 1;
/// Version of a compressed depth packet: the digit after "TPD".
inline constexpr std::uint8_t kDepthPacketVersion = 3;
/// Version of the MCAP specification for session files: the digit in the file's magic bytes.
inline constexpr std::uint8_t kMcapVersion = 0;

}  // namespace telepalp
