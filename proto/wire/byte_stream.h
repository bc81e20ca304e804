#pragma once

#include <boost/asio/buffer.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/system/error_code.hpp>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace telepalp::wire {

/// A reliable stream of bytes between two ends. The seam where TLS goes: a Connection knows only this, so that a
/// TLS stream, once its handshake is done, takes the place of plain TCP without a change above it.
/// Owner: the thread of its io_context. At most one read and one write are pending at a time.
class ByteStream {
 public:
  using Done = std::function<void(const boost::system::error_code&, std::size_t bytes)>;

  virtual ~ByteStream() = default;
  virtual void async_read_some(boost::asio::mutable_buffer into, Done done) = 0;
  /// Writes all of `from`, whose memory stays valid until `done`.
  virtual void async_write(const std::vector<boost::asio::const_buffer>& from, Done done) = 0;
  /// Tells the peer that nothing more is written; reading goes on, so that the last words are not lost to a reset.
  virtual void end_writing() noexcept = 0;
  /// Ends what is pending with operation_aborted. May be called again.
  virtual void close() noexcept = 0;
  [[nodiscard]] virtual boost::asio::any_io_executor executor() = 0;
  /// "127.0.0.1:4711", for people.
  [[nodiscard]] virtual std::string peer() const = 0;
};

/// Plain TCP: no delay for small messages, and little unsent data in the kernel, since what waits there can no
/// longer be overtaken by something newer.
[[nodiscard]] std::unique_ptr<ByteStream> plain_tcp(boost::asio::ip::tcp::socket socket);

}  // namespace telepalp::wire
