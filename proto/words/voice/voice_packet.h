#pragma once

#include <chrono>
#include <cstddef>
#include <span>

namespace telepalp {

/// A frame of speech, as telepalp transports it: 20 ms of one channel at 48 kHz.
inline constexpr int kVoiceRate_hz = 48'000;
inline constexpr std::size_t kVoiceFrameSamples = 960;
inline constexpr std::chrono::milliseconds kVoiceFrameTime{20};

/// The most bytes of one coded frame: 160 kbit/s, several times what speech needs.
inline constexpr std::size_t kMaxVoicePacketBytes = 400;

/// True if `packet` has the size and the first byte of an Opus packet with one frame of 20 ms of one channel (RFC 6716
/// §3.1: configuration, stereo bit, count of frames). The rest of the packet is not read.
[[nodiscard]] constexpr bool is_voice_packet(std::span<const std::byte> packet) noexcept {
  if (packet.empty() || packet.size() > kMaxVoicePacketBytes) return false;
  const auto first = std::to_integer<unsigned>(packet.front());
  const unsigned configuration = first >> 3U;
  const bool is_stereo = (first & 4U) != 0;
  const bool is_one_frame = (first & 3U) == 0;
  // Table 2: SILK (0 to 11) has 10, 20, 40 and 60 ms; hybrid (12 to 15) 10 and 20; CELT (16 to 31) 2.5, 5, 10 and 20.
  const bool is_20_ms = configuration < 12   ? configuration % 4 == 1
                        : configuration < 16 ? configuration % 2 == 1
                                             : configuration % 4 == 3;
  return is_20_ms && !is_stereo && is_one_frame;
}

}  // namespace telepalp
