#include "proto/wire/byte_stream.h"

#include <boost/asio/write.hpp>
#include <limits>
#include <utility>

#include "proto/wire/sockets/tcp_socket.h"

namespace telepalp::wire {
namespace {

namespace asio = boost::asio;
using asio::ip::tcp;

/// How much of a message one system call may send: all of it. Asio's own condition gives at most 64 KiB to a call,
/// which doubles the calls for an image.
std::size_t all_at_once(const boost::system::error_code& failed, std::size_t) {
  return failed ? 0 : std::numeric_limits<std::size_t>::max();
}

class PlainTcp : public ByteStream {
 public:
  explicit PlainTcp(tcp::socket socket) : socket_(std::move(socket)), peer_(peer_address(socket_)) { tune(socket_); }

  void async_read_some(asio::mutable_buffer into, Done done) override {
    socket_.async_read_some(asio::buffer(into), std::move(done));
  }
  void async_write(const std::vector<asio::const_buffer>& from, Done done) override {
    asio::async_write(socket_, from, all_at_once, std::move(done));
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

std::optional<std::array<std::byte, 32>> ByteStream::keying_material(std::string_view) { return std::nullopt; }
std::optional<Error> ByteStream::refusal(const boost::system::error_code&) { return std::nullopt; }

std::unique_ptr<ByteStream> plain_tcp(tcp::socket socket) { return std::make_unique<PlainTcp>(std::move(socket)); }

}  // namespace telepalp::wire
