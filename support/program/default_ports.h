#pragma once

#include <string_view>

namespace telepalp::program {

// Default ports. A test checks that scripts and documents state these values.

/// Default of `telepalp-server --port`, for stations and recorders.
inline constexpr std::string_view kServerPort = "7400";
/// Default of `telepalp-meet --port`: the port of HTTPS, to which a network usually permits connections from inside.
inline constexpr std::string_view kMeetPort = "443";
/// Default of `deploy/demo --http-port`, for browsers.
inline constexpr std::string_view kViewerPort = "8765";
/// Default server address of every client program.
inline constexpr std::string_view kServerAddress = "127.0.0.1:7400";
static_assert(kServerAddress.ends_with(kServerPort));

}  // namespace telepalp::program
