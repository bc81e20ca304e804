#pragma once

#include <array>
#include <atomic>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/udp.hpp>
#include <boost/asio/post.hpp>
#include <functional>
#include <future>
#include <optional>
#include <string>
#include <thread>
#include <utility>

#include "tests/server/delay_relay.h"

namespace telepalp::bad_input {

/// An attacker on the path between a station and its server: TCP passes, and each datagram goes through a function that
/// may send it, alter it or keep it. It runs on a thread of its own.
class UdpTap {
 public:
  using udp = boost::asio::ip::udp;
  enum class To { Server, Station };
  /// Called on the tap's thread with each datagram.
  using Carry = std::function<void(UdpTap&, To, const std::string&)>;

  explicit UdpTap(std::uint16_t server_port)
      : tcp_(io_, server_port, {}),
        server_(loopback(server_port)),
        at_station_(io_, loopback(tcp_.port())),
        at_server_(io_, loopback(0)) {
    read(at_station_, station_buffer_, To::Server);
    read(at_server_, server_buffer_, To::Station);
    thread_ = std::thread([this] {
      while (!ended_) io_.run_for(std::chrono::milliseconds(20));
    });
  }
  ~UdpTap() {
    ended_ = true;
    thread_.join();
  }
  UdpTap(const UdpTap&) = delete;
  UdpTap& operator=(const UdpTap&) = delete;

  /// The port to which the station connects.
  [[nodiscard]] std::uint16_t port() const { return tcp_.port(); }
  [[nodiscard]] std::uint64_t carried(To to) const { return to == To::Server ? to_server_ : to_station_; }

  void set_carry(Carry carry) {
    std::promise<void> done;
    boost::asio::post(io_, [&] {
      carry_ = std::move(carry);
      done.set_value();
    });
    done.get_future().wait();
  }
  /// On the tap's thread alone.
  void send(To to, const std::string& datagram) {
    boost::system::error_code lost;
    if (to == To::Server) at_server_.send_to(boost::asio::buffer(datagram), server_, 0, lost);
    if (to == To::Station && station_) at_station_.send_to(boost::asio::buffer(datagram), *station_, 0, lost);
  }

 private:
  using Buffer = std::array<char, 2048>;
  static udp::endpoint loopback(std::uint16_t port) { return {boost::asio::ip::make_address("127.0.0.1"), port}; }

  void read(udp::socket& socket, Buffer& buffer, To to) {
    socket.async_receive_from(boost::asio::buffer(buffer), from_,
                              [this, &socket, &buffer, to](const boost::system::error_code& code, std::size_t bytes) {
                                if (code == boost::asio::error::operation_aborted) return;
                                if (!code) pass({buffer.data(), bytes}, to);
                                read(socket, buffer, to);
                              });
  }
  void pass(const std::string& datagram, To to) {
    if (to == To::Server) station_ = from_;
    ++(to == To::Server ? to_server_ : to_station_);
    if (carry_) return carry_(*this, to, datagram);
    send(to, datagram);
  }

  boost::asio::io_context io_;
  server::DelayRelay tcp_;
  udp::endpoint server_;
  udp::socket at_station_;
  udp::socket at_server_;
  udp::endpoint from_;
  std::optional<udp::endpoint> station_;
  Buffer station_buffer_{};
  Buffer server_buffer_{};
  Carry carry_;
  std::atomic<std::uint64_t> to_server_{0};
  std::atomic<std::uint64_t> to_station_{0};
  std::atomic<bool> ended_{false};
  std::thread thread_;
};

}  // namespace telepalp::bad_input
