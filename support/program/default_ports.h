#pragma once

#include <string_view>

namespace telepalp::program {

// The ports of telepalp that a user need not name. A test holds scripts and documents against these.

/// `telepalp-server --port`: stations and recorders.
inline constexpr std::string_view kServerPort = "7400";
/// `deploy/demo --http-port`: browsers.
inline constexpr std::string_view kViewerPort = "8765";
/// Where every program looks for a server.
inline constexpr std::string_view kServerAddress = "127.0.0.1:7400";
static_assert(kServerAddress.ends_with(kServerPort));

}  // namespace telepalp::program
