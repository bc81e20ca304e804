#pragma once

#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/steady_timer.hpp>
#include <memory>
#include <set>

#include "tools/link_proxy/lines.h"

namespace telepalp::link_proxy {

class TcpPair;

/// Accepts TCP connections and joins each to a new connection to the server, through the impaired lines. The proxy
/// terminates both connections: a simulated loss delays a stream by a round trip, and does not shrink a TCP congestion
/// window. While 256 connections are open, a further one is closed at once.
class TcpProxy {
 public:
  TcpProxy(boost::asio::io_context& io, std::shared_ptr<Lines> lines, boost::asio::ip::tcp::endpoint server);
  ~TcpProxy();

  [[nodiscard]] boost::system::error_code listen(const boost::asio::ip::tcp::endpoint& at);
  [[nodiscard]] std::uint16_t port() const { return acceptor_.local_endpoint().port(); }
  [[nodiscard]] std::size_t connections() const noexcept { return pairs_.size(); }
  void stop();

 private:
  void accept();
  void accept_later();
  void join(boost::asio::ip::tcp::socket client);

  boost::asio::io_context& io_;
  std::shared_ptr<Lines> lines_;  // shared with the pairs
  boost::asio::ip::tcp::endpoint server_;
  boost::asio::ip::tcp::acceptor acceptor_;
  boost::asio::steady_timer accept_again_;
  std::set<std::shared_ptr<TcpPair>> pairs_;  // shared with the handlers of a pair's reads and writes
};

}  // namespace telepalp::link_proxy
