#include "server/meet/words/meet_frames.h"

#include "proto/words/demand.h"
#include "proto/words/little_endian.h"

namespace telepalp::meet {

std::string framed(const google::protobuf::MessageLite& message) {
  const std::string text = message.SerializeAsString();
  demand(text.size() <= kMostFrameBytes, "what the meeting point and a site say is short");
  std::string bytes;
  append_little_endian<std::uint16_t>(bytes, static_cast<std::uint16_t>(text.size()));
  return bytes + text;
}

std::optional<std::string> FrameReader::next() {
  if (is_bad_ || bytes_.size() < sizeof(std::uint16_t)) return std::nullopt;
  const std::size_t length = get_little_endian<std::uint16_t>(bytes_.data());
  is_bad_ = length > kMostFrameBytes;
  if (is_bad_ || bytes_.size() < sizeof(std::uint16_t) + length) return std::nullopt;
  std::string message = bytes_.substr(sizeof(std::uint16_t), length);
  bytes_.erase(0, sizeof(std::uint16_t) + length);
  return message;
}

}  // namespace telepalp::meet
