#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

#include "messages/meet.pb.h"
#include "proto/words/result.h"

namespace telepalp::meet {

/// The relay (TURN) beside the meeting point.
struct RelayDoor {
  std::string address;  ///< IP address, as sites and callers reach it; empty: there is no relay
  std::uint16_t port = 0;
  std::string secret;  ///< the relay and the meeting point have it, and nobody else
};

/// How long credentials hold, and when a site gets newer ones.
inline constexpr std::chrono::minutes kCredentialsHold{60};
inline constexpr std::chrono::minutes kCredentialsRenewed{20};

/// Looks up the relay's name, and reads the secret: the file's first line, of 16 to 256 B. Blocks.
/// Error: the name is unknown or means this computer alone (loopback), or the file holds no such line.
[[nodiscard]] Result<RelayDoor> relay_door(const std::string& host, std::uint16_t port,
                                           const std::filesystem::path& secret_file);

/// Credentials for `who`, made of the secret and of the time when they end, so that the relay needs no list
/// (draft-uberti-behave-turn-rest-00; coturn's use-auth-secret). `tcp_port`: of the meeting point; 0: none.
[[nodiscard]] msg::MeetRelay credentials(const RelayDoor& door, std::string_view who, std::uint16_t tcp_port,
                                         std::chrono::system_clock::time_point now);

}  // namespace telepalp::meet
