#include "server/meet/meet.h"

#include <malloc.h>
#include <openssl/x509.h>

#include <algorithm>
#include <array>
#include <boost/asio/write.hpp>
#include <iterator>
#include <utility>
#include <vector>

#include "proto/wire/sockets/tcp_socket.h"
#include "proto/words/counted.h"
#include "server/meet/caller/splice.h"
#include "server/meet/site/site_session.h"

namespace telepalp::meet {
namespace {

namespace asio = boost::asio;
using asio::ip::tcp;
using boost::system::error_code;

constexpr std::chrono::seconds kTimeToShow{5};                         // until a connection must have shown what it is
constexpr unsigned char kInternalError = 80, kUnrecognizedName = 112;  // alerts of RFC 8446 §6

/// The settings of a TLS server, but each peer must show a server's certificate, because a site is a server.
Result<wire::TlsSettings> tls_for_sites(const keys::KeyFile& key, keys::IsRevoked is_revoked) {
  Result<wire::TlsSettings> tls = wire::tls_settings(keys::server_context(key, std::move(is_revoked)));
  if (!tls) return tls;
  SSL_CTX* const context = (*tls)->native_handle();
  SSL_CTX_set_mode(context, SSL_MODE_RELEASE_BUFFERS);  // most sites are silent most of the time
  SSL_CTX_set_purpose(context, X509_PURPOSE_SSL_SERVER);
  SSL_CTX_set_verify(context, SSL_VERIFY_PEER | SSL_VERIFY_FAIL_IF_NO_PEER_CERT, SSL_CTX_get_verify_callback(context));
  return tls;
}

bool is_own_name(const std::vector<std::string>& hosts, const std::string& name) {
  return name.empty() || std::ranges::find(hosts, name) != hosts.end();
}

}  // namespace

Result<std::unique_ptr<Meet>> Meet::listen(asio::io_context& io, Options options) {
  Result<wire::TlsSettings> tls = tls_for_sites(options.key, options.is_revoked);
  if (!tls) return tls.error();
  const std::string where = options.address + ":" + std::to_string(options.port);
  std::unique_ptr<Meet> meet(new Meet(io, std::move(options), std::move(tls).value()));
  error_code failed;
  const asio::ip::address address = asio::ip::make_address(meet->options_.address, failed);
  if (!failed) failed = wire::open_acceptor(meet->acceptor_, {address, meet->options_.port});
  if (failed)
    return Error{.what = "cannot listen: " + failed.message(),
                 .where = where,
                 .fix =
                     "stop the program that listens there, give another --port or --bind; a port below 1024 needs "
                     "the right to it (setcap cap_net_bind_service=ep, or the service unit)"};
  meet->port_ = meet->acceptor_.local_endpoint().port();
  meet->accept();
  meet->look_after_all();
  return meet;
}

Meet::Meet(asio::io_context& io, Options options, wire::TlsSettings tls)
    : options_(std::move(options)),
      tls_(std::move(tls)),
      acceptor_(io),
      again_(io),
      second_(io),
      calls_(options_.limits.calls, [this](tcp::socket caller) { refuse(std::move(caller), kInternalError); }) {}

Meet::~Meet() { close(); }

void Meet::close() {
  error_code ignored;
  acceptor_.close(ignored);
  again_.cancel();
  second_.cancel();
  for (const std::shared_ptr<Arrival>& arrival : std::exchange(arrivals_, {})) arrival->close();
  calls_.clear();
  for (const std::shared_ptr<SiteSession>& site : std::exchange(joining_, {})) site->close("the meeting point ends");
  for (const auto& [serial, site] : std::exchange(sites_, {})) site->close("the meeting point ends");
}

void Meet::accept() {
  acceptor_.async_accept(alive_.guard([this](const error_code& failed, tcp::socket socket) {
    if (failed == asio::error::operation_aborted) return;
    if (!failed) {
      admit(std::move(socket));
      return accept();
    }
    again_.expires_after(std::chrono::milliseconds(100));  // probably no file descriptor is free
    again_.async_wait(alive_.guard([this](const error_code& cancelled) {
      if (!cancelled) accept();
    }));
  }));
}

void Meet::admit(tcp::socket socket) {
  const access::Unproven who = access::newcomer(socket);
  // shared_ptr: its pending read owns it, too
  const auto arrival = std::make_shared<Arrival>(std::move(socket), who);
  arrivals_.push_back(arrival);
  arrival->start([this, weak = std::weak_ptr(arrival)](const Arrived& what, tcp::socket known, std::string bytes) {
    arrivals_.remove(weak.lock());
    arrived(what, std::move(known), std::move(bytes));
  });
  if (const auto closed = surplus(arrivals_, options_.limits.arrivals)) closed->close();
}

/// Takes the connection out of `waiting` that must be closed because more than `most` wait: one of the network that
/// holds the most, so that one address cannot keep the others out. Null: there is room.
template <class List>
typename List::value_type Meet::surplus(List& waiting, std::size_t most) {
  if (waiting.size() <= most) return nullptr;
  std::vector<access::Unproven> all;
  for (const auto& one : waiting) all.push_back(one->who());
  const std::optional<std::size_t> chosen = access::one_to_close(all, std::chrono::steady_clock::now());
  const auto at = std::next(waiting.begin(), static_cast<std::ptrdiff_t>(chosen.value_or(0)));
  const auto closed = *at;
  waiting.erase(at);
  ++counts_.refused;
  return closed;
}

void Meet::arrived(const Arrived& what, tcp::socket socket, std::string bytes) {
  if (const auto* answer = std::get_if<AnswerToCall>(&what)) {
    if (calls_.answered(answer->token, std::move(socket))) ++counts_.calls;
    return;  // else the caller has gone, or the token is a stranger's guess
  }
  if (std::holds_alternative<WantsRelay>(what)) return pass_to_relay(std::move(socket), std::move(bytes));
  const auto& hello = std::get<ClientHello>(what);
  if (is_own_name(options_.key.hosts, hello.server_name)) return site_comes(std::move(socket), std::move(bytes));
  caller_comes(hello, std::move(socket), std::move(bytes));
}

void Meet::site_comes(tcp::socket socket, std::string hello) {
  const auto site = std::make_shared<SiteSession>(
      std::move(socket), std::move(hello), tls_,
      SiteSession::Handlers{.on_join = [this](const std::shared_ptr<SiteSession>& joined) { return join(joined); },
                            .on_joined = [this](SiteSession& joined) { tell_relay(joined); },
                            .on_decline = [this](const std::string& token) { calls_.declined(token); },
                            .on_end = [this](SiteSession& ended, const std::string& why) { leave(ended, why); }});
  joining_.push_back(site);
  if (const auto closed = surplus(joining_, options_.limits.joining))
    closed->close("too many connections wait to join");
  site->start();  // does nothing if this connection is the one that was closed
}

/// Lets `site` in. Returns why it is refused; empty: it is in. A site that comes again with the certificate that it
/// has shown replaces its older connection: the meeting point may not have noticed that the older one is dead.
std::string Meet::join(const std::shared_ptr<SiteSession>& site) {
  for (const std::string& name : site->names()) {
    const auto taken = serials_.find(name);
    if (taken != serials_.end() && taken->second != site->serial())
      return "another key holds the name " + name + " here (serial " + taken->second +
             "). fix: stop the server that uses it, or make a key with another --host";
  }
  if (const auto before = sites_.find(site->serial()); before != sites_.end()) before->second->close("it came again");
  if (sites_.size() >= options_.limits.sites) return "the meeting point is full: it takes no further site";
  joining_.remove(site);
  sites_[site->serial()] = site;
  for (const std::string& name : site->names()) serials_[name] = site->serial();
  options_.log("the site " + site->names().front() + " joined from " + site->peer());
  if (site->has_moved()) end_streams(*site);
  return {};
}

/// Ends the streams that went by an address which the site has lost, so that their callers call again at once.
/// Otherwise they would notice the silence only after seconds.
void Meet::end_streams(const SiteSession& site) {
  options_.log("the address of the site " + site.names().front() +
               " has changed: " + counted(calls_.end_streams(site.serial()), "stream ends", "streams end"));
}

void Meet::leave(SiteSession& site, const std::string& why) {
  joining_.remove_if([&](const std::shared_ptr<SiteSession>& one) { return one.get() == &site; });
  const auto found = sites_.find(site.serial());
  if (found == sites_.end() || found->second.get() != &site) return;
  options_.log("the site " + site.names().front() + " left: " + why);
  std::erase_if(serials_, [&](const auto& name) { return name.second == site.serial(); });
  sites_.erase(found);
}

void Meet::caller_comes(const ClientHello& hello, tcp::socket socket, std::string bytes) {
  const auto serial = serials_.find(hello.server_name);
  if (serial == serials_.end()) return refuse(std::move(socket), kUnrecognizedName);
  msg::MeetCall call;
  call.set_browser(hello.speaks_http);
  call.set_from(wire::peer_address(socket));
  const std::optional<std::string> token = calls_.add(serial->second, std::move(socket), std::move(bytes));
  if (!token) return;
  call.set_token(*token);
  const std::shared_ptr<SiteSession> session = sites_.at(serial->second);  // call() may close it, which removes it
  session->call(call);
}

/// Answers a ClientHello by a fatal alert, so that the caller's program can say what happened.
void Meet::refuse(tcp::socket socket, unsigned char alert) {
  ++counts_.refused;
  const std::array<unsigned char, 7> record{21, 3, 3, 0, 2, 2, alert};
  error_code failed;
  socket.non_blocking(true, failed);
  if (!failed) socket.write_some(asio::buffer(record), failed);
  if (!failed) wire::close_gently(std::move(socket));
}

/// The relay checks credentials itself, so that whoever has none gets nothing of it.
void Meet::pass_to_relay(tcp::socket socket, std::string bytes) {
  if (options_.relay.address.empty() || *relayed_ >= options_.limits.relayed) {
    ++counts_.refused;
    return;
  }
  ++counts_.relayed;
  ++*relayed_;
  // shared_ptr: the pending operation owns it
  const auto relay = std::make_shared<tcp::socket>(socket.get_executor());
  relay->async_connect({asio::ip::make_address(options_.relay.address), options_.relay.port},
                       [relay, caller = std::make_shared<tcp::socket>(std::move(socket)), bytes = std::move(bytes),
                        all = relayed_](const error_code& failed) mutable {
                         if (failed) return static_cast<void>(--*all);
                         splice(std::move(*caller), std::move(bytes), std::move(*relay), [all] { --*all; });
                       });
}

void Meet::tell_relay(SiteSession& site) const {
  if (options_.relay.address.empty()) return;
  site.tell(credentials(options_.relay, site.serial(), port_, std::chrono::system_clock::now()));
}

void Meet::renew_credentials() {
  const auto now = std::chrono::steady_clock::now();
  if (now - renewed_ < kCredentialsRenewed) return;
  renewed_ = now;
  std::vector<std::shared_ptr<SiteSession>> told;  // tell() may close a session, which removes its site
  for (const auto& [serial, site] : sites_) told.push_back(site);
  for (const std::shared_ptr<SiteSession>& site : told) tell_relay(*site);
}

/// Gives the memory that TLS handshakes have used back to the system, because the C library would keep it.
void Meet::give_memory_back() {
  if (std::exchange(trimmed_at_, sites_.size()) != sites_.size()) malloc_trim(0);
}

void Meet::look_after_all() {
  give_memory_back();
  renew_credentials();
  const auto now = std::chrono::steady_clock::now();
  while (!arrivals_.empty() && now - arrivals_.front()->who().since > kTimeToShow) {
    arrivals_.front()->close();
    arrivals_.pop_front();
  }
  calls_.refuse_late(now);
  second_.expires_after(std::chrono::seconds(1));
  second_.async_wait(alive_.guard([this](const error_code& cancelled) {
    if (!cancelled) look_after_all();
  }));
}

}  // namespace telepalp::meet
