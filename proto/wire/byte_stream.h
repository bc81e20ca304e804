#pragma once

#include <array>
#include <boost/asio/buffer.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/system/error_code.hpp>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "proto/keys/identity.h"
#include "proto/keys/tls_context.h"
#include "proto/words/result.h"

namespace telepalp::wire {

/// A reliable, bidirectional stream of bytes. Connection uses only this interface, so that a TLS stream can replace
/// plain TCP without changes in Connection.
/// Owner: the thread of its io_context. At most one read and one write are pending at a time.
class ByteStream {
 public:
  using Done = std::function<void(const boost::system::error_code&, std::size_t bytes)>;

  virtual ~ByteStream() = default;
  virtual void async_read_some(boost::asio::mutable_buffer into, Done done) = 0;
  /// Writes all of `from`. The caller keeps the memory of these buffers valid until `done` is called.
  virtual void async_write(const std::vector<boost::asio::const_buffer>& from, Done done) = 0;
  /// Shuts down the sending direction. Reading continues, so that the peer's last messages are not lost to a TCP reset.
  virtual void end_writing() noexcept = 0;
  /// Closes the stream; pending operations end with operation_aborted. May be called repeatedly.
  virtual void close() noexcept = 0;
  [[nodiscard]] virtual boost::asio::any_io_executor executor() = 0;
  /// Address of the peer for log lines, for example "127.0.0.1:4711".
  [[nodiscard]] virtual std::string peer() const = 0;

  /// True once a TLS handshake has succeeded.
  [[nodiscard]] virtual bool is_sealed() const { return false; }
  /// The person whom the peer's certificate names; nullopt: TLS has not verified a certificate.
  [[nodiscard]] virtual std::optional<keys::Identity> identity() { return std::nullopt; }
  /// At a client: the server's certificate, which TLS has verified; nullopt: there is none.
  [[nodiscard]] virtual std::optional<keys::ServerCertificate> server_certificate() { return std::nullopt; }
  /// The TLS exporter's secret for `label` (RFC 8446 §7.5), equal at both ends; nullopt while is_sealed() is false.
  [[nodiscard]] virtual std::optional<std::array<std::byte, 32>> keying_material(std::string_view label);
  /// Explains the failed operation if each further attempt to connect would fail the same way; nullopt: another attempt
  /// may succeed.
  [[nodiscard]] virtual std::optional<Error> refusal(const boost::system::error_code& failed);
};

/// A stream over plain TCP. Nagle's algorithm is off, and the kernel holds about 32 KiB of unsent bytes at most: a
/// message that waits in the kernel cannot be replaced by a newer one.
[[nodiscard]] std::unique_ptr<ByteStream> plain_tcp(boost::asio::ip::tcp::socket socket);

}  // namespace telepalp::wire
