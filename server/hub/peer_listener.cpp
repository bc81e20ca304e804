#include "server/hub/peer_listener.h"

#include <algorithm>
#include <boost/asio/post.hpp>
#include <random>
#include <utility>
#include <vector>

#include "proto/keys/audit_text.h"
#include "proto/wire/sockets/tcp_socket.h"
#include "proto/words/counted.h"
#include "server/hub/peer.h"

namespace telepalp::hub {
namespace {

namespace asio = boost::asio;
using asio::ip::tcp;
using boost::system::error_code;

constexpr std::chrono::milliseconds kAcceptBackOff{100};

Error cannot_listen(const tcp::endpoint& endpoint, const error_code& code) {
  const std::string where = endpoint.address().to_string() + ":" + std::to_string(endpoint.port());
  if (code == asio::error::address_in_use)
    return {.what = "the port is in use",
            .where = where,
            .fix = "stop the program that listens there, or give another --port"};
  return {.what = "cannot listen: " + code.message(), .where = where, .fix = "give another --bind or --port"};
}

}  // namespace

Result<asio::ip::address> listening_address(const std::string& address, bool has_keys) {
  error_code code;
  const asio::ip::address parsed = asio::ip::make_address(address == "localhost" ? "127.0.0.1" : address, code);
  if (code)
    return Error{.what = "'" + address + "' is not an IP address",
                 .where = "--bind",
                 .fix = "give 127.0.0.1 for this machine alone, or 0.0.0.0 with --key"};
  if (!parsed.is_loopback() && !has_keys)
    return Error{.what = address + " is reachable from the network, and this server has no key to protect the patient",
                 .where = "--bind",
                 .fix =
                     "telepalp-keys authority --host HOST && telepalp-keys server --host HOST, with this server's name "
                     "or address, then add --key keys/server.key"};
  return parsed;
}

Result<std::unique_ptr<PeerListener>> PeerListener::listen(asio::io_context& io, Hub& hub,
                                                           const wire::SessionClock& clock, Options options) {
  const Result<asio::ip::address> address = listening_address(options.address, options.access->has_keys());
  if (!address) return address.error();
  const tcp::endpoint endpoint{*address, options.port};
  std::unique_ptr<PeerListener> listener(new PeerListener(io, hub, clock, std::move(options)));
  if (const error_code code = listener->open(endpoint)) return cannot_listen(endpoint, code);
  listener->accept();
  listener->let_idle_go_every_second();
  return listener;
}

PeerListener::PeerListener(asio::io_context& io, Hub& hub, const wire::SessionClock& clock, Options options)
    : io_(io),
      hub_(hub),
      clock_(clock),
      options_(std::move(options)),
      acceptor_(io),
      accept_again_(io),
      second_(io),
      datagrams_(std::make_unique<DatagramPort>(io)),
      site_(std::make_unique<const PeerSite>(site_for_peers())) {}

PeerListener::~PeerListener() = default;

PeerSite PeerListener::site_for_peers() {
  return {.io = io_,
          .hub = hub_,
          .datagrams = *datagrams_,
          .access = *options_.access,
          .server_name = options_.name,
          .no_stations = options_.no_stations,
          .places = options_.places,
          .idle = options_.idle,
          .now = [this] { return clock_.now(); },
          .taken = [this](PlaceKind kind) { return taken(kind); },
          .sender_number = [this](std::uint64_t run) { return sender_number(run); },
          .hand_over =
              [this](PeerNumber peer, const keys::Identity& who) {
                if (const auto before = peers_.find(peer); before != peers_.end()) before->second->give_touch_to(who);
              },
          .note = [this](const std::string& text) { note(text); },
          .note_refusal = [this](const std::string& text) { note_refusal(text); },
          .note_stranger_gone = [this](const std::string& happened,
                                       const std::string& reason) { note_stranger_gone(happened, reason); },
          .relays = options_.relays,
          .note_relay =
              [this](const Error& why) {
                if (said_of_relay_.is_new(to_string(why))) note(to_string(why));
              },
          .on_window =
              [this](const msg::WindowRequest& request) {
                if (options_.on_window) options_.on_window(request);
              },
          .on_invalid = [this] { ++counts_.invalid_messages; },
          .on_over_rate = [this] { ++counts_.over_rate; },
          .on_leaving =
              [this] {
                if (options_.on_leaving) options_.on_leaving();
              },
          .forget = [this](PeerNumber peer) { forget(peer); }};
}

/// Opens the TCP port, and the UDP port of the same number. For port 0 it takes a number that is free for both.
error_code PeerListener::open(const tcp::endpoint& endpoint) {
  constexpr int kAttempts = 8;
  for (int attempt = 0; attempt < kAttempts; ++attempt) {
    error_code failed;
    acceptor_.close(failed);
    if (failed = wire::open_acceptor(acceptor_, endpoint); failed) return failed;
    port_ = acceptor_.local_endpoint().port();
    if (failed = datagrams_->open({endpoint.address(), port_}); !failed) return {};
    if (endpoint.port() == 0 && attempt + 1 < kAttempts) continue;
    note("UDP port " + std::to_string(port_) + " cannot be opened (" + failed.message() +
         "): images go over TCP alone. fix: stop the program that uses this UDP port, or give another --port");
    return {};
  }
  return {};
}

DatagramCounts PeerListener::datagram_counts() const noexcept { return datagrams_->counts(); }

bool PeerListener::references_arrive() const noexcept {
  return std::ranges::all_of(peers_, [](const auto& peer) { return peer.second->references_arrive(); });
}

std::vector<PeerListener::PeerLine> PeerListener::lines() {
  std::vector<PeerLine> lines;
  for (const auto& [number, peer] : peers_)
    if (peer->subscriber() != 0 && peer->place())
      lines.push_back({.subscriber = peer->subscriber(),
                       .sender = peer->sender(),
                       .kind = *peer->place(),
                       .share_B_per_s = peer->share_B_per_s(),
                       .queue = peer->queue(),
                       .dropped = peer->dropped()});
  return lines;
}

void PeerListener::note_shares() {
  for (const auto& [number, peer] : peers_) peer->note_share();
}

void PeerListener::close(const std::string& reason) {
  error_code ignored;
  acceptor_.close(ignored);
  datagrams_->close();
  accept_again_.cancel();
  second_.cancel();
  for (const auto& [number, peer] : peers_) peer->close(reason);
}

void PeerListener::accept() {
  acceptor_.async_accept([this](const error_code& code, tcp::socket socket) {
    if (code == asio::error::operation_aborted || !acceptor_.is_open()) return;
    if (!code) {
      cannot_accept_ = false;
      admit(std::move(socket), Way::Port);
      return accept();
    }
    if (!std::exchange(cannot_accept_, true)) note_pause(code);
    // Probably no file descriptor is free; an immediate retry would waste the processor.
    accept_again_.expires_after(kAcceptBackOff);
    accept_again_.async_wait([this](const error_code& stopped) {
      if (!stopped) accept();
    });
  });
}

/// Called at the first failure to accept after a success, not at the failures that follow it.
void PeerListener::note_pause(const error_code& why) {
  const std::string text = "no connection can be accepted (" + why.message() +
                           "): accepting pauses, and the server tries again every 0.1 s"
                           ". fix: stop clients of this server, or restart it with a higher ulimit -n";
  options_.access->note(access::AuditEvent::Refused, std::nullopt, "why=" + keys::audit_text(text));
  note_refusal(text);
}

std::unique_ptr<wire::ByteStream> PeerListener::stream_over(tcp::socket socket) const {
  const access::Access& access = *options_.access;
  return access.has_keys() ? wire::tls_at_server(std::move(socket), access.tls()) : wire::plain_tcp(std::move(socket));
}

void PeerListener::admit(tcp::socket socket) { admit(std::move(socket), Way::MeetingPoint); }

void PeerListener::admit(tcp::socket socket, Way way) {
  ++counts_.accepted;
  const PeerNumber number = ++last_number_;
  const access::Unproven arrival = access::newcomer(socket);
  peers_.emplace(number, std::make_unique<Peer>(*site_, number, arrival, stream_over(std::move(socket)), way));
  if (taken(std::nullopt) > options_.places.strangers) let_a_stranger_go();
}

/// A peer that reconnects keeps its number. Two connected peers never have the same number, even if they state the same
/// run.
std::uint32_t PeerListener::sender_number(std::uint64_t run) const {
  const auto is_free = [this](std::uint32_t number) {
    return number != 0 && std::none_of(peers_.begin(), peers_.end(),
                                       [&](const auto& peer) { return peer.second->sender() == number; });
  };
  auto number = static_cast<std::uint32_t>(run ^ (run >> 32U));
  for (std::random_device random; !is_free(number);) number = random();
  return number;
}

void PeerListener::forget(PeerNumber number) {
  // The peer is on the call stack, so it is destroyed later.
  asio::post(io_, [this, number] { peers_.erase(number); });
}

std::size_t PeerListener::taken(std::optional<PlaceKind> kind) const {
  return static_cast<std::size_t>(
      std::count_if(peers_.begin(), peers_.end(), [&](const auto& peer) { return peer.second->place() == kind; }));
}

std::optional<PeerListener::PeerNumber> PeerListener::stranger_to_close() const {
  std::vector<PeerNumber> numbers;
  std::vector<access::Unproven> strangers;
  for (const auto& [number, peer] : peers_) {
    if (peer->place()) continue;
    numbers.push_back(number);
    strangers.push_back(peer->arrival());
  }
  const std::optional<std::size_t> index = access::one_to_close(strangers, std::chrono::steady_clock::now());
  return index ? std::optional(numbers[*index]) : std::nullopt;
}

/// Closes a connection of the network that holds most, so that one address cannot keep the others out.
void PeerListener::let_a_stranger_go() {
  const std::optional<PeerNumber> number = stranger_to_close();
  if (!number) return;
  const auto chosen = peers_.find(*number);
  const std::string text =
      "the connection from " + chosen->second->from() + " is closed: more than " +
      std::to_string(options_.places.strangers) +
      " connections have not sent their Hello message yet, the greeting of a telepalp program, and its network "
      "holds most of them";
  options_.access->note(access::AuditEvent::Refused, std::nullopt,
                        "from=" + chosen->second->from() + " why=" + keys::audit_text(text));
  note_refusal(text);
  peers_.erase(chosen);
}

void PeerListener::let_idle_go_every_second() {
  const auto now = std::chrono::steady_clock::now();
  options_.access->look_at_files();
  audit_refused_datagrams(now);
  for (const auto& [number, peer] : peers_) {
    peer->check_key();
    if (!peer->is_idle(now)) continue;
    ++counts_.let_go_idle;
    peer->close("this client subscribes to no topic and publishes nothing, so the server frees its place for others");
  }
  second_.expires_after(std::chrono::seconds(1));
  second_.async_wait([this](const error_code& stopped) {
    if (!stopped && acceptor_.is_open()) let_idle_go_every_second();
  });
}

/// One line at most each 10 s. Replayed datagrams are left out, because a network duplicates datagrams by itself.
void PeerListener::audit_refused_datagrams(std::chrono::steady_clock::time_point now) {
  constexpr std::chrono::seconds kQuiet{10};
  const DatagramCounts counts = datagrams_->counts();
  const std::uint64_t forged = counts.forged + counts.malformed - audited_.forged - audited_.malformed;
  const std::uint64_t strange = counts.strangers - audited_.strangers;
  if (forged + strange == 0 || now - datagrams_audited_ < kQuiet) return;
  datagrams_audited_ = now;
  audited_ = counts;
  options_.access->note(
      access::AuditEvent::Refused, std::nullopt,
      "why=" + keys::audit_text("datagrams were refused: " + std::to_string(strange) +
                                " with an unknown session number, " + std::to_string(forged) + " malformed or forged"));
}

/// Logs the first refusal at once and then at most one line in five seconds, so that many refusals do not fill the log.
void PeerListener::note_refusal(const std::string& text) {
  constexpr std::chrono::seconds kQuiet{5};
  ++counts_.refused;
  const auto now = std::chrono::steady_clock::now();
  if (refusal_noted_ != std::chrono::steady_clock::time_point{} && now - refusal_noted_ < kQuiet) return;
  refusal_noted_ = now;
  const std::uint64_t unsaid = counts_.refused - refused_when_noted_ - 1;
  refused_when_noted_ = counts_.refused;
  note(text + (unsaid == 0 ? ""
                           : " (and " + counted(unsaid, "other refusal", "other refusals") +
                                 " since the last logged refusal)"));
}

/// Logs the first such peer at once. While more of them go, logs their number once each five seconds.
void PeerListener::note_stranger_gone(const std::string& happened, const std::string& reason) {
  const Error never_joined{.what = "it had not joined", .where = {}, .fix = {}};
  if (const auto line =
          strangers_gone_.line(happened + " (" + reason + ")", never_joined, std::chrono::steady_clock::now()))
    note(*line);
}

void PeerListener::note(const std::string& text) const {
  if (options_.on_note) options_.on_note(text);
}

}  // namespace telepalp::hub
