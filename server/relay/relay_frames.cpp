#include "server/relay/relay_frames.h"

#include <algorithm>
#include <utility>

#include "proto/words/demand.h"
#include "proto/words/little_endian.h"

namespace telepalp::relay {
namespace {

constexpr std::string_view kMagic = "TPR1";
constexpr std::uint16_t kKeyFlag = 1;

struct PartHeader {
  std::uint64_t sequence = 0;
  std::int64_t published_ns = 0;
  std::uint16_t flags = 0;
  std::uint16_t part = 0;
  std::uint16_t parts = 0;
  std::uint32_t whole_B = 0;
};

void append(std::string& bytes, const PartHeader& header) {
  bytes += kMagic;
  append_little_endian<std::uint64_t>(bytes, header.sequence);
  append_little_endian<std::int64_t>(bytes, header.published_ns);
  append_little_endian<std::uint16_t>(bytes, header.flags);
  append_little_endian<std::uint16_t>(bytes, header.part);
  append_little_endian<std::uint16_t>(bytes, header.parts);
  append_little_endian<std::uint16_t>(bytes, 0);
  append_little_endian<std::uint32_t>(bytes, header.whole_B);
}

std::optional<PartHeader> header_of(std::string_view part) {
  if (part.size() < kPartHeaderBytes || !part.starts_with(kMagic)) return std::nullopt;
  const char* const at = part.data() + kMagic.size();
  const PartHeader header{.sequence = get_little_endian<std::uint64_t>(at),
                          .published_ns = get_little_endian<std::int64_t>(at + 8),
                          .flags = get_little_endian<std::uint16_t>(at + 16),
                          .part = get_little_endian<std::uint16_t>(at + 18),
                          .parts = get_little_endian<std::uint16_t>(at + 20),
                          .whole_B = get_little_endian<std::uint32_t>(at + 24)};
  const bool fits = header.sequence > 0 && header.part < header.parts && header.whole_B <= wire::kMaxPayloadBytes;
  return fits ? std::optional(header) : std::nullopt;
}

}  // namespace

PartCutter::PartCutter(std::size_t most_B) : room_B_(most_B - kPartHeaderBytes) {
  demand(most_B >= kLeastPartBytes, "a part has room for its header and some bytes");
}

bool PartCutter::cut(const wire::Message& message, const std::function<bool(std::string_view part)>& on_part) {
  const std::string_view payload = *message.payload;
  const std::size_t count = std::max<std::size_t>(1, (payload.size() + room_B_ - 1) / room_B_);
  for (std::size_t i = 0; i < count; ++i) {
    part_.clear();
    append(part_, {.sequence = message.sequence,
                   .published_ns = static_cast<std::int64_t>(to_nanoseconds(message.published)),
                   .flags = message.key_frame ? kKeyFlag : std::uint16_t{0},
                   .part = static_cast<std::uint16_t>(i),
                   .parts = static_cast<std::uint16_t>(count),
                   .whole_B = static_cast<std::uint32_t>(payload.size())});
    part_ += payload.substr(std::min(payload.size(), i * room_B_), room_B_);
    if (!on_part(part_)) return false;
  }
  return true;
}

std::optional<wire::Message> PartJoiner::add(const wire::Topic& topic, std::string_view part) {
  const std::optional<PartHeader> header = header_of(part);
  const bool is_key = header && (header->flags & kKeyFlag) != 0;
  if (!header || (!is_key && !topic.predicted)) {
    ++malformed_;
    return std::nullopt;
  }
  Growing& growing = growing_[topic.name];
  const bool continues =
      header->sequence == growing.sequence && header->part == growing.next_part && header->whole_B == growing.whole_B;
  if (header->part == 0) {
    if (growing.next_part > 0) ++incomplete_;
    growing = {.sequence = header->sequence, .whole_B = header->whole_B};
    growing.payload.reserve(header->whole_B);
  } else if (!continues) {
    if (growing.next_part > 0) ++incomplete_;
    growing = {};
    return std::nullopt;
  }
  part.remove_prefix(kPartHeaderBytes);
  if (growing.payload.size() + part.size() > growing.whole_B) {
    ++malformed_;
    growing = {};
    return std::nullopt;
  }
  growing.payload += part;
  if (++growing.next_part < header->parts) return std::nullopt;
  Growing whole = std::exchange(growing, {});
  if (whole.payload.size() != whole.whole_B) {
    ++malformed_;
    return std::nullopt;
  }
  return wire::Message{topic, SessionTime{Nanoseconds{header->published_ns}},
                       std::make_shared<const std::string>(std::move(whole.payload)), header->sequence, is_key};
}

}  // namespace telepalp::relay
