#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace telepalp::link {

/// 32 secret bytes, for example from the TLS exporter (RFC 8446 §7.5). Overwritten when destroyed.
class Secret {
 public:
  static constexpr std::size_t kBytes = 32;
  Secret() = default;
  explicit Secret(const std::array<std::byte, kBytes>& bytes) noexcept : bytes_(bytes) {}
  Secret(const Secret&) = default;
  Secret& operator=(const Secret&) = default;
  ~Secret();
  [[nodiscard]] const std::array<std::byte, kBytes>& bytes() const noexcept { return bytes_; }

 private:
  std::array<std::byte, kBytes> bytes_{};
};

/// Both ciphers have keys of 32, nonces of 12 and tags of 16 bytes.
enum class Cipher { Aes256Gcm, ChaCha20Poly1305 };
/// AES-256-GCM on an x86-64 processor with AES instructions, else ChaCha20-Poly1305.
[[nodiscard]] Cipher preferred_cipher() noexcept;

enum class Direction { ClientToServer, ServerToClient };

struct PacketKey {
  Secret key;
  std::array<std::byte, 12> salt{};  ///< nonce: the salt, its bytes 4 to 11 XOR the datagram's number (little-endian)
};

/// HKDF-Expand of RFC 5869 with SHA-256, for one block: HMAC(secret, label followed by the byte 1).
[[nodiscard]] Secret expand(const Secret& secret, std::string_view label);

/// The traffic secret of epoch 0 in one direction. An epoch is the period in which one key is used.
[[nodiscard]] Secret first_epoch(const Secret& session, Direction direction, Cipher cipher);
/// The traffic secret of the next epoch. The secret of an epoch cannot be computed from that of a later one.
[[nodiscard]] Secret next_epoch(const Secret& epoch);
[[nodiscard]] PacketKey packet_key(const Secret& epoch);

}  // namespace telepalp::link
