#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "proto/link/seal/aead.h"
#include "proto/link/seal/packet_format.h"
#include "proto/link/seal/replay_window.h"

namespace telepalp::link {

struct SealSettings {
  Secret session{};          ///< the same at both ends, and used for one session
  std::uint32_t number = 0;  ///< random number of the session, chosen by the server
  Cipher cipher = Cipher::Aes256Gcm;
  /// A key seals at most this many packets. RFC 9001 §6.6 allows AES-GCM 2^23.
  std::uint64_t packets_per_epoch = std::uint64_t{1} << 22U;
};

/// The bytes of one datagram, stored in place without heap memory.
struct Datagram {
  std::array<std::byte, kDatagramBytes> storage;
  std::size_t size = 0;
  [[nodiscard]] std::span<const std::byte> bytes() const noexcept { return {storage.data(), size}; }
};

/// Seals (encrypts and authenticates) the datagrams of one direction. The sequence number counts on across epochs, so
/// that no nonce comes twice.
class Sealer {
 public:
  Sealer(const SealSettings& settings, Direction direction);

  /// Seals the payload, `head` and behind it `tail`, of at most kPayloadBytes together, to `out`, and returns its
  /// sequence number. The payload is read once. nullopt: the last epoch's key is used up, after 2^38 packets with the
  /// default setting; then a new session is needed.
  [[nodiscard]] std::optional<std::uint64_t> seal(std::span<const std::byte> head, std::span<const std::byte> tail,
                                                  Datagram& out);
  [[nodiscard]] std::optional<std::uint64_t> seal(std::span<const std::byte> payload, Datagram& out) {
    return seal(payload, {}, out);
  }

 private:
  [[nodiscard]] bool change_key();

  SealSettings settings_;
  Secret epoch_secret_;
  Aead aead_;
  std::uint16_t epoch_ = 0;
  std::uint64_t sealed_in_epoch_ = 0;
  std::uint64_t sequence_ = 0;
};

struct Opened {
  std::uint64_t sequence = 0;
  bool newest = false;  ///< true: the highest sequence so far. Only then may the packet change the peer's address.
  std::span<const std::byte> payload;  ///< valid until the next open()
};

/// Counters of refused datagrams.
struct OpenerStatistics {
  std::uint64_t malformed = 0;  ///< wrong size, version, session or epoch
  std::uint64_t replayed = 0;
  std::uint64_t forged = 0;  ///< the tag is wrong
};

/// Opens the datagrams of one direction. A refused datagram changes nothing but a counter.
class Opener {
 public:
  Opener(const SealSettings& settings, Direction direction);

  /// nullopt: refused. The caller must not answer.
  [[nodiscard]] std::optional<Opened> open(std::span<const std::byte> datagram);
  [[nodiscard]] const OpenerStatistics& statistics() const noexcept { return statistics_; }

 private:
  struct Epoch {
    std::uint16_t number;
    Secret secret;
    Aead aead;
  };
  [[nodiscard]] Epoch epoch_after(const Epoch& epoch) const;
  [[nodiscard]] Epoch* epoch_of(std::uint16_t number) noexcept;
  void adopt(const Epoch& used);

  SealSettings settings_;
  std::optional<Epoch> previous_;  ///< for packets that were sealed before a key change and arrive after it
  Epoch current_;
  Epoch next_;
  ReplayWindow window_;
  std::array<std::byte, kPayloadBytes> payload_{};
  OpenerStatistics statistics_;
};

}  // namespace telepalp::link
