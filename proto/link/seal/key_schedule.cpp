#include "proto/link/seal/key_schedule.h"

#include <openssl/crypto.h>
#include <openssl/evp.h>
#include <openssl/hmac.h>

#include <algorithm>
#include <string>

#include "proto/words/demand.h"

namespace telepalp::link {

Secret::~Secret() { OPENSSL_cleanse(bytes_.data(), bytes_.size()); }

Cipher preferred_cipher() noexcept {
#if defined(__x86_64__)
  return __builtin_cpu_supports("aes") ? Cipher::Aes256Gcm : Cipher::ChaCha20Poly1305;
#else
  return Cipher::ChaCha20Poly1305;
#endif
}

Secret expand(const Secret& secret, std::string_view label) {
  const std::string info = std::string(label) + '\x01';
  std::array<std::byte, Secret::kBytes> out{};
  unsigned int size = 0;
  const unsigned char* done = HMAC(EVP_sha256(), secret.bytes().data(), static_cast<int>(secret.bytes().size()),
                                   reinterpret_cast<const unsigned char*>(info.data()), info.size(),
                                   reinterpret_cast<unsigned char*>(out.data()), &size);
  demand(done != nullptr && size == out.size(), "OpenSSL computes an HMAC-SHA256 of 32 bytes");
  const Secret expanded(out);
  OPENSSL_cleanse(out.data(), out.size());
  return expanded;
}

Secret first_epoch(const Secret& session, Direction direction, Cipher cipher) {
  return expand(session, std::string("telepalp link 1 ") +
                             (direction == Direction::ClientToServer ? "client to server " : "server to client ") +
                             (cipher == Cipher::Aes256Gcm ? "AES-256-GCM" : "ChaCha20-Poly1305"));
}

Secret next_epoch(const Secret& epoch) { return expand(epoch, "telepalp link 1 next epoch"); }

PacketKey packet_key(const Secret& epoch) {
  PacketKey key{.key = expand(epoch, "telepalp link 1 key")};
  const Secret salt = expand(epoch, "telepalp link 1 salt");
  std::copy_n(salt.bytes().begin(), key.salt.size(), key.salt.begin());
  return key;
}

}  // namespace telepalp::link
