#pragma once

#include <google/protobuf/message_lite.h>

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace telepalp::meet {

/// Version of the protocol between a site and the meeting point.
inline constexpr std::uint32_t kVersion = 1;
/// A connection that begins with these bytes and a call's token is a site's answer to this call. Neither TLS nor HTTP
/// begins like this.
inline constexpr std::string_view kAnswer = "TPMEET1\n";
inline constexpr std::size_t kTokenBytes = 16;
inline constexpr std::size_t kMostFrameBytes = 4096;

/// Each end sends something at least this often, and ends a connection on which nothing came for kSilence.
inline constexpr std::chrono::seconds kBeat{12};
inline constexpr std::chrono::seconds kSilence{25};

/// `message` as it is sent: its length in two bytes, the lower one first, then the message.
[[nodiscard]] std::string framed(const google::protobuf::MessageLite& message);

/// Cuts what has been received into messages.
class FrameReader {
 public:
  void append(std::string_view bytes) { bytes_.append(bytes); }
  /// The next whole message; nullopt: it is not complete yet, or is_bad().
  [[nodiscard]] std::optional<std::string> next();
  /// A message was announced that is larger than kMostFrameBytes.
  [[nodiscard]] bool is_bad() const noexcept { return is_bad_; }

 private:
  std::string bytes_;
  bool is_bad_ = false;
};

}  // namespace telepalp::meet
