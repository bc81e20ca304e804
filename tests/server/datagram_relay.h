#pragma once

#include <boost/asio/ip/udp.hpp>

#include "tests/server/delay_relay.h"

namespace telepalp::server {

/// Forwards TCP and UDP between one client and a server on loopback, as a NAT does: the server sees the relay's
/// address. It keeps a copy of all bytes.
class DatagramRelay {
 public:
  using udp = boost::asio::ip::udp;

  DatagramRelay(boost::asio::io_context& io, std::uint16_t server_port)
      : tcp_(io, server_port, {}),
        server_(boost::asio::ip::make_address("127.0.0.1"), server_port),
        to_client_(io, {boost::asio::ip::make_address("127.0.0.1"), tcp_.port()}),
        to_server_(std::make_unique<udp::socket>(io, udp::endpoint(udp::v4(), 0))) {
    read_client();
    read_server();
  }
  [[nodiscard]] std::uint16_t port() const { return tcp_.port(); }
  [[nodiscard]] const std::string& tcp_overheard() const { return tcp_.overheard(); }
  [[nodiscard]] const std::string& udp_overheard() const { return overheard_; }
  [[nodiscard]] std::uint16_t nat_port() const { return to_server_->local_endpoint().port(); }
  [[nodiscard]] const std::vector<std::string>& from_client() const { return from_client_; }

  bool blocks_udp = false;
  std::uint64_t sent_for_third_B = 0;     // bytes that the server got with the address of a third machine as sender
  std::uint64_t received_by_third_B = 0;  // bytes that the server sent to this machine

  /// From now on, the client's datagrams name a third machine as their sender, so the server's answers go to it.
  void name_a_third_machine_as_sender() {
    rebind();
    third_machine_ = true;
  }

  /// The NAT forgets its mapping: from now on the server sees another port.
  void rebind() {
    ++socket_number_;
    to_server_ = std::make_unique<udp::socket>(to_client_.get_executor(), udp::endpoint(udp::v4(), 0));
    read_server();
  }
  /// Sends `datagrams` to the server from a new address, and returns the number of answers within 0.3 s.
  [[nodiscard]] static std::size_t answers_to(boost::asio::io_context& io, std::uint16_t server_port,
                                              const std::vector<std::string>& datagrams) {
    udp::socket stranger(io, udp::endpoint(boost::asio::ip::make_address("127.0.0.1"), 0));
    stranger.non_blocking(true);
    const udp::endpoint server(boost::asio::ip::make_address("127.0.0.1"), server_port);
    for (const std::string& datagram : datagrams) stranger.send_to(boost::asio::buffer(datagram), server);
    io.run_for(std::chrono::milliseconds(300));
    std::array<char, 2048> buffer{};
    std::size_t answers = 0;
    for (boost::system::error_code none; !none;) {
      stranger.receive(boost::asio::buffer(buffer), 0, none);
      if (!none) ++answers;
    }
    return answers;
  }

 private:
  void read_client() {
    to_client_.async_receive_from(boost::asio::buffer(up_), client_,
                                  [this](const boost::system::error_code& code, std::size_t bytes) {
                                    if (code == boost::asio::error::operation_aborted) return;
                                    if (!code && !blocks_udp) {
                                      if (third_machine_) sent_for_third_B += bytes;
                                      from_client_.emplace_back(up_.data(), bytes);
                                      overheard_.append(up_.data(), bytes);
                                      to_server_->send_to(boost::asio::buffer(up_, bytes), server_);
                                    }
                                    read_client();
                                  });
  }
  void read_server() {
    to_server_->async_receive(boost::asio::buffer(down_),
                              [this, of = socket_number_](const boost::system::error_code& code, std::size_t bytes) {
                                if (code == boost::asio::error::operation_aborted || of != socket_number_) return;
                                if (third_machine_ && !code) received_by_third_B += bytes;
                                if (!code && !blocks_udp && !third_machine_) {
                                  overheard_.append(down_.data(), bytes);
                                  boost::system::error_code lost;
                                  to_client_.send_to(boost::asio::buffer(down_, bytes), client_, 0, lost);
                                }
                                read_server();
                              });
  }

  DelayRelay tcp_;
  udp::endpoint server_;
  udp::socket to_client_;
  std::unique_ptr<udp::socket> to_server_;
  udp::endpoint client_;
  int socket_number_ = 0;
  bool third_machine_ = false;
  std::array<char, 2048> up_{};
  std::array<char, 2048> down_{};
  std::vector<std::string> from_client_;
  std::string overheard_;
};

}  // namespace telepalp::server
