#pragma once

#include <boost/asio/buffer.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <functional>
#include <memory>
#include <string>

#include "proto/wire/tls_stream.h"

namespace telepalp::meet {

/// The meeting point's end of a TLS connection that is silent for months. OpenSSL reads and writes the socket itself,
/// so a silent connection holds no buffer; boost::asio::ssl::stream would hold 68 KiB. One thread uses it. At most one
/// read and one write are pending; their buffers and this object must live until the handler has run.
class SiteTls {
 public:
  using Done = std::function<void(const boost::system::error_code& failed, std::size_t count)>;

  /// `greeting`: bytes that were already read from the socket.
  SiteTls(boost::asio::ip::tcp::socket socket, std::string greeting, wire::TlsSettings settings);

  void async_handshake(Done done);
  void async_read_some(boost::asio::mutable_buffer into, Done done);
  void async_write(boost::asio::const_buffer from, Done done);

  [[nodiscard]] boost::asio::ip::tcp::socket& socket() noexcept { return wire_->socket; }
  [[nodiscard]] SSL* session() noexcept { return session_.get(); }

 private:
  /// What OpenSSL reads and writes: first the greeting, then the socket.
  struct Wire {
    boost::asio::ip::tcp::socket socket;
    std::string greeting;
    std::size_t taken = 0;  ///< bytes of the greeting that OpenSSL has read
  };
  struct Free {
    void operator()(SSL* session) const noexcept { SSL_free(session); }
  };

  /// One call of OpenSSL: its result as SSL_read_ex() gives it, and the bytes that it moved.
  using Step = std::function<int(std::size_t& count)>;
  void advance(const Step& step, const Done& done);

  static int read_wire(BIO* bio, char* into, int size);
  static int write_wire(BIO* bio, const char* from, int size);
  static long control_wire(BIO* bio, int what, long number, void* pointer);
  static BIO_METHOD* wire_method();

  std::unique_ptr<Wire> wire_;
  wire::TlsSettings settings_;
  std::unique_ptr<SSL, Free> session_;
};

}  // namespace telepalp::meet
