#pragma once

#include <cstdint>
#include <string>

#include "messages/control.pb.h"
#include "proto/ice/words/candidate.h"
#include "proto/words/result.h"

namespace telepalp::ice {

/// A relay (TURN, RFC 8656), which also tells an end its address outside (STUN).
struct Relay {
  std::string address;         ///< IP address
  std::uint16_t port = 0;      ///< UDP; 0: none
  std::uint16_t tcp_port = 0;  ///< 0: none
  std::string user;
  std::string password;
};

/// Reads the relay that a server or a meeting point names. Error: its address is none, or may_check() forbids it, or
/// its ports or credentials are too large. The error's text has no byte of the sender but a valid address.
[[nodiscard]] Result<Relay> read_relay(const msg::IceRelay& message, Reach reach);

}  // namespace telepalp::ice
