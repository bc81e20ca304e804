#pragma once

#include <array>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/steady_timer.hpp>
#include <boost/asio/write.hpp>
#include <chrono>
#include <deque>
#include <memory>
#include <string>

namespace telepalp::server {

/// Forwards the bytes between one client and a server on loopback, with a delay in each direction.
class DelayRelay {
 public:
  DelayRelay(boost::asio::io_context& io, std::uint16_t server_port, std::chrono::milliseconds delay)
      : acceptor_(io, {boost::asio::ip::make_address("127.0.0.1"), 0}), client_(io), server_(io), up_(io), down_(io) {
    up_.delay = down_.delay = delay;
    acceptor_.async_accept(client_, [this, server_port](const boost::system::error_code& code) {
      if (code) return;
      server_.connect({boost::asio::ip::make_address("127.0.0.1"), server_port});
      pass_on(client_, server_, up_);
      pass_on(server_, client_, down_);
    });
  }
  /// All that crossed the network, both ways.
  [[nodiscard]] const std::string& overheard() const { return overheard_; }
  [[nodiscard]] std::uint16_t port() const { return acceptor_.local_endpoint().port(); }

 private:
  using Clock = std::chrono::steady_clock;
  struct Way {
    explicit Way(boost::asio::io_context& io) : timer(io) {}
    std::chrono::milliseconds delay{};
    boost::asio::steady_timer timer;
    std::array<char, 65536> buffer{};
    std::deque<std::pair<Clock::time_point, std::string>> waiting;
  };

  void pass_on(boost::asio::ip::tcp::socket& from, boost::asio::ip::tcp::socket& to, Way& way) {
    from.async_read_some(boost::asio::buffer(way.buffer),
                         [this, &from, &to, &way](const boost::system::error_code& code, std::size_t bytes) {
                           if (code) return;
                           overheard_.append(way.buffer.data(), bytes);
                           way.waiting.emplace_back(Clock::now() + way.delay, std::string(way.buffer.data(), bytes));
                           if (way.waiting.size() == 1) release(to, way);
                           pass_on(from, to, way);
                         });
  }
  void release(boost::asio::ip::tcp::socket& to, Way& way) {
    way.timer.expires_at(way.waiting.front().first);
    way.timer.async_wait([this, &to, &way](const boost::system::error_code& code) {
      if (code) return;
      boost::system::error_code ignored;
      boost::asio::write(to, boost::asio::buffer(way.waiting.front().second), ignored);
      way.waiting.pop_front();
      if (!way.waiting.empty()) release(to, way);
    });
  }

  std::string overheard_;
  boost::asio::ip::tcp::acceptor acceptor_;
  boost::asio::ip::tcp::socket client_;
  boost::asio::ip::tcp::socket server_;
  Way up_;
  Way down_;
};

}  // namespace telepalp::server
