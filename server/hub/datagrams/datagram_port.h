#pragma once

#include <array>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/udp.hpp>
#include <boost/system/error_code.hpp>
#include <cstdint>
#include <map>
#include <memory>
#include <span>

#include "proto/link/datagram_link.h"
#include "proto/wire/datagram_message.h"
#include "server/hub/datagrams/datagram_counts.h"

namespace telepalp::hub {

/// The server's UDP socket, shared by the datagram sessions of its peers. A datagram goes to the session that its
/// header names. A refused datagram is not answered. Owner: the network thread.
class DatagramPort {
 public:
  using Endpoint = boost::asio::ip::udp::endpoint;

  class Session {
   public:
    virtual ~Session() = default;
    virtual void received(std::span<const std::byte> datagram, const Endpoint& from) = 0;
    [[nodiscard]] virtual const link::OpenerStatistics& refused() const = 0;  ///< counts of refused datagrams
  };

  explicit DatagramPort(boost::asio::io_context& io);
  [[nodiscard]] boost::system::error_code open(const Endpoint& at);
  void close() noexcept;

  /// Adds `session`; returns the random number that its datagrams' headers state. Call leave() before destroying it.
  std::uint32_t join(Session& session);
  void leave(std::uint32_t number) noexcept { sessions_.erase(number); }

  /// False: the socket's send buffer is full, and the datagram can be sent again. After other errors, it is lost: true.
  [[nodiscard]] bool send(std::span<const std::byte> datagram, const Endpoint& to);

  /// The frames that the peers send; they share those of one message.
  [[nodiscard]] wire::FrameCache& frames() noexcept { return frames_; }
  [[nodiscard]] const DatagramCounts& counts() const noexcept { return counts_; }
  [[nodiscard]] bool is_open() const noexcept { return socket_.is_open(); }

 private:
  void wait();
  void read_some();
  void take(std::span<const std::byte> datagram, const Endpoint& from);

  boost::asio::ip::udp::socket socket_;
  std::map<std::uint32_t, Session*> sessions_;                // bounded: each peer has one, and their number is limited
  std::array<std::byte, link::kDatagramBytes + 1> buffer_{};  // one byte more, to recognise datagrams that are too long
  wire::FrameCache frames_;
  DatagramCounts counts_;
  std::shared_ptr<const bool> alive_ = std::make_shared<const bool>(true);  // pending reads hold weak_ptrs to it
};

}  // namespace telepalp::hub
