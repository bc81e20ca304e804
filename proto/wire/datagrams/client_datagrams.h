#pragma once

#include <array>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/udp.hpp>
#include <functional>
#include <memory>

#include "proto/wire/datagrams/datagram_end.h"

namespace telepalp::wire {

/// The datagrams of a client's connection: a UDP socket to the server, and the client's end of the datagram link. After
/// the path was blocked, a new socket is used, because a NAT may have dropped the mapping of the old one. With
/// Handlers::send, the caller carries the datagrams, and there is no socket. Owner: the thread of `io`.
class ClientDatagrams {
 public:
  struct Handlers {
    /// The next frame to send of those wanted; null: none.
    std::function<std::shared_ptr<const link::SharedFrame>(Wanted)> next_frame{};
    std::function<void(link::Frame)> on_frame{};
    std::function<void(DatagramPhase)> on_phase{};
    /// True: frames now go by datagram, from next_frame(). False: no longer, because the path is down or close() was
    /// called.
    std::function<void(bool)> on_carry{};
    std::function<SessionTime()> now{};
    /// Sends a datagram by the caller's path; false: it is full, try again. Empty function: a socket sends it.
    std::function<bool(std::span<const std::byte>)> send{};
  };

  ClientDatagrams(boost::asio::io_context& io, const boost::asio::ip::udp::endpoint& server,
                  const link::SealSettings& seal, Handlers handlers);

  void start();
  void close();                 ///< afterwards no handler is called any more
  void wake() { end_.pump(); }  ///< call it when next_frame() has a frame again
  /// A datagram has come by the caller's path.
  void received(std::span<const std::byte> datagram);
  /// The caller's path goes another way.
  void way_changed() { end_.way_changed(); }
  /// Continues on another local port. For tests: to the server it looks like a NAT that changes its mapping.
  void change_socket();

  [[nodiscard]] const DatagramEnd& end() const noexcept { return end_; }

 private:
  void carry(bool carries);
  void wait();
  void read_some();
  [[nodiscard]] bool send(std::span<const std::byte> datagram);

  boost::asio::ip::udp::endpoint server_;
  std::function<bool(std::span<const std::byte>)> by_path_;  // empty: the socket sends
  std::function<void(DatagramPhase)> on_phase_;
  std::function<void(bool)> on_carry_;
  bool carries_ = false;
  boost::asio::ip::udp::socket socket_;
  DatagramEnd end_;
  std::array<std::byte, link::kDatagramBytes + 1> buffer_{};  // one byte more, to recognise datagrams that are too long
  std::uint64_t socket_number_ = 0;                           // of socket_; reads of an earlier socket are ignored
  bool closed_ = false;
  std::shared_ptr<const bool> alive_ = std::make_shared<const bool>(true);  // pending reads hold weak_ptrs to it
};

}  // namespace telepalp::wire
