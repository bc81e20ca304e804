#pragma once

#include <span>

#include "proto/wire/message.h"

namespace telepalp::station {

/// Processor time [us] that a station's network thread takes on average to receive one of `images` by sealed datagrams:
/// reading the socket, decrypting, joining, and the reports to the sender. Measured over this computer's loopback,
/// where waking the thread for a datagram is left out.
[[nodiscard]] double receiving_us(std::span<const wire::Message> images);

}  // namespace telepalp::station
