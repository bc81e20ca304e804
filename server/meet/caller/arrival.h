#pragma once

#include <boost/asio/ip/tcp.hpp>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <variant>

#include "server/access/unproven.h"
#include "server/meet/caller/client_hello.h"

namespace telepalp::meet {

/// What the first bytes of a connection show: a caller or a site that begins with TLS, a site's answer to a call, or
/// somebody who wants the relay.
struct AnswerToCall {
  std::string token;
};
struct WantsRelay {};
using Arrived = std::variant<ClientHello, AnswerToCall, WantsRelay>;

/// True if `bytes` begin a request to a relay (STUN, RFC 8489 §5). Neither TLS nor HTTP begins with a zero.
[[nodiscard]] inline bool is_for_relay(std::string_view bytes) noexcept {
  using namespace std::string_view_literals;
  return bytes.size() >= 8 && bytes[0] == '\0' && bytes.substr(4, 4) == "\x21\x12\xA4\x42"sv;
}

/// A connection of which nothing is known yet. It reads until its first bytes show what it is; Meet closes it
/// after 5 s.
class Arrival : public std::enable_shared_from_this<Arrival> {
 public:
  /// `bytes`: all that was read, from the first byte on; empty for an answer, behind whose token nothing was read.
  using Known = std::function<void(const Arrived&, boost::asio::ip::tcp::socket, std::string bytes)>;

  Arrival(boost::asio::ip::tcp::socket socket, access::Unproven who) : socket_(std::move(socket)), who_(who) {}
  /// `known` is called at most once: not if the connection ends, shows nothing, or is closed.
  void start(Known known);
  void close();
  [[nodiscard]] const access::Unproven& who() const noexcept { return who_; }

 private:
  void read();
  void look();

  boost::asio::ip::tcp::socket socket_;
  access::Unproven who_;
  std::string bytes_;
  Known known_;
};

}  // namespace telepalp::meet
