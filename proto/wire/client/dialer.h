#pragma once

#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <cstdint>
#include <deque>
#include <functional>
#include <memory>
#include <string>

#include "proto/wire/byte_stream.h"
#include "proto/wire/client/client_timers.h"
#include "proto/wire/tls_stream.h"
#include "proto/words/result.h"

namespace telepalp::wire {

/// Connects a client to its server: looks up the host's name, tries each of its addresses, and secures the connection
/// if there is a key. Owner: the io_context's one thread.
class Dialer {
 public:
  using Endpoint = boost::asio::ip::tcp::endpoint;
  struct Server {
    std::string host;
    std::uint16_t port = 0;
    /// Name of a site that is reached through the meeting point `host`; empty: `host` is the server.
    std::string site{};
    std::shared_ptr<const keys::KeyFile> key;  ///< null: plain TCP, to this machine alone
    [[nodiscard]] std::string text() const {
      return (site.empty() ? "" : site + "@") + host + ":" + std::to_string(port);
    }
    /// The name that the server's certificate must have.
    [[nodiscard]] const std::string& name() const noexcept { return site.empty() ? host : site; }
  };
  /// One of them is called for each dial(), unless hang_up() comes before.
  struct Handlers {
    std::function<void(std::unique_ptr<ByteStream>, const Endpoint& server)> on_connected;
    std::function<void(const std::string& reason)> on_failed;  ///< another attempt may succeed
    std::function<void(const Error& why)> on_refused;          ///< another attempt would fail the same way
  };
  Dialer(boost::asio::io_context& io, Server server, Handlers handlers);

  void dial();
  void hang_up();
  /// False: this computer has lost the address from which it last connected, so that nothing more arrives there.
  [[nodiscard]] bool has_own_address() const;
  /// The server as a user names it, for texts.
  [[nodiscard]] std::string server() const { return server_.text(); }

 private:
  void resolve();
  void connect_next();
  void connected(boost::asio::ip::tcp::socket socket, const Endpoint& server);
  [[nodiscard]] Result<std::unique_ptr<ByteStream>> secured(boost::asio::ip::tcp::socket socket);

  /// Wraps `handler` so that it does nothing once this attempt is over: the io_context may still hold it.
  template <class Handler>
  auto while_dialing(Handler handler) {
    return [attempt = std::weak_ptr<const bool>(attempt_), handler = std::move(handler)](const auto&... arguments) {
      if (!attempt.expired()) handler(arguments...);
    };
  }

  boost::asio::io_context& io_;
  Server server_;
  Handlers handlers_;
  TlsSettings tls_;                      // null before the first connection, and always without a key
  std::shared_ptr<const bool> attempt_;  // pending handlers hold weak_ptrs to it; null: no attempt
  std::deque<Endpoint> untried_;         // further addresses of the host's name
  boost::asio::ip::tcp::resolver resolver_;
  boost::asio::ip::tcp::socket connecting_;
  boost::asio::ip::address own_;  // from which it last connected
  OwnTimer deadline_;
};

}  // namespace telepalp::wire
