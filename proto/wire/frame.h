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

/// Version of WIRE.md that this code speaks: in every frame, and in msg.Hello.
inline constexpr std::uint8_t kProtocolVersion = kWireProtocolVersion;

inline constexpr std::size_t kFrameHeaderBytes = 28;
inline constexpr std::size_t kMaxControlBytes = std::size_t{16} << 10;

/// What a frame's payload is: a serialised msg.Control, or a message of the channel's topic.
enum class FrameKind : std::uint8_t { Control = 1, Data = 2 };

/// The fixed part in front of every payload. Byte table: WIRE.md.
struct FrameHeader {
  std::uint32_t payload_bytes = 0;
  FrameKind kind = FrameKind::Control;
  std::uint64_t sequence = 0;  ///< of the topic at the sender; a gap is a loss
  SessionTime published{};
  std::uint32_t channel = 0;  ///< 0 for control
};

struct Frame {
  FrameHeader header;
  std::string payload;
};

using HeaderBytes = std::array<std::byte, kFrameHeaderBytes>;

[[nodiscard]] HeaderBytes encode_header(const FrameHeader& header) noexcept;

/// The header in `bytes`, if it is of our version, of a known kind, and declares at most `max_payload_bytes`
/// (kMaxControlBytes for control).
[[nodiscard]] Result<FrameHeader> decode_header(const HeaderBytes& bytes, std::size_t max_payload_bytes);

/// Cuts a byte stream into frames, however the stream is split. Holds at most one frame; its payload's room is
/// reserved only after the declared length passed the limit. After an error the stream is out of step: every later
/// call returns that error again.
class FrameParser {
 public:
  explicit FrameParser(std::size_t max_payload_bytes = kMaxPayloadBytes) noexcept
      : max_payload_bytes_(max_payload_bytes) {}

  /// Takes from the front of `bytes` until one frame is whole, and leaves the rest in `bytes`. nullopt: all of
  /// `bytes` is taken and the frame is not whole yet.
  [[nodiscard]] Result<std::optional<Frame>> next(std::span<const std::byte>& bytes);

  /// True once a frame of another protocol version has come. Its error is what next() returns.
  [[nodiscard]] bool met_other_version() const noexcept;

  /// Changes the limit for frames whose header has not come yet.
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
