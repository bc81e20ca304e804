#include "proto/wire/voice/voice_message.h"

#include <algorithm>

#include "proto/words/voice/voice_packet.h"

namespace telepalp::wire {
namespace {

bool is_packet(const std::string& opus) { return is_voice_packet(std::as_bytes(std::span(opus))); }

}  // namespace

std::optional<msg::VoiceFrame> read_voice_frame(const std::string& payload) {
  msg::VoiceFrame frame;
  if (payload.size() > kMaxVoiceMessageBytes || !frame.ParseFromString(payload)) return std::nullopt;
  frame.DiscardUnknownFields();
  if (frame.begun() > frame.number() || frame.earlier_size() > kMaxEarlierVoicePackets) return std::nullopt;
  if (static_cast<std::uint32_t>(frame.earlier_size()) > frame.number() - frame.begun()) return std::nullopt;
  if (!is_packet(frame.opus()) || !std::ranges::all_of(frame.earlier(), is_packet)) return std::nullopt;
  return frame;
}

}  // namespace telepalp::wire
