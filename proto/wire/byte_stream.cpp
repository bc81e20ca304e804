#include "proto/wire/byte_stream.h"

#include <netinet/tcp.h>

#include <boost/asio/write.hpp>
#include <utility>

namespace telepalp::wire {
namespace {

namespace asio = boost::asio;
using asio::ip::tcp;

/// About one depth image: enough to keep the network busy while the next message is taken from the queue.
constexpr int kUnsentBytes = 128 << 10;

class PlainTcp : public ByteStream {
 public:
  explicit PlainTcp(tcp::socket socket) : socket_(std::move(socket)) {
    boost::system::error_code ignored;  // the options only reduce latency; an error is harmless
    socket_.set_option(tcp::no_delay(true), ignored);
    socket_.set_option(asio::detail::socket_option::integer<IPPROTO_TCP, TCP_NOTSENT_LOWAT>(kUnsentBytes), ignored);
    boost::system::error_code gone;
    const tcp::endpoint remote = socket_.remote_endpoint(gone);
    const std::string address = remote.address().to_string();
    peer_ = (remote.address().is_v6() ? "[" + address + "]" : address) + ":" + std::to_string(remote.port());
  }

  void async_read_some(asio::mutable_buffer into, Done done) override {
    socket_.async_read_some(asio::buffer(into), std::move(done));
  }
  void async_write(const std::vector<asio::const_buffer>& from, Done done) override {
    asio::async_write(socket_, from, std::move(done));
  }
  void end_writing() noexcept override {
    boost::system::error_code ignored;
    socket_.shutdown(tcp::socket::shutdown_send, ignored);
  }
  void close() noexcept override {
    boost::system::error_code ignored;
    socket_.shutdown(tcp::socket::shutdown_both, ignored);
    socket_.close(ignored);
  }
  asio::any_io_executor executor() override { return socket_.get_executor(); }
  std::string peer() const override { return peer_; }

 private:
  tcp::socket socket_;
  std::string peer_;
};

}  // namespace

std::unique_ptr<ByteStream> plain_tcp(tcp::socket socket) { return std::make_unique<PlainTcp>(std::move(socket)); }

}  // namespace telepalp::wire
