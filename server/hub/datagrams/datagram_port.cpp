#include "server/hub/datagrams/datagram_port.h"

#include <random>

#include "proto/wire/sockets/udp_socket.h"

namespace telepalp::hub {
namespace {

namespace asio = boost::asio;
using boost::system::error_code;

/// The most datagrams read in one go; then the thread serves its other sockets, so that a flood does not starve them.
constexpr int kBatch = 64;

}  // namespace

DatagramPort::DatagramPort(asio::io_context& io) : socket_(io) {}

error_code DatagramPort::open(const Endpoint& at) {
  error_code failed = wire::open_udp(socket_, at.protocol(), wire::TrafficClass::Pictures);
  if (!failed) socket_.bind(at, failed);
  if (failed)
    close();
  else
    wait();
  return failed;
}

void DatagramPort::close() noexcept {
  error_code ignored;
  socket_.close(ignored);
}

std::uint32_t DatagramPort::join(Session& session) {
  std::random_device random;
  std::uint32_t number = random();
  while (!sessions_.try_emplace(number, &session).second) number = random();
  return number;
}

bool DatagramPort::send(std::span<const std::byte> datagram, const Endpoint& to) {
  error_code failed;
  socket_.send_to(asio::buffer(datagram.data(), datagram.size()), to, 0, failed);
  return wire::is_sent(failed);
}

void DatagramPort::wait() {
  socket_.async_wait(asio::ip::udp::socket::wait_read,
                     [this, alive = std::weak_ptr<const bool>(alive_)](const error_code& failed) {
                       if (alive.expired() || !socket_.is_open() || failed == asio::error::operation_aborted) return;
                       read_some();
                       wait();
                     });
}

void DatagramPort::read_some() {
  for (int i = 0; i < kBatch; ++i) {
    error_code failed;
    Endpoint from;
    const std::size_t bytes = socket_.receive_from(asio::buffer(buffer_), from, 0, failed);
    if (failed) return;  // no datagram waits, or a peer's machine refused one that the server had sent
    take(std::span<const std::byte>(buffer_).first(bytes), from);
  }
}

void DatagramPort::take(std::span<const std::byte> datagram, const Endpoint& from) {
  const std::optional<link::SealHeader> header = link::read_header(datagram);
  const auto found = header ? sessions_.find(header->session) : sessions_.end();
  if (found == sessions_.end()) {
    ++counts_.strangers;
    return;
  }
  Session& session = *found->second;
  const link::OpenerStatistics before = session.refused();
  session.received(datagram, from);
  if (!sessions_.contains(header->session)) return;  // the session ended while it processed this datagram
  const link::OpenerStatistics& after = session.refused();
  const std::uint64_t malformed = after.malformed - before.malformed;
  const std::uint64_t replayed = after.replayed - before.replayed;
  const std::uint64_t forged = after.forged - before.forged;
  counts_.malformed += malformed;
  counts_.replayed += replayed;
  counts_.forged += forged;
  counts_.taken += 1 - (malformed + replayed + forged);
}

}  // namespace telepalp::hub
