#pragma once

#include <array>
#include <boost/asio/ip/udp.hpp>
#include <boost/asio/steady_timer.hpp>
#include <map>
#include <memory>

#include "tools/link_proxy/lines.h"

namespace telepalp::link_proxy {

/// Forwards datagrams between clients and the server through the impaired lines (lines.h). Each client address gets a
/// socket of its own towards the server, as a NAT does, until the client has sent nothing for a minute.
class UdpProxy {
 public:
  UdpProxy(boost::asio::io_context& io, Lines& lines, boost::asio::ip::udp::endpoint server);
  ~UdpProxy();

  [[nodiscard]] boost::system::error_code listen(const boost::asio::ip::udp::endpoint& at);
  [[nodiscard]] std::size_t clients() const noexcept { return clients_.size(); }
  void stop();

 private:
  struct Client;
  void read();
  void read_answers(const std::shared_ptr<Client>& client);
  [[nodiscard]] std::shared_ptr<Client> client_at(const boost::asio::ip::udp::endpoint& address);
  void close(Client& client);
  void forget_silent();

  boost::asio::io_context& io_;
  Lines& lines_;
  boost::asio::ip::udp::endpoint server_;
  boost::asio::ip::udp::socket socket_;
  boost::asio::steady_timer sweep_;
  boost::asio::ip::udp::endpoint sender_;
  std::array<std::byte, 65536> buffer_{};
  std::map<boost::asio::ip::udp::endpoint, std::shared_ptr<Client>> clients_;  // shared with a client's reads
};

}  // namespace telepalp::link_proxy
