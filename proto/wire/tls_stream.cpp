#include "proto/wire/tls_stream.h"

#include <boost/asio/ssl/error.hpp>
#include <boost/asio/ssl/stream.hpp>
#include <boost/asio/write.hpp>
#include <utility>

#include "proto/wire/sockets/tcp_socket.h"

namespace telepalp::wire {
namespace {

namespace asio = boost::asio;
namespace ssl = asio::ssl;
using asio::ip::tcp;
using boost::system::error_code;

constexpr unsigned char kTlsHandshake = 0x16;  // the first byte of each TLS connection

class TlsTcp : public ByteStream {
 public:
  TlsTcp(tcp::socket socket, TlsSettings settings, ssl::stream_base::handshake_type end, std::string host,
         std::shared_ptr<const keys::KeyFile> key)
      : settings_(std::move(settings)),
        stream_(std::move(socket), *settings_),
        end_(end),
        host_(std::move(host)),
        key_(std::move(key)),
        peer_(peer_address(stream_.next_layer())) {
    tune(stream_.next_layer());
    if (!host_.empty()) keys::expect_host(session(), host_);
  }

  void async_read_some(asio::mutable_buffer into, Done done) override {
    if (phase_ == Phase::Sealed) return stream_.async_read_some(asio::buffer(into), std::move(done));
    if (phase_ == Phase::Plain) return stream_.next_layer().async_read_some(asio::buffer(into), std::move(done));
    const auto waiting = begun();
    waiting->read = [this, into, done](const error_code& failed) {
      if (failed) return done(failed, 0);
      async_read_some(into, done);
    };
  }

  void async_write(const std::vector<asio::const_buffer>& from, Done done) override {
    if (phase_ == Phase::Sealed) return asio::async_write(stream_, from, std::move(done));
    if (phase_ == Phase::Plain) return asio::async_write(stream_.next_layer(), from, std::move(done));
    const auto waiting = begun();
    waiting->write = [this, from, done](const error_code& failed) {
      if (failed) return done(failed, 0);
      async_write(from, done);
    };
  }

  /// The Goodbye inside the session says that this end has finished; TLS's own close_notify would add nothing.
  void end_writing() noexcept override {
    error_code ignored;
    stream_.next_layer().shutdown(tcp::socket::shutdown_send, ignored);
  }
  void close() noexcept override {
    error_code ignored;
    stream_.next_layer().shutdown(tcp::socket::shutdown_both, ignored);
    stream_.next_layer().close(ignored);
  }
  asio::any_io_executor executor() override { return stream_.get_executor(); }
  std::string peer() const override { return peer_; }
  bool is_sealed() const override { return phase_ == Phase::Sealed; }
  std::optional<keys::Identity> identity() override {
    return is_sealed() ? keys::identity_of_peer(session()) : std::nullopt;
  }
  std::optional<keys::ServerCertificate> server_certificate() override {
    return is_sealed() ? keys::certificate_of_server(session()) : std::nullopt;
  }
  std::optional<std::array<std::byte, 32>> keying_material(std::string_view label) override {
    return is_sealed() ? keys::keying_material(session(), label) : std::nullopt;
  }
  std::optional<Error> refusal(const error_code& code) override {
    if (!key_ || code.category() != asio::error::get_ssl_category()) return std::nullopt;
    return keys::refusal_of(session(), static_cast<unsigned long>(code.value()), *key_, host_);
  }

 private:
  enum class Phase { New, Handshake, Sealed, Plain };
  /// Reads and writes that wait for the handshake. The handshake's handler owns them. Each of them keeps this stream
  /// alive through its caller, until the handler is destroyed.
  struct Waiting {
    std::function<void(const error_code&)> read, write;
  };

  SSL& session() { return *stream_.native_handle(); }

  std::shared_ptr<Waiting> begun() {
    if (phase_ == Phase::Handshake) return waiting_.lock();
    phase_ = Phase::Handshake;
    auto waiting = std::make_shared<Waiting>();
    waiting_ = waiting;
    if (end_ == ssl::stream_base::client)
      shake_hands(waiting);
    else
      look_at_first_byte(waiting);
    return waiting;
  }

  void look_at_first_byte(const std::shared_ptr<Waiting>& waiting) {
    stream_.next_layer().async_wait(tcp::socket::wait_read, [this, waiting](error_code failed) {
      unsigned char first = 0;
      if (!failed) {
        stream_.next_layer().non_blocking(true, failed);
        stream_.next_layer().receive(asio::buffer(&first, 1), tcp::socket::message_peek, failed);
      }
      if (failed) return finish(Phase::New, failed, *waiting);
      if (first != kTlsHandshake) return finish(Phase::Plain, {}, *waiting);
      shake_hands(waiting);
    });
  }

  void shake_hands(const std::shared_ptr<Waiting>& waiting) {
    stream_.async_handshake(end_, [this, waiting](const error_code& failed) {
      // The TLS alert with the reason must arrive before the reset of a closed socket.
      const bool says_why = failed.category() == asio::error::get_ssl_category() && end_ == ssl::stream_base::server;
      if (failed && says_why) close_gently(std::move(stream_.next_layer()));
      finish(failed ? Phase::New : Phase::Sealed, failed, *waiting);
    });
  }

  static void run(std::function<void(const error_code&)> waiting, const error_code& failed) {
    if (waiting) waiting(failed);
  }
  void finish(Phase phase, const error_code& failed, Waiting& waiting) {
    phase_ = phase;
    auto read = std::move(waiting.read);
    auto write = std::move(waiting.write);
    run(std::move(write), failed);
    run(std::move(read), failed);
  }

  TlsSettings settings_;
  ssl::stream<tcp::socket> stream_;
  ssl::stream_base::handshake_type end_;
  std::string host_;
  std::shared_ptr<const keys::KeyFile> key_;
  std::string peer_;
  Phase phase_ = Phase::New;
  std::weak_ptr<Waiting> waiting_;
};

}  // namespace

Result<TlsSettings> tls_settings(Result<keys::TlsContextPtr> context) {
  if (!context) return context.error();
  return std::make_shared<ssl::context>(std::move(context).value().release());
}

std::unique_ptr<ByteStream> tls_at_server(tcp::socket socket, TlsSettings settings) {
  return std::make_unique<TlsTcp>(std::move(socket), std::move(settings), ssl::stream_base::server, "", nullptr);
}

std::unique_ptr<ByteStream> tls_at_client(tcp::socket socket, TlsSettings settings, std::string host,
                                          std::shared_ptr<const keys::KeyFile> key) {
  return std::make_unique<TlsTcp>(std::move(socket), std::move(settings), ssl::stream_base::client, std::move(host),
                                  std::move(key));
}

}  // namespace telepalp::wire
