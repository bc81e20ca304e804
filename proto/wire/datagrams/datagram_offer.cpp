#include "proto/wire/datagrams/datagram_offer.h"

#include <openssl/rand.h>

#include <cstring>

namespace telepalp::wire {
namespace {

std::optional<link::Cipher> cipher_of(msg::DatagramCipher cipher) noexcept {
  switch (cipher) {
    case msg::DATAGRAM_CIPHER_AES_256_GCM:
      return link::Cipher::Aes256Gcm;
    case msg::DATAGRAM_CIPHER_CHACHA20_POLY1305:
      return link::Cipher::ChaCha20Poly1305;
    default:
      return std::nullopt;
  }
}

KeyingMaterial random_secret() {
  std::array<std::byte, link::Secret::kBytes> secret{};
  if (RAND_bytes(reinterpret_cast<unsigned char*>(secret.data()), static_cast<int>(secret.size())) != 1)
    return std::nullopt;
  return secret;
}

}  // namespace

msg::DatagramCipher quick_cipher() noexcept {
  return link::preferred_cipher() == link::Cipher::Aes256Gcm ? msg::DATAGRAM_CIPHER_AES_256_GCM
                                                             : msg::DATAGRAM_CIPHER_CHACHA20_POLY1305;
}

std::optional<DatagramOffer> make_offer(std::uint32_t session, msg::DatagramCipher wanted,
                                        const KeyingMaterial& from_tls) {
  if (!cipher_of(wanted)) return std::nullopt;
  const bool both_quick = wanted == msg::DATAGRAM_CIPHER_AES_256_GCM && quick_cipher() == wanted;
  const auto agreed = both_quick ? msg::DATAGRAM_CIPHER_AES_256_GCM : msg::DATAGRAM_CIPHER_CHACHA20_POLY1305;
  const KeyingMaterial secret = from_tls ? from_tls : random_secret();
  if (!secret) return std::nullopt;
  DatagramOffer offer{
      .message = {},
      .seal = {.session = link::Secret(*secret), .number = session, .cipher = cipher_of(agreed).value()}};
  offer.message.set_session(session);
  offer.message.set_cipher(agreed);
  if (!from_tls) offer.message.set_secret(secret->data(), secret->size());
  return offer;
}

std::optional<link::SealSettings> accept_offer(const msg::DatagramOffer& offer, const KeyingMaterial& from_tls) {
  const std::optional<link::Cipher> cipher = cipher_of(offer.cipher());
  KeyingMaterial secret = from_tls;
  if (!secret && offer.secret().size() == link::Secret::kBytes)
    std::memcpy(secret.emplace().data(), offer.secret().data(), link::Secret::kBytes);
  if (!cipher || !secret) return std::nullopt;
  return link::SealSettings{.session = link::Secret(*secret), .number = offer.session(), .cipher = *cipher};
}

}  // namespace telepalp::wire
