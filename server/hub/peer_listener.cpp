#include "server/hub/peer_listener.h"

#include <boost/asio/post.hpp>
#include <utility>

#include "server/hub/upstream.h"

namespace telepalp::server {
namespace {

namespace asio = boost::asio;
using asio::ip::tcp;
using boost::system::error_code;

constexpr std::chrono::milliseconds kAcceptBackOff{100};

Error cannot_listen(const tcp::endpoint& endpoint, const error_code& code) {
  const std::string where = endpoint.address().to_string() + ":" + std::to_string(endpoint.port());
  if (code == asio::error::address_in_use)
    return {.what = "the port is in use", .where = where, .fix = "stop what listens there, or give another --port"};
  return {.what = "cannot listen: " + code.message(), .where = where, .fix = "give another --bind or --port"};
}

error_code open_acceptor(tcp::acceptor& acceptor, const tcp::endpoint& endpoint) {
  error_code code;
  acceptor.open(endpoint.protocol(), code);
  // A server that comes back at once finds its port still cooling down; SO_REUSEADDR does not let two listen.
  if (!code) acceptor.set_option(tcp::acceptor::reuse_address(true), code);
  if (!code) acceptor.bind(endpoint, code);
  if (!code) acceptor.listen(tcp::acceptor::max_listen_connections, code);
  return code;
}

}  // namespace

Result<asio::ip::address> loopback_address(const std::string& address) {
  error_code code;
  const asio::ip::address parsed = asio::ip::make_address(address == "localhost" ? "127.0.0.1" : address, code);
  if (code)
    return Error{.what = "'" + address + "' is not an address", .where = "--bind", .fix = "give 127.0.0.1 or ::1"};
  if (!parsed.is_loopback())
    return Error{.what = address + " is reachable from the network, and this server has no keys to protect the patient",
                 .where = "--bind",
                 .fix = "bind 127.0.0.1 or ::1, and carry it to the other site through a tunnel such as ssh -L"};
  return parsed;
}

/// One peer: its connection on one side, its place in the hub on the other.
class PeerListener::Peer : public wire::ConnectionOwner {
 public:
  Peer(PeerListener& listener, PeerNumber number, tcp::socket socket)
      : listener_(listener),
        number_(number),
        connection_(std::make_shared<wire::Connection>(
            wire::plain_tcp(std::move(socket)),
            wire::Connection::Options{.name = listener.options_.name,
                                      .role = "server",
                                      .publishes = {wire::kTopics.begin(), wire::kTopics.end()},
                                      .max_payload_bytes = kMaxUpstreamBytes},
            *this)) {
    connection_->start();
  }
  ~Peer() override {
    if (subscriber_) listener_.hub_.leave(subscriber_);
    connection_->abandon();
  }

  void close(const std::string& reason) { connection_->close(reason); }

 private:
  bool accepts(const wire::Topic& topic) override { return may_publish_upstream(topic); }

  void on_ready(const msg::Hello& peer) override {
    name_ = peer.name();
    subscriber_ = listener_.hub_.join(name_, connection_->peer(), [this] { connection_->wake(); });
    listener_.note(name_ + " (" + peer.role() + ") joined from " + connection_->peer());
  }
  void on_subscribe(std::vector<std::string> topics) override { listener_.hub_.subscribe(subscriber_, topics); }
  void on_message(wire::Message message) override {
    if (is_valid_upstream(message)) return listener_.hub_.publish(std::move(message));
    ++listener_.counts_.invalid_messages;
  }
  void on_want_key(const wire::Topic& topic, SessionTime published) override {
    listener_.hub_.want_key(subscriber_, topic, published);
  }
  void on_clock(const wire::ClockSample&) override {}  // a server's clock is the session's: it asks nobody
  void on_closed(const std::string& reason) override {
    leave_hub();
    listener_.note((name_.empty() ? "a stranger" : name_) + " at " + connection_->peer() + " left: " + reason);
    listener_.forget(number_);
  }
  std::optional<wire::Message> next_to_send() override { return listener_.hub_.next(subscriber_); }
  SessionTime session_now() override { return listener_.clock_.now(); }

  void leave_hub() {
    if (!subscriber_) return;
    if (listener_.options_.on_leaving) listener_.options_.on_leaving();
    listener_.hub_.leave(std::exchange(subscriber_, 0));
  }

  PeerListener& listener_;
  PeerNumber number_;
  std::string name_;
  SubscriberId subscriber_ = 0;                   // 0: not in the hub
  std::shared_ptr<wire::Connection> connection_;  // shared with its pending operations
};

Result<std::unique_ptr<PeerListener>> PeerListener::listen(asio::io_context& io, Hub& hub,
                                                           const wire::SessionClock& clock, Options options) {
  const Result<asio::ip::address> address = loopback_address(options.address);
  if (!address) return address.error();
  const tcp::endpoint endpoint{*address, options.port};
  std::unique_ptr<PeerListener> listener(new PeerListener(io, hub, clock, std::move(options)));
  if (const error_code code = open_acceptor(listener->acceptor_, endpoint)) return cannot_listen(endpoint, code);
  listener->port_ = listener->acceptor_.local_endpoint().port();
  listener->accept();
  return listener;
}

PeerListener::PeerListener(asio::io_context& io, Hub& hub, const wire::SessionClock& clock, Options options)
    : io_(io), hub_(hub), clock_(clock), options_(std::move(options)), acceptor_(io), accept_again_(io) {}

PeerListener::~PeerListener() = default;

void PeerListener::close(const std::string& reason) {
  error_code ignored;
  acceptor_.close(ignored);
  accept_again_.cancel();
  for (const auto& [number, peer] : peers_) peer->close(reason);
}

void PeerListener::accept() {
  acceptor_.async_accept([this](const error_code& code, tcp::socket socket) {
    if (code == asio::error::operation_aborted || !acceptor_.is_open()) return;
    if (!code) {
      admit(std::move(socket));
      return accept();
    }
    // Out of descriptors, most likely: trying at once would only burn the processor.
    accept_again_.expires_after(kAcceptBackOff);
    accept_again_.async_wait([this](const error_code& stopped) {
      if (!stopped) accept();
    });
  });
}

void PeerListener::admit(tcp::socket socket) {
  if (peers_.size() >= options_.max_peers) {
    ++counts_.refused;
    return;  // the socket closes
  }
  ++counts_.accepted;
  const PeerNumber number = ++last_number_;
  peers_.emplace(number, std::make_unique<Peer>(*this, number, std::move(socket)));
}

void PeerListener::forget(PeerNumber number) {
  // Later, for the peer is on the call stack.
  asio::post(io_, [this, number] { peers_.erase(number); });
}

void PeerListener::note(const std::string& text) const {
  if (options_.on_note) options_.on_note(text);
}

}  // namespace telepalp::server
