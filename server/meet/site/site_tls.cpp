#include "server/meet/site/site_tls.h"

#include <openssl/err.h>
#include <sys/socket.h>

#include <algorithm>
#include <boost/asio/post.hpp>
#include <boost/asio/ssl/error.hpp>
#include <cerrno>
#include <cstring>
#include <utility>

namespace telepalp::meet {

namespace asio = boost::asio;
using asio::ip::tcp;
using boost::system::error_code;

namespace {

/// `why`: what SSL_get_error() gave. A peer that closes its socket without TLS's own goodbye has hung up as well.
error_code failure(int why) {
  const unsigned long code = ERR_get_error();
  if (why == SSL_ERROR_ZERO_RETURN || ERR_GET_REASON(code) == SSL_R_UNEXPECTED_EOF_WHILE_READING)
    return asio::error::eof;
  if (code != 0) return {static_cast<int>(code), asio::error::get_ssl_category()};
  return errno != 0 ? error_code(errno, boost::system::system_category()) : error_code(asio::error::eof);
}

bool is_early(ssize_t moved) noexcept {
  return moved < 0 && (errno == EAGAIN || errno == EWOULDBLOCK || errno == EINTR);
}

}  // namespace

SiteTls::SiteTls(tcp::socket socket, std::string greeting, wire::TlsSettings settings)
    : wire_(std::make_unique<Wire>(Wire{std::move(socket), std::move(greeting)})),
      settings_(std::move(settings)),
      session_(SSL_new(settings_->native_handle())) {
  BIO* bio = BIO_new(wire_method());
  BIO_set_data(bio, wire_.get());
  BIO_set_init(bio, 1);
  SSL_set_bio(session_.get(), bio, bio);  // the session frees it
  error_code ignored;                     // a socket that is gone fails in the handshake
  wire_->socket.non_blocking(true, ignored);
}

void SiteTls::async_handshake(Done done) {
  advance([session = session()](std::size_t&) { return SSL_accept(session); }, done);
}

void SiteTls::async_read_some(asio::mutable_buffer into, Done done) {
  advance([session = session(),
           into](std::size_t& count) { return SSL_read_ex(session, into.data(), into.size(), &count); },
          done);
}

void SiteTls::async_write(asio::const_buffer from, Done done) {
  advance([session = session(),
           from](std::size_t& count) { return SSL_write_ex(session, from.data(), from.size(), &count); },
          done);
}

/// The handler never runs within the call that began the operation, as with Asio's own streams.
void SiteTls::advance(const Step& step, const Done& done) {
  ERR_clear_error();
  errno = 0;
  std::size_t count = 0;
  const int result = step(count);
  const int why = SSL_get_error(session(), result);
  if (why == SSL_ERROR_WANT_READ || why == SSL_ERROR_WANT_WRITE)
    return wire_->socket.async_wait(why == SSL_ERROR_WANT_READ ? tcp::socket::wait_read : tcp::socket::wait_write,
                                    [this, step, done](const error_code& failed) {
                                      if (failed) return done(failed, 0);
                                      advance(step, done);
                                    });
  asio::post(wire_->socket.get_executor(),
             [done, count, failed = result > 0 ? error_code() : failure(why)] { done(failed, count); });
}

int SiteTls::read_wire(BIO* bio, char* into, int size) {
  Wire& wire = *static_cast<Wire*>(BIO_get_data(bio));
  BIO_clear_retry_flags(bio);
  const std::size_t left = wire.greeting.size() - wire.taken;
  if (left > 0) {
    const std::size_t count = std::min(left, static_cast<std::size_t>(size));
    std::memcpy(into, wire.greeting.data() + wire.taken, count);
    wire.taken += count;
    if (count == left) {  // frees the memory, because a site stays for months
      std::string().swap(wire.greeting);
      wire.taken = 0;
    }
    return static_cast<int>(count);
  }
  const ssize_t count = ::recv(wire.socket.native_handle(), into, static_cast<std::size_t>(size), 0);
  if (is_early(count)) BIO_set_retry_read(bio);
  return static_cast<int>(count);
}

int SiteTls::write_wire(BIO* bio, const char* from, int size) {
  Wire& wire = *static_cast<Wire*>(BIO_get_data(bio));
  BIO_clear_retry_flags(bio);
  const ssize_t count = ::send(wire.socket.native_handle(), from, static_cast<std::size_t>(size), MSG_NOSIGNAL);
  if (is_early(count)) BIO_set_retry_write(bio);
  return static_cast<int>(count);
}

long SiteTls::control_wire(BIO*, int what, long, void*) { return what == BIO_CTRL_FLUSH ? 1 : 0; }

BIO_METHOD* SiteTls::wire_method() {
  static BIO_METHOD* const method = [] {
    BIO_METHOD* made = BIO_meth_new(BIO_get_new_index() | BIO_TYPE_SOURCE_SINK, "a site's socket");
    BIO_meth_set_read(made, &SiteTls::read_wire);
    BIO_meth_set_write(made, &SiteTls::write_wire);
    BIO_meth_set_ctrl(made, &SiteTls::control_wire);
    return made;
  }();
  return method;
}

}  // namespace telepalp::meet
