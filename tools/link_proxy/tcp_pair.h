#pragma once

#include <array>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/steady_timer.hpp>
#include <deque>
#include <functional>
#include <memory>

#include "tools/link_proxy/lines.h"

namespace telepalp::link_proxy {

/// Forwards bytes in both directions between a client's connection and a new connection to the server.
class TcpPair : public std::enable_shared_from_this<TcpPair> {
 public:
  using Socket = boost::asio::ip::tcp::socket;

  TcpPair(boost::asio::io_context& io, std::shared_ptr<Lines> lines, Socket client, std::function<void()> on_closed);
  ~TcpPair();
  /// Connects to the server and starts to forward.
  void start(const boost::asio::ip::tcp::endpoint& server);
  void close();

 private:
  /// One direction: what `from` sends travels over `line` and is written to `to`.
  struct Way {
    Socket& from;
    Socket& to;
    ImpairedLine& line;
    boost::asio::steady_timer room_timer;
    std::array<std::byte, 8192> read_buffer{};
    std::deque<std::vector<std::byte>> to_write{};  ///< an empty segment: end of the stream
    std::size_t on_the_way_B = 0;                   ///< read and not yet written
    bool writing = false;
    bool ended = false;
  };
  void open(Way& way);
  void read(Way& way);
  void send(Way& way, std::size_t bytes);
  void write(Way& way);
  void end_of_stream(Way& way);

  std::shared_ptr<Lines> lines_;  // shared: the handlers of a pair's last reads and writes outlive the proxy
  std::uint64_t flow_;
  Socket client_;
  Socket server_;
  std::function<void()> on_closed_;
  Way up_;
  Way down_;
};

}  // namespace telepalp::link_proxy
