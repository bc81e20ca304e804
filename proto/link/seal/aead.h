#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>

#include "proto/link/seal/key_schedule.h"

struct evp_cipher_ctx_st;  // OpenSSL's EVP_CIPHER_CTX

namespace telepalp::link {

/// An authenticated cipher with one key, for one direction of use. The nonce is the key's salt XOR the sequence number.
class Aead {
 public:
  enum class Use { Seal, Open };
  Aead(Cipher cipher, const PacketKey& key, Use use);

  using PlainParts = std::array<std::span<const std::byte>, 2>;
  /// Encrypts the parts of `plain`, one behind the other, to `out`, which has kTagBytes more for the tag. The tag
  /// authenticates `plain` and `header`.
  void seal(std::uint64_t sequence, std::span<const std::byte> header, const PlainParts& plain, std::byte* out);
  /// Decrypts `sealed` to `out`, which has kTagBytes less. False: the tag is wrong; `out` is then all zero.
  [[nodiscard]] bool open(std::uint64_t sequence, std::span<const std::byte> header, std::span<const std::byte> sealed,
                          std::byte* out);

 private:
  struct Free {
    void operator()(evp_cipher_ctx_st* context) const noexcept;
  };
  void start(std::uint64_t sequence, std::span<const std::byte> header);

  std::unique_ptr<evp_cipher_ctx_st, Free> context_;
  std::array<std::byte, 12> salt_;
};

}  // namespace telepalp::link
