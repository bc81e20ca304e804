#include "server/meet/site/site_session.h"

#include <algorithm>
#include <boost/asio/ip/address.hpp>
#include <utility>

#include "proto/keys/tls_context.h"
#include "proto/wire/sockets/tcp_socket.h"

namespace telepalp::meet {

namespace asio = boost::asio;
using asio::ip::tcp;
using boost::system::error_code;

namespace {

constexpr std::size_t kMostUnsent = 256;  // calls that a site has not taken from its socket
constexpr std::chrono::seconds kTimeToJoin{5};

/// A caller can name a host, but not an address (RFC 6066 §3). Each server's key also names localhost, which is no
/// site's name.
bool can_be_called(const std::string& name) {
  error_code is_name;
  asio::ip::make_address(name, is_name);
  return is_name && name != "localhost";
}

}  // namespace

SiteSession::SiteSession(tcp::socket socket, std::string hello, wire::TlsSettings tls, Handlers handlers)
    : stream_(std::move(socket), std::move(hello), std::move(tls)),
      beat_(stream_.socket().get_executor()),
      peer_(wire::peer_address(stream_.socket())),
      who_(access::newcomer(stream_.socket())),
      handlers_(std::move(handlers)),
      heard_(std::chrono::steady_clock::now()) {}

void SiteSession::start() {
  if (closed_) return;
  beat();
  stream_.async_handshake([self = shared_from_this()](const error_code& failed, std::size_t) {
    if (failed) return self->end_after_alert(failed);
    self->shaken_hands();
  });
}

/// The TLS alert with the reason must arrive before the reset of a closed socket.
void SiteSession::end_after_alert(const error_code& failed) {
  if (!closed_) wire::close_gently(std::move(stream_.socket()));
  close("the TLS handshake failed: " + failed.message());
}

void SiteSession::shaken_hands() {
  const keys::HostCertificate shown = keys::host_certificate_of_peer(*stream_.session());
  serial_ = shown.serial;
  std::ranges::copy_if(shown.hosts, std::back_inserter(names_), can_be_called);
  read();
}

void SiteSession::read() {
  stream_.async_read_some(asio::buffer(bytes_),
                          [self = shared_from_this()](const error_code& failed, std::size_t count) {
                            if (self->closed_) return;
                            if (failed)
                              return self->close(failed == asio::error::eof ? "it hung up" : failed.message());
                            self->heard_ = std::chrono::steady_clock::now();
                            self->frames_.append({self->bytes_.data(), count});
                            while (const std::optional<std::string> frame = self->frames_.next())
                              if (!self->take(*frame))
                                return self->close("it sent what is no message of this protocol");
                            if (self->frames_.is_bad()) return self->close("it announced a message that is too large");
                            if (!self->closed_) self->read();
                          });
}

bool SiteSession::take(const std::string& frame) {
  msg::SiteToMeet message;
  if (!message.ParseFromString(frame)) return false;
  switch (message.what_case()) {
    case msg::SiteToMeet::kJoin:
      moved_ = message.moved();
      if (!joined_) join(message.join());
      return true;
    case msg::SiteToMeet::kDecline:
      if (joined_) handlers_.on_decline(message.decline());
      return true;
    case msg::SiteToMeet::kBeat:
      return true;
    default:
      return false;
  }
}

void SiteSession::join(std::uint32_t version) {
  if (version != kVersion)
    return refuse("this meeting point speaks version " + std::to_string(kVersion) + ", and the site version " +
                  std::to_string(version) + ". fix: install the same release of telepalp at both");
  if (names_.empty())
    return refuse("the site's key has no host name, only addresses. fix: telepalp-keys server --host NAME");
  const std::string refusal = handlers_.on_join(shared_from_this());
  if (!refusal.empty()) return refuse(refusal);
  joined_ = true;
  msg::MeetToSite welcome;
  for (const std::string& name : names_) welcome.mutable_welcome()->add_names(name);
  send(welcome);
  if (handlers_.on_joined) handlers_.on_joined(*this);
}

/// The site reads the reason and hangs up; beat() closes the connection if it does not.
void SiteSession::refuse(const std::string& why) {
  msg::MeetToSite refusal;
  refusal.set_refused(why);
  send(refusal);
}

void SiteSession::call(const msg::MeetCall& call) {
  msg::MeetToSite message;
  *message.mutable_call() = call;
  send(message);
}

void SiteSession::tell(const msg::MeetRelay& relay) {
  msg::MeetToSite message;
  *message.mutable_relay() = relay;
  send(message);
}

void SiteSession::send(const msg::MeetToSite& message) {
  if (closed_) return;
  if (to_send_.size() >= kMostUnsent) return close("it does not take its calls");
  to_send_.push_back(framed(message));
  if (to_send_.size() == 1) write_next();
}

void SiteSession::write_next() {
  stream_.async_write(asio::buffer(to_send_.front()),
                      [self = shared_from_this()](const error_code& failed, std::size_t) {
                        if (self->closed_) return;
                        if (failed) return self->close(failed.message());
                        self->to_send_.pop_front();
                        if (!self->to_send_.empty()) self->write_next();
                      });
}

void SiteSession::beat() {
  const auto silent = std::chrono::steady_clock::now() - heard_;
  if (silent > kSilence) return close("nothing came from it for " + std::to_string(kSilence.count()) + " s");
  if (!joined_ && silent > kTimeToJoin) return close("it did not join");
  if (joined_) {
    msg::MeetToSite still_here;
    still_here.set_beat(true);
    send(still_here);
  }
  beat_.expires_after(joined_ ? kBeat : kTimeToJoin);
  beat_.async_wait([self = weak_from_this()](const error_code& cancelled) {
    const std::shared_ptr<SiteSession> alive = self.lock();
    if (!cancelled && alive && !alive->closed_) alive->beat();
  });
}

void SiteSession::close(const std::string& why) {
  if (std::exchange(closed_, true)) return;
  beat_.cancel();
  error_code ignored;
  stream_.socket().shutdown(tcp::socket::shutdown_both, ignored);
  stream_.socket().close(ignored);
  handlers_.on_end(*this, why);
}

}  // namespace telepalp::meet
