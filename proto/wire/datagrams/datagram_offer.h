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

/// The fastest cipher on this processor. A client sends it in its Hello.
[[nodiscard]] msg::DatagramCipher quick_cipher() noexcept;

/// A server's offer of datagrams: the message to the client, and the settings that both ends then use.
struct DatagramOffer {
  msg::DatagramOffer message;
  link::SealSettings seal;
};

/// A server's offer to a client that named the cipher `wanted` in its Hello. The cipher is AES-256-GCM if it is the
/// fastest at both ends, else ChaCha20-Poly1305. `from_tls`: the secret of the TLS session. Without TLS both ends are
/// on one machine, and the offer carries a random secret. nullopt: the client takes no datagrams, or the operating
/// system gives no random bytes.
[[nodiscard]] std::optional<DatagramOffer> make_offer(std::uint32_t session, msg::DatagramCipher wanted,
                                                      const KeyingMaterial& from_tls);

/// The settings that a client uses for `offer`; nullopt: an unknown cipher, or no secret from TLS or in `offer`.
[[nodiscard]] std::optional<link::SealSettings> accept_offer(const msg::DatagramOffer& offer,
                                                             const KeyingMaterial& from_tls);

}  // namespace telepalp::wire
