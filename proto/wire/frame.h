#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include "proto/wire/message.h"
#include "proto/words/formats.h"
#include "proto/words/result.h"

namespace telepalp::wire {

/// The versions of the protocol in WIRE.md that this end speaks.
inline constexpr std::uint8_t kProtocolVersion = kWireProtocolVersion;
inline constexpr std::uint8_t kOldestProtocolVersion = kOldestWireProtocolVersion;

[[nodiscard]] constexpr bool is_spoken(std::uint32_t version) noexcept {
  return version >= kOldestProtocolVersion && version <= kProtocolVersion;
}
/// "1 or 2", for errors.
[[nodiscard]] std::string spoken_versions();

/// The first version whose data frames say whether they are predicted.
inline constexpr std::uint8_t kFirstVersionThatMarks = 2;

inline constexpr std::size_t kFrameHeaderBytes = 28;
inline constexpr std::size_t kMaxControlBytes = std::size_t{16} << 10;

/// Type of a frame's payload: a serialised msg.Control, or a message of the channel's topic.
enum class FrameKind : std::uint8_t { Control = 1, Data = 2 };

/// The fixed-size header before each payload. WIRE.md has the byte table.
struct FrameHeader {
  std::uint32_t payload_bytes = 0;
  FrameKind kind = FrameKind::Control;
  std::uint64_t sequence = 0;  ///< number within the topic, given by the sender; a gap means lost messages
  SessionTime published{};
  std::uint32_t channel = 0;                      ///< 0 for control
  std::uint8_t version = kOldestProtocolVersion;  ///< before both ends know the newest common version, the oldest
  bool predicted =
      false;  ///< decoding needs the topic's message before this one. Not sent below kFirstVersionThatMarks
};

struct Frame {
  FrameHeader header;
  std::string payload;
};

using HeaderBytes = std::array<std::byte, kFrameHeaderBytes>;

[[nodiscard]] HeaderBytes encode_header(const FrameHeader& header) noexcept;

/// Decodes a header. Error: a protocol version that is not spoken, an unknown kind, a flag that the version does not
/// have, a control frame with a channel or a data frame without one, or a payload above `max_payload_bytes` (control:
/// above kMaxControlBytes, too).
[[nodiscard]] Result<FrameHeader> decode_header(const HeaderBytes& bytes, std::size_t max_payload_bytes);

/// Splits a byte stream into frames; the stream may arrive in pieces of any size. Buffers at most one frame. Memory for
/// a payload is reserved only once the declared length is known to be allowed. After an error the frame boundaries are
/// lost, so every later call returns the same error.
class FrameParser {
 public:
  explicit FrameParser(std::size_t max_payload_bytes = kMaxPayloadBytes) noexcept
      : max_payload_bytes_(max_payload_bytes) {}

  /// Consumes bytes from the front of `bytes` until one frame is complete; the rest stays in `bytes`. nullopt: all
  /// bytes were consumed and the frame is still incomplete.
  [[nodiscard]] Result<std::optional<Frame>> next(std::span<const std::byte>& bytes);

  /// True once a frame of a protocol version that is not spoken has come. next() then returns its error.
  [[nodiscard]] bool met_other_version() const noexcept;

  /// Changes the payload limit for later frames [B].
  void set_max_payload_bytes(std::size_t most) noexcept { max_payload_bytes_ = most; }

 private:
  std::size_t max_payload_bytes_;
  HeaderBytes header_bytes_{};
  std::size_t header_filled_ = 0;
  std::optional<FrameHeader> header_;
  std::string payload_;
  std::optional<Error> failed_;
};

}  // namespace telepalp::wire
