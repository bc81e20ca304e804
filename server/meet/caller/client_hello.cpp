#include "server/meet/caller/client_hello.h"

#include <algorithm>
#include <cctype>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

namespace telepalp::meet {
namespace {

using Bytes = std::span<const std::byte>;

constexpr std::uint8_t kHandshakeRecord = 22, kClientHello = 1, kHostName = 0;
constexpr std::size_t kServerNameExtension = 0, kAlpnExtension = 16;
constexpr std::size_t kRecordHeader = 5, kHandshakeHeader = 4, kLargestRecord = 1 << 14;
constexpr std::size_t kVersionAndRandom = 34;
constexpr std::size_t kLongestName = 255;

/// Takes numbers and blocks from the front of bytes. After a failure everything it gives is empty.
class Front {
 public:
  explicit Front(Bytes bytes) : bytes_(bytes) {}

  [[nodiscard]] bool failed() const noexcept { return failed_; }
  [[nodiscard]] bool at_end() const noexcept { return failed_ || bytes_.empty(); }
  Bytes take(std::size_t count) {
    failed_ = failed_ || count > bytes_.size();
    if (failed_) return {};
    const Bytes taken = bytes_.first(count);
    bytes_ = bytes_.subspan(count);
    return taken;
  }
  /// A number of `bytes` bytes, the highest first.
  std::size_t number(std::size_t bytes) {
    std::size_t value = 0;
    for (const std::byte byte : take(bytes)) value = value << 8U | std::to_integer<std::size_t>(byte);
    return value;
  }
  /// A block whose length stands before it in `bytes` bytes.
  Bytes block(std::size_t bytes) { return take(number(bytes)); }

 private:
  Bytes bytes_;
  bool failed_ = false;
};

std::string text_of(Bytes bytes) {
  std::string text;
  for (const std::byte byte : bytes) text += static_cast<char>(std::tolower(std::to_integer<int>(byte)));
  return text;
}

std::string name_in(Front names) {
  Front list(names.block(2));
  while (!list.at_end()) {
    const std::size_t kind = list.number(1);
    const Bytes name = list.block(2);
    if (kind == kHostName && !list.failed() && name.size() <= kLongestName) return text_of(name);
  }
  return {};
}

bool offers_http(Front protocols) {
  Front list(protocols.block(2));
  bool found = false;
  while (!list.at_end()) {
    const std::string protocol = text_of(list.block(1));
    found = found || protocol == "h2" || protocol == "http/1.1";
  }
  return found;
}

/// The handshake message that begins in `bytes`, put together from its records; nullopt: more bytes are needed.
/// `is_tls` becomes false if it cannot be a ClientHello.
std::optional<std::vector<std::byte>> first_message(Bytes bytes, bool& is_tls) {
  std::vector<std::byte> message;
  for (Bytes rest = bytes;;) {
    if (!rest.empty() && std::to_integer<std::uint8_t>(rest[0]) != kHandshakeRecord) is_tls = false;
    if (rest.size() > 1 && std::to_integer<std::uint8_t>(rest[1]) != 3) is_tls = false;
    if (!is_tls || rest.size() < kRecordHeader) return std::nullopt;
    const std::size_t length = Front(rest.subspan(3)).number(2);
    if (length == 0 || length > kLargestRecord) is_tls = false;
    const Bytes body = rest.subspan(kRecordHeader, std::min(length, rest.size() - kRecordHeader));
    message.insert(message.end(), body.begin(), body.end());
    if (!message.empty() && std::to_integer<std::uint8_t>(message[0]) != kClientHello) is_tls = false;
    if (!is_tls) return std::nullopt;
    if (message.size() >= kHandshakeHeader) {
      const std::size_t whole = kHandshakeHeader + Front(Bytes(message).subspan(1)).number(3);
      if (whole > kMostHelloBytes) is_tls = false;
      if (message.size() >= whole) return message.resize(whole), message;
    }
    if (!is_tls || body.size() < length) return std::nullopt;
    rest = rest.subspan(kRecordHeader + length);
  }
}

}  // namespace

HelloRead read_client_hello(Bytes bytes) {
  using State = HelloRead::State;
  bool is_tls = true;
  const std::optional<std::vector<std::byte>> message = first_message(bytes, is_tls);
  if (!is_tls || (!message && bytes.size() >= kMostHelloBytes)) return {State::NotTls, {}};
  if (!message) return {State::Incomplete, {}};
  Front body(Bytes(*message).subspan(kHandshakeHeader));
  body.take(kVersionAndRandom);
  body.block(1);  // session
  body.block(2);  // cipher suites
  body.block(1);  // compression
  Front extensions(body.at_end() ? Bytes{} : body.block(2));
  ClientHello hello;
  while (!extensions.at_end()) {
    const std::size_t kind = extensions.number(2);
    const Front content(extensions.block(2));
    if (kind == kServerNameExtension) hello.server_name = name_in(content);
    if (kind == kAlpnExtension) hello.speaks_http = offers_http(content);
  }
  if (body.failed() || extensions.failed()) return {State::NotTls, {}};
  return {State::Whole, std::move(hello)};
}

}  // namespace telepalp::meet
