#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

#include "messages/control.pb.h"
#include "proto/link/datagram_link.h"

namespace telepalp::wire {

/// Label of the TLS exporter (RFC 8446, 7.5) for the datagrams' secret.
inline constexpr std::string_view kDatagramKeyLabel = "EXPORTER-telepalp-datagrams";

using KeyingMaterial = std::optional<std::array<std::byte, 32>>;

/// The cipher that is quick on this processor, for Hello.
[[nodiscard]] msg::DatagramCipher quick_cipher() noexcept;

/// What both ends of an offer use, and the message that tells the client.
struct DatagramOffer {
  msg::DatagramOffer message;
  link::SealSettings seal;
};

/// A server's offer to a client that named `wanted` in its Hello. AES-256-GCM if it is quick at both ends. `from_tls`:
/// the session's secret; without TLS, which ends on this machine, the offer carries a secret drawn at random. nullopt:
/// the client takes no datagrams, or this machine gives no random bytes.
[[nodiscard]] std::optional<DatagramOffer> make_offer(std::uint32_t session, msg::DatagramCipher wanted,
                                                      const KeyingMaterial& from_tls);

/// The client's side of `offer`; nullopt: it names an unknown cipher, or has no usable secret.
[[nodiscard]] std::optional<link::SealSettings> accept_offer(const msg::DatagramOffer& offer,
                                                             const KeyingMaterial& from_tls);

}  // namespace telepalp::wire
