#include "proto/link/format/fragment.h"

#include <algorithm>

namespace telepalp::link {
namespace {

constexpr std::size_t kFeedbackBytes = 48;
constexpr std::size_t kMissingBytes = 7;
static_assert(kFeedbackBytes + kMostMissing * kMissingBytes <= kPayloadBytes);

constexpr std::byte kDependsFlag{1};

template <class Number>
Number get(std::span<const std::byte> from, std::size_t at) noexcept {
  return get_little_endian<Number>(&from[at]);
}

std::optional<Missing> read_missing(std::span<const std::byte> from) noexcept {
  const Missing missing{.channel = get<std::uint8_t>(from, 0),
                        .frame = get<std::uint32_t>(from, 1),
                        .block = get<std::uint8_t>(from, 5),
                        .shards = get<std::uint8_t>(from, 6)};
  const bool possible = missing.channel < kMostChannels && missing.shards >= 1 && missing.shards <= kMostDataShards;
  return possible ? std::optional(missing) : std::nullopt;
}

}  // namespace

void write_fragment_header(const FragmentHeader& header, std::span<std::byte, kFragmentHeaderBytes> out) noexcept {
  out[0] = static_cast<std::byte>(PayloadKind::Fragment);
  out[1] = static_cast<std::byte>(header.channel);
  out[2] = header.key_frame ? std::byte{0} : kDependsFlag;
  put_little_endian<std::uint32_t>(&out[3], header.frame);
  put_little_endian<std::uint32_t>(&out[7], header.frame_bytes);
  put_little_endian<std::uint8_t>(&out[11], header.block);
  put_little_endian<std::uint8_t>(&out[12], header.shard);
  put_little_endian<std::uint8_t>(&out[13], header.repair_shards);
  out[14] = std::byte{0};
}

std::optional<Fragment> read_fragment(std::span<const std::byte> payload) noexcept {
  if (payload.size() <= kFragmentHeaderBytes || payload[0] != static_cast<std::byte>(PayloadKind::Fragment))
    return std::nullopt;
  const FragmentHeader header{.channel = get<std::uint8_t>(payload, 1),
                              .key_frame = payload[2] == std::byte{0},
                              .frame = get<std::uint32_t>(payload, 3),
                              .frame_bytes = get<std::uint32_t>(payload, 7),
                              .block = get<std::uint8_t>(payload, 11),
                              .shard = get<std::uint8_t>(payload, 12),
                              .repair_shards = get<std::uint8_t>(payload, 13)};
  if (header.channel >= kMostChannels || (payload[2] & ~kDependsFlag) != std::byte{0} || payload[14] != std::byte{0})
    return std::nullopt;
  if (header.frame_bytes == 0 || header.frame_bytes > kMostFrameBytes) return std::nullopt;
  const FrameLayout layout(header.frame_bytes);
  if (header.block >= layout.blocks || header.shard >= layout.data_in_block(header.block) + kMostRepairShards ||
      header.repair_shards > kMostRepairShards)
    return std::nullopt;
  const std::span<const std::byte> shard = payload.subspan(kFragmentHeaderBytes);
  return shard.size() == layout.shard_bytes ? std::optional(Fragment{header, shard}) : std::nullopt;
}

std::array<std::byte, kPathProbeBytes> write_path_probe(PayloadKind kind, std::uint64_t nonce) noexcept {
  std::array<std::byte, kPathProbeBytes> out{static_cast<std::byte>(kind)};
  put_little_endian<std::uint64_t>(&out[1], nonce);
  return out;
}

std::optional<std::uint64_t> read_path_probe(PayloadKind kind, std::span<const std::byte> payload) noexcept {
  if (payload.size() != kPathProbeBytes || payload[0] != static_cast<std::byte>(kind)) return std::nullopt;
  return get<std::uint64_t>(payload, 1);
}

std::vector<std::byte> write_feedback(const Feedback& feedback) {
  const std::size_t count = std::min(feedback.missing.size(), kMostMissing);
  std::vector<std::byte> out(kFeedbackBytes + count * kMissingBytes);
  out[0] = static_cast<std::byte>(PayloadKind::Feedback);
  put_little_endian<std::uint8_t>(&out[1], static_cast<std::uint8_t>(count));
  put_little_endian<std::uint16_t>(&out[2], feedback.key_frames_wanted);
  put_little_endian<std::uint64_t>(&out[4], feedback.highest_sequence);
  put_little_endian<std::uint64_t>(&out[12], feedback.received_bytes);
  put_little_endian<std::uint64_t>(&out[20], static_cast<std::uint64_t>(feedback.reported_ns));
  put_little_endian<std::uint32_t>(&out[28], feedback.held_us);
  put_little_endian<std::uint32_t>(&out[32], feedback.settled);
  put_little_endian<std::uint32_t>(&out[36], feedback.lost);
  put_little_endian<std::uint32_t>(&out[40], feedback.bursts);
  put_little_endian<std::uint32_t>(&out[44], feedback.age_us);
  for (std::size_t i = 0; i < count; ++i) {
    std::byte* const at = &out[kFeedbackBytes + i * kMissingBytes];
    put_little_endian<std::uint8_t>(at, feedback.missing[i].channel);
    put_little_endian<std::uint32_t>(at + 1, feedback.missing[i].frame);
    put_little_endian<std::uint8_t>(at + 5, feedback.missing[i].block);
    put_little_endian<std::uint8_t>(at + 6, feedback.missing[i].shards);
  }
  return out;
}

std::optional<Feedback> read_feedback(std::span<const std::byte> payload) {
  if (payload.size() < kFeedbackBytes || payload[0] != static_cast<std::byte>(PayloadKind::Feedback))
    return std::nullopt;
  const std::size_t count = get<std::uint8_t>(payload, 1);
  if (count > kMostMissing || payload.size() != kFeedbackBytes + count * kMissingBytes) return std::nullopt;
  Feedback feedback{.highest_sequence = get<std::uint64_t>(payload, 4),
                    .received_bytes = get<std::uint64_t>(payload, 12),
                    .reported_ns = get<std::int64_t>(payload, 20),
                    .held_us = get<std::uint32_t>(payload, 28),
                    .settled = get<std::uint32_t>(payload, 32),
                    .lost = get<std::uint32_t>(payload, 36),
                    .bursts = get<std::uint32_t>(payload, 40),
                    .age_us = get<std::uint32_t>(payload, 44),
                    .key_frames_wanted = get<std::uint16_t>(payload, 2)};
  if (feedback.reported_ns < 0) return std::nullopt;  // differences of such times could overflow
  for (std::size_t i = 0; i < count; ++i) {
    const auto missing = read_missing(payload.subspan(kFeedbackBytes + i * kMissingBytes, kMissingBytes));
    if (!missing) return std::nullopt;
    feedback.missing.push_back(*missing);
  }
  return feedback;
}

}  // namespace telepalp::link
