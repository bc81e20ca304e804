#include "proto/wire/frame.h"

#include <algorithm>
#include <utility>

#include "proto/words/little_endian.h"

namespace telepalp::wire {
namespace {

/// Offsets of WIRE.md's byte table.
constexpr std::size_t kLengthAt = 0;
constexpr std::size_t kVersionAt = 4;
constexpr std::size_t kKindAt = 5;
constexpr std::size_t kFlagsAt = 6;
constexpr std::size_t kSequenceAt = 8;
constexpr std::size_t kPublishedAt = 16;
constexpr std::size_t kChannelAt = 24;

constexpr std::uint16_t kPredictedFlag = 1;

template <class T>
void put(HeaderBytes& bytes, std::size_t at, T value) noexcept {
  put_little_endian<T>(bytes.data() + at, value);
}

template <class T>
T get(const HeaderBytes& bytes, std::size_t at) noexcept {
  return get_little_endian<T>(bytes.data() + at);
}

Error refused(std::string what) {
  return {.what = std::move(what),
          .where = "header of a wire frame",
          .fix = "install the same version of telepalp at both ends; other programs must follow proto/WIRE.md"};
}

std::uint16_t known_flags(std::uint8_t version, std::uint8_t kind) noexcept {
  return version >= kFirstVersionThatMarks && kind == static_cast<std::uint8_t>(FrameKind::Data) ? kPredictedFlag : 0;
}

}  // namespace

std::string spoken_versions() {
  const std::string newest = std::to_string(kProtocolVersion);
  return kOldestProtocolVersion == kProtocolVersion ? newest : std::to_string(kOldestProtocolVersion) + " or " + newest;
}

HeaderBytes encode_header(const FrameHeader& header) noexcept {
  HeaderBytes bytes{};
  put(bytes, kLengthAt, header.payload_bytes);
  put(bytes, kVersionAt, header.version);
  put(bytes, kKindAt, static_cast<std::uint8_t>(header.kind));
  if (header.predicted && header.version >= kFirstVersionThatMarks) put(bytes, kFlagsAt, kPredictedFlag);
  put(bytes, kSequenceAt, header.sequence);
  put(bytes, kPublishedAt, to_nanoseconds(header.published));
  put(bytes, kChannelAt, header.channel);
  return bytes;
}

Result<FrameHeader> decode_header(const HeaderBytes& bytes, std::size_t max_payload_bytes) {
  const auto version = get<std::uint8_t>(bytes, kVersionAt);
  if (!is_spoken(version))
    return refused("it has version " + std::to_string(version) + " of the wire protocol instead of " +
                   spoken_versions());
  const auto kind = get<std::uint8_t>(bytes, kKindAt);
  if (kind != static_cast<std::uint8_t>(FrameKind::Control) && kind != static_cast<std::uint8_t>(FrameKind::Data))
    return refused("its kind " + std::to_string(kind) + " is unknown");
  const auto flags = get<std::uint16_t>(bytes, kFlagsAt);
  if ((flags & ~known_flags(version, kind)) != 0)
    return refused("it sets flags that a frame of kind " + std::to_string(kind) + " does not have in version " +
                   std::to_string(version) + " of the wire protocol");
  const FrameHeader header{.payload_bytes = get<std::uint32_t>(bytes, kLengthAt),
                           .kind = static_cast<FrameKind>(kind),
                           .sequence = get<std::uint64_t>(bytes, kSequenceAt),
                           .published = session_time(get<std::int64_t>(bytes, kPublishedAt)),
                           .channel = get<std::uint32_t>(bytes, kChannelAt),
                           .version = version,
                           .predicted = (flags & kPredictedFlag) != 0};
  const std::size_t most =
      header.kind == FrameKind::Control ? std::min(kMaxControlBytes, max_payload_bytes) : max_payload_bytes;
  if (header.payload_bytes > most)
    return refused("it declares a payload of " + std::to_string(header.payload_bytes) + " B, but at most " +
                   std::to_string(most) + " B are accepted");
  if ((header.kind == FrameKind::Control) != (header.channel == 0))
    return refused("channel " + std::to_string(header.channel) +
                   " does not fit its kind: a control frame has channel 0, a data frame another channel");
  return header;
}

bool FrameParser::met_other_version() const noexcept {
  return failed_ && header_filled_ == kFrameHeaderBytes && !is_spoken(get<std::uint8_t>(header_bytes_, kVersionAt));
}

Result<std::optional<Frame>> FrameParser::next(std::span<const std::byte>& bytes) {
  if (failed_) return *failed_;
  if (!header_) {
    const std::size_t taken = std::min(bytes.size(), kFrameHeaderBytes - header_filled_);
    std::copy_n(bytes.begin(), taken, header_bytes_.begin() + static_cast<std::ptrdiff_t>(header_filled_));
    header_filled_ += taken;
    bytes = bytes.subspan(taken);
    if (header_filled_ < kFrameHeaderBytes) return std::optional<Frame>{};
    const Result<FrameHeader> header = decode_header(header_bytes_, max_payload_bytes_);
    if (!header) {
      failed_ = header.error();
      return *failed_;
    }
    header_ = *header;
    payload_.reserve(header_->payload_bytes);  // only reserves: memory pages that are never written cost nothing
  }
  const std::size_t taken = std::min(bytes.size(), header_->payload_bytes - payload_.size());
  payload_.append(reinterpret_cast<const char*>(bytes.data()), taken);
  bytes = bytes.subspan(taken);
  if (payload_.size() < header_->payload_bytes) return std::optional<Frame>{};
  header_filled_ = 0;
  return std::optional<Frame>{Frame{*std::exchange(header_, std::nullopt), std::exchange(payload_, {})}};
}

}  // namespace telepalp::wire
