#pragma once

#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/steady_timer.hpp>
#include <cstdint>
#include <deque>
#include <functional>
#include <memory>
#include <string>

#include "proto/words/result.h"
#include "support/program/while_alive.h"

namespace telepalp::gateway {

/// Answers GET /health and GET /metrics over plain HTTP on a port of its own, so that a crowded web port does not blind
/// the monitoring. One request for each connection. When there are more than kMostConnections, one is closed, chosen by
/// access::one_to_close(), so strangers who open many connections cannot close that of the monitoring.
/// Owner: the server's network thread.
class HealthPort {
 public:
  struct Options {
    std::string address = "127.0.0.1";
    std::uint16_t port = 0;                  ///< 0: any free one
    std::function<std::string()> problem{};  ///< why the health check fails; empty text: healthy
    std::function<std::string()> metrics{};  ///< text for Prometheus, without names and addresses
  };
  static constexpr std::size_t kMostConnections = 128;

  /// Error: the port cannot be opened.
  [[nodiscard]] static Result<std::unique_ptr<HealthPort>> open(boost::asio::io_context& io, Options options);
  /// Stops listening and closes every connection.
  ~HealthPort();
  HealthPort(const HealthPort&) = delete;
  HealthPort& operator=(const HealthPort&) = delete;

  [[nodiscard]] std::uint16_t port() const noexcept { return port_; }

 private:
  class Check;  // one connection

  HealthPort(boost::asio::ip::tcp::acceptor acceptor, Options options);
  void accept();
  void admit(boost::asio::ip::tcp::socket socket);
  void close_one();

  boost::asio::ip::tcp::acceptor acceptor_;
  boost::asio::steady_timer accept_again_;
  std::shared_ptr<const Options> options_;   // shared with the connections, whose last handler may run later
  std::deque<std::weak_ptr<Check>> checks_;  // oldest first
  std::uint16_t port_ = 0;
  program::WhileAlive alive_;
};

}  // namespace telepalp::gateway
