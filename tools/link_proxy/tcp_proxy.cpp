#include "tools/link_proxy/tcp_proxy.h"

#include <utility>

#include "tools/link_proxy/tcp_pair.h"

namespace telepalp::link_proxy {
namespace {

using boost::asio::ip::tcp;
using boost::system::error_code;

constexpr std::size_t kMostPairs = 256;

}  // namespace

TcpProxy::TcpProxy(boost::asio::io_context& io, Lines& lines, tcp::endpoint server)
    : io_(io), lines_(lines), server_(std::move(server)), acceptor_(io) {}

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
    if (failed == boost::asio::error::operation_aborted) return;
    if (!failed && pairs_.size() < kMostPairs) {
      const auto number = std::make_shared<std::weak_ptr<TcpPair>>();
      const auto pair = std::make_shared<TcpPair>(io_, lines_, std::move(client), [this, number] {
        if (const auto closed = number->lock()) pairs_.erase(closed);
      });
      *number = pair;
      pairs_.insert(pair);
      pair->start(server_);
    }
    accept();
  });
}

void TcpProxy::stop() {
  error_code ignored;
  acceptor_.close(ignored);
  for (const auto& pair : std::set<std::shared_ptr<TcpPair>>(pairs_)) pair->close();
}

}  // namespace telepalp::link_proxy
