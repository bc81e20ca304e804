#include "proto/wire/datagrams/client_datagrams.h"

#include <utility>

#include "proto/wire/sockets/udp_socket.h"

namespace telepalp::wire {
namespace {

namespace asio = boost::asio;
using boost::system::error_code;

constexpr int kMostReadAtOnce = 64;  // the most datagrams read in one go; then the thread serves its other sockets

}  // namespace

ClientDatagrams::ClientDatagrams(asio::io_context& io, const asio::ip::udp::endpoint& server,
                                 const link::SealSettings& seal, Handlers handlers)
    : server_(server),
      by_path_(std::move(handlers.send)),
      on_phase_(std::move(handlers.on_phase)),
      on_carry_(std::move(handlers.on_carry)),
      socket_(io),
      end_(io.get_executor(), seal, link::End::Client,
           {.send = [this](std::span<const std::byte> datagram) { return send(datagram); },
            .next_frame = std::move(handlers.next_frame),
            .on_frame = std::move(handlers.on_frame),
            .on_key_frame_needed = {},
            .on_phase =
                [this](DatagramPhase phase) {
                  if (phase == DatagramPhase::Blocked) change_socket();
                  carry(phase == DatagramPhase::Up);
                  if (on_phase_) on_phase_(phase);
                },
            .now = std::move(handlers.now)}) {}

void ClientDatagrams::start() {
  change_socket();
  end_.start();
}

void ClientDatagrams::carry(bool carries) {
  if (std::exchange(carries_, carries) != carries && on_carry_) on_carry_(carries);
}

void ClientDatagrams::close() {
  carry(false);
  closed_ = true;
  end_.close();
  error_code ignored;
  socket_.close(ignored);
}

void ClientDatagrams::received(std::span<const std::byte> datagram) {
  if (closed_) return;
  (void)end_.received(datagram);
  end_.pump();
}

/// If no socket can be opened, no datagram arrives, and the PathWatch reports the path as blocked.
void ClientDatagrams::change_socket() {
  if (by_path_) return;
  ++socket_number_;
  error_code failed;
  socket_.close(failed);
  if (failed = open_udp(socket_, server_.protocol(), TrafficClass::Touch); failed) return;
  socket_.connect(server_, failed);
  if (!failed) wait();
}

void ClientDatagrams::wait() {
  socket_.async_wait(
      asio::ip::udp::socket::wait_read,
      [this, of = socket_number_, alive = std::weak_ptr<const bool>(alive_)](const error_code& failed) {
        if (alive.expired() || closed_ || of != socket_number_ || failed == asio::error::operation_aborted) return;
        read_some();
        if (!closed_ && of == socket_number_) wait();
      });
}

void ClientDatagrams::read_some() {
  for (int i = 0; i < kMostReadAtOnce && !closed_; ++i) {
    error_code failed;
    const std::size_t bytes = socket_.receive(asio::buffer(buffer_), 0, failed);
    if (failed) break;  // no datagram waits, or the server's machine refused one (ICMP); its server may come back
    (void)end_.received(std::span<const std::byte>(buffer_).first(bytes));
  }
  end_.pump();
}

bool ClientDatagrams::send(std::span<const std::byte> datagram) {
  if (by_path_) return by_path_(datagram);
  error_code failed;
  socket_.send(asio::buffer(datagram.data(), datagram.size()), 0, failed);
  return is_sent(failed);
}

}  // namespace telepalp::wire
