#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "messages/voice.pb.h"

namespace telepalp::wire {

/// The most earlier packets in a message: with them, six lost messages in a row lose no sound. At 24 kbit/s of Opus a
/// microphone then needs 0.17 Mbit/s.
inline constexpr int kMaxEarlierVoicePackets = 6;

/// Largest payload of a message of speech: seven of the largest packets, with their heads and the other fields.
inline constexpr std::size_t kMaxVoiceMessageBytes = 2'900;

/// Parses a message of /patient/voice or /doctor/voice; nullopt when it is too large or malformed, one of its packets
/// is not one that is_voice_packet(), it has more earlier packets than frames since `begun`, or `begun` is above
/// `number`. Unknown fields are removed.
[[nodiscard]] std::optional<msg::VoiceFrame> read_voice_frame(const std::string& payload);

}  // namespace telepalp::wire
