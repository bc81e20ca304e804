#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace telepalp::gateway {

/// Counts the fragments of a WebSocket message in the bytes as they arrive (RFC 6455, 5.2). Beast joins fragments by
/// itself and limits only their bytes, so that a client could send empty ones without end. Pure.
class FragmentCount {
 public:
  static constexpr std::size_t kMost = 64;  ///< fragments of one message; browsers send most messages in one fragment

  /// Takes the next `size` bytes of the stream. False: a message has more than kMost fragments.
  [[nodiscard]] bool take(const std::uint8_t* bytes, std::size_t size) noexcept {
    while (size > 0) {
      if (payload_left_ > 0) {
        const auto skipped = static_cast<std::size_t>(std::min<std::uint64_t>(payload_left_, size));
        payload_left_ -= skipped;
        bytes += skipped;
        size -= skipped;
        continue;
      }
      header_[header_bytes_++] = *bytes++;
      --size;
      if (header_bytes_ < 2 || header_bytes_ < header_size()) continue;
      payload_left_ = payload_size();
      header_bytes_ = 0;
      if (!count()) return false;
    }
    return true;
  }

 private:
  static constexpr std::uint8_t kFinal = 0x80;
  static constexpr std::uint8_t kControl = 0x08;
  static constexpr std::uint8_t kMasked = 0x80;

  [[nodiscard]] std::size_t length_bytes() const noexcept {
    const unsigned length = header_[1] & 0x7FU;
    return length == 127 ? 8 : length == 126 ? 2 : 0;
  }
  [[nodiscard]] std::size_t header_size() const noexcept {
    return 2 + length_bytes() + ((header_[1] & kMasked) != 0 ? 4 : 0);
  }
  [[nodiscard]] std::uint64_t payload_size() const noexcept {
    if (length_bytes() == 0) return header_[1] & 0x7FU;
    std::uint64_t size = 0;
    for (std::size_t at = 0; at < length_bytes(); ++at) size = (size << 8U) | header_[2 + at];
    return size;
  }
  /// Counts the frame of the present header. Control frames may come between fragments.
  [[nodiscard]] bool count() noexcept {
    if ((header_[0] & kControl) != 0) return true;
    fragments_ = (header_[0] & kFinal) != 0 ? 0 : fragments_ + 1;
    return fragments_ < kMost;
  }

  std::uint8_t header_[14]{};
  std::size_t header_bytes_ = 0;
  std::uint64_t payload_left_ = 0;
  std::size_t fragments_ = 0;  // of the message that is being sent
};

}  // namespace telepalp::gateway
