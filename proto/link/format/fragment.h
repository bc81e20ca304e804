#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "proto/link/seal/packet_format.h"

namespace telepalp::link {

/// First byte of the payload of a sealed (encrypted and authenticated) datagram.
enum class PayloadKind : std::uint8_t { Fragment = 1, Feedback = 2, PathChallenge = 3, PathResponse = 4 };

inline constexpr std::size_t kFragmentHeaderBytes = 15;
inline constexpr std::size_t kMostShardBytes = kPayloadBytes - kFragmentHeaderBytes;
inline constexpr std::size_t kMostFrameBytes = std::size_t{8} << 20U;
inline constexpr std::uint8_t kMostChannels = 16;
/// Largest numbers of data shards and of repair shards in a block: 255 together. The Cauchy matrix over GF(2^8), from
/// which repair shards are computed, allows 256.
inline constexpr std::size_t kMostDataShards = 128;
inline constexpr std::size_t kMostRepairShards = 127;

/// How a frame of a given size is cut into data shards of one size. Shard i belongs to block i modulo `blocks`, so that
/// a loss burst hits all blocks. Each block has its own repair shards. Both ends compute the layout from the size.
struct FrameLayout {
  std::size_t data_shards = 1;
  std::size_t shard_bytes = 1;
  std::size_t blocks = 1;

  explicit FrameLayout(std::size_t frame_bytes) noexcept
      : data_shards((frame_bytes + kMostShardBytes - 1) / kMostShardBytes),
        shard_bytes((frame_bytes + data_shards - 1) / data_shards),
        blocks((data_shards + kMostDataShards - 1) / kMostDataShards) {}

  [[nodiscard]] std::size_t data_in_block(std::size_t block) const noexcept {
    return (data_shards - block + blocks - 1) / blocks;
  }
  /// Offset of the data shard in the frame [B]. Zeros pad the frame to data_shards * shard_bytes.
  [[nodiscard]] std::size_t offset(std::size_t block, std::size_t shard) const noexcept {
    return (shard * blocks + block) * shard_bytes;
  }
};

/// The header of a fragment; one shard follows it.
struct FragmentHeader {
  std::uint8_t channel = 0;       ///< below kMostChannels
  bool key_frame = true;          ///< false: the frame needs frame `frame - 1` of the channel
  std::uint32_t frame = 0;        ///< counts the frames of the channel at the source
  std::uint32_t frame_bytes = 0;  ///< size of the frame with its capture time (frame_body.h), 1 to kMostFrameBytes
  std::uint8_t block = 0;
  std::uint8_t shard = 0;          ///< below the block's number of data shards: a data shard; else: a repair shard
  std::uint8_t repair_shards = 0;  ///< number of repair shards per block that are sent with the data
};

/// A received fragment; `shard` has FrameLayout::shard_bytes bytes and lies in the payload given to read_fragment().
struct Fragment {
  FragmentHeader header;
  std::span<const std::byte> shard;
};

void write_fragment_header(const FragmentHeader& header, std::span<std::byte, kFragmentHeaderBytes> out) noexcept;
/// nullopt: `payload` is no fragment, or its fields contradict each other or its size.
[[nodiscard]] std::optional<Fragment> read_fragment(std::span<const std::byte> payload) noexcept;

/// A block that cannot be decoded yet, because shards of it are missing.
struct Missing {
  std::uint8_t channel = 0;
  std::uint32_t frame = 0;
  std::uint8_t block = 0;
  std::uint8_t shards = 0;  ///< number of further shards, data or repair, that the block needs
  bool operator==(const Missing&) const = default;
};

/// A receiver's report to the sender. Counters count from the start of the session.
struct Feedback {
  std::uint64_t highest_sequence = 0;   ///< highest sequence number received
  std::uint64_t received_bytes = 0;     ///< bytes of all received datagrams
  std::int64_t reported_ns = 0;         ///< session time, which is never negative
  std::uint32_t held_us = 0;            ///< time from the arrival of datagram `highest_sequence` until this report
  std::uint32_t settled = 0;            ///< packets that have arrived or are counted as lost
  std::uint32_t lost = 0;               ///< packets that are counted as lost
  std::uint32_t bursts = 0;             ///< runs of lost packets
  std::uint32_t age_us = 0;             ///< age of the newest delivered frame at its delivery
  std::uint16_t key_frames_wanted = 0;  ///< bit n: channel n needs a key frame
  std::vector<Missing> missing{};       ///< at most kMostMissing
  bool operator==(const Feedback&) const = default;
};
inline constexpr std::size_t kMostMissing = 100;

/// Payload of a PathChallenge, and of the PathResponse that repeats its nonce: it shows that the peer receives
/// datagrams at the address to which the challenge was sent (RFC 9000 §8.2).
inline constexpr std::size_t kPathProbeBytes = 9;
[[nodiscard]] std::array<std::byte, kPathProbeBytes> write_path_probe(PayloadKind kind, std::uint64_t nonce) noexcept;
/// The nonce; nullopt: `payload` is not of this `kind`.
[[nodiscard]] std::optional<std::uint64_t> read_path_probe(PayloadKind kind,
                                                           std::span<const std::byte> payload) noexcept;

[[nodiscard]] std::vector<std::byte> write_feedback(const Feedback& feedback);
[[nodiscard]] std::optional<Feedback> read_feedback(std::span<const std::byte> payload);

}  // namespace telepalp::link
