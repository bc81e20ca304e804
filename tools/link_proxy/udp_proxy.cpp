#include "tools/link_proxy/udp_proxy.h"

#include <boost/asio/buffer.hpp>
#include <span>
#include <utility>

namespace telepalp::link_proxy {
namespace {

namespace asio = boost::asio;
using asio::ip::udp;
using boost::system::error_code;
using Clock = std::chrono::steady_clock;
using namespace std::chrono_literals;

constexpr std::size_t kMostClients = 256;
constexpr auto kSilence = 60s;
constexpr int kSocketBuffer_B = 4 << 20;  ///< a burst of frames; the kernel may grant less

/// Opens `socket` without blocking calls, with large buffers.
error_code prepare(udp::socket& socket, const udp& protocol) {
  error_code failed;
  socket.open(protocol, failed);
  if (failed) return failed;
  error_code smaller;
  socket.set_option(asio::socket_base::receive_buffer_size(kSocketBuffer_B), smaller);
  socket.set_option(asio::socket_base::send_buffer_size(kSocketBuffer_B), smaller);
  socket.non_blocking(true, failed);
  return failed;
}

}  // namespace

struct UdpProxy::Client {
  Client(asio::io_context& io, std::uint64_t number, udp::endpoint from)
      : flow(number), address(std::move(from)), to_server(io) {}
  std::uint64_t flow;
  udp::endpoint address;
  udp::socket to_server;
  Clock::time_point last_heard = Clock::now();
  std::array<std::byte, 65536> buffer{};
};

UdpProxy::UdpProxy(asio::io_context& io, Lines& lines, udp::endpoint server)
    : io_(io), lines_(lines), server_(std::move(server)), socket_(io), sweep_(io) {}

UdpProxy::~UdpProxy() = default;

error_code UdpProxy::listen(const udp::endpoint& at) {
  error_code failed = prepare(socket_, at.protocol());
  if (!failed) socket_.bind(at, failed);
  if (failed) return failed;
  read();
  forget_silent();
  return failed;
}

void UdpProxy::read() {
  socket_.async_receive_from(asio::buffer(buffer_), sender_, [this](const error_code& failed, std::size_t bytes) {
    if (failed == asio::error::operation_aborted) return;
    if (const auto client = failed ? nullptr : client_at(sender_)) {
      client->last_heard = Clock::now();
      lines_.to_server.send_datagram(client->flow, std::span<const std::byte>(buffer_).first(bytes));
    }
    read();
  });
}

std::shared_ptr<UdpProxy::Client> UdpProxy::client_at(const udp::endpoint& address) {
  if (const auto known = clients_.find(address); known != clients_.end()) return known->second;
  if (clients_.size() >= kMostClients) return nullptr;
  auto client = std::make_shared<Client>(io_, lines_.new_flow(), address);
  error_code failed = prepare(client->to_server, server_.protocol());
  if (!failed) client->to_server.connect(server_, failed);
  if (failed) return nullptr;
  lines_.to_server.open(client->flow, [raw = client.get()](const std::vector<std::byte>& bytes) {
    error_code lost;
    raw->to_server.send(asio::buffer(bytes), 0, lost);
  });
  lines_.to_client.open(client->flow, [this, raw = client.get()](const std::vector<std::byte>& bytes) {
    error_code lost;
    socket_.send_to(asio::buffer(bytes), raw->address, 0, lost);
  });
  clients_.emplace(address, client);
  read_answers(client);
  return client;
}

void UdpProxy::read_answers(const std::shared_ptr<Client>& client) {
  client->to_server.async_receive(
      asio::buffer(client->buffer), [this, client](const error_code& failed, std::size_t bytes) {
        if (failed == asio::error::operation_aborted) return;
        if (!failed)
          lines_.to_client.send_datagram(client->flow, std::span<const std::byte>(client->buffer).first(bytes));
        read_answers(client);  // an error is the refusal of one datagram: the server may come back
      });
}

void UdpProxy::close(Client& client) {
  lines_.to_server.close(client.flow);
  lines_.to_client.close(client.flow);
  error_code ignored;
  client.to_server.close(ignored);
}

void UdpProxy::forget_silent() {
  std::erase_if(clients_, [this](const auto& entry) {
    const bool silent = Clock::now() - entry.second->last_heard > kSilence;
    if (silent) close(*entry.second);
    return silent;
  });
  sweep_.expires_after(10s);
  sweep_.async_wait([this](const error_code& cancelled) {
    if (!cancelled) forget_silent();
  });
}

void UdpProxy::stop() {
  error_code ignored;
  socket_.close(ignored);
  sweep_.cancel();
  for (const auto& [address, client] : clients_) close(*client);
  clients_.clear();
}

}  // namespace telepalp::link_proxy
