#include "tools/link_proxy/tcp_proxy.h"

#include <chrono>
#include <utility>

#include "tools/link_proxy/tcp_pair.h"

namespace telepalp::link_proxy {
namespace {

using boost::asio::ip::tcp;
using boost::system::error_code;

constexpr std::size_t kMostPairs = 256;
constexpr std::chrono::milliseconds kAcceptBackOff{100};

}  // namespace

TcpProxy::TcpProxy(boost::asio::io_context& io, std::shared_ptr<Lines> lines, tcp::endpoint server)
    : io_(io), lines_(std::move(lines)), server_(std::move(server)), acceptor_(io), accept_again_(io) {}

TcpProxy::~TcpProxy() = default;

error_code TcpProxy::listen(const tcp::endpoint& at) {
  error_code failed;
  acceptor_.open(at.protocol(), failed);
  if (!failed) acceptor_.set_option(tcp::acceptor::reuse_address(true), failed);
  if (!failed) acceptor_.bind(at, failed);
  if (!failed) acceptor_.listen(boost::asio::socket_base::max_listen_connections, failed);
  if (!failed) accept();
  return failed;
}

void TcpProxy::accept() {
  acceptor_.async_accept([this](const error_code& failed, tcp::socket client) {
    if (failed == boost::asio::error::operation_aborted || !acceptor_.is_open()) return;
    if (failed) return accept_later();
    if (pairs_.size() < kMostPairs) join(std::move(client));
    accept();
  });
}

/// Probably no file descriptor is free; an immediate retry would waste the processor.
void TcpProxy::accept_later() {
  accept_again_.expires_after(kAcceptBackOff);
  accept_again_.async_wait([this](const error_code& stopped) {
    if (!stopped) accept();
  });
}

void TcpProxy::join(tcp::socket client) {
  const auto number = std::make_shared<std::weak_ptr<TcpPair>>();
  const auto pair = std::make_shared<TcpPair>(io_, lines_, std::move(client), [this, number] {
    if (const auto closed = number->lock()) pairs_.erase(closed);
  });
  *number = pair;
  pairs_.insert(pair);
  pair->start(server_);
}

void TcpProxy::stop() {
  error_code ignored;
  acceptor_.close(ignored);
  accept_again_.cancel();
  for (const auto& pair : std::set<std::shared_ptr<TcpPair>>(pairs_)) pair->close();
}

}  // namespace telepalp::link_proxy
